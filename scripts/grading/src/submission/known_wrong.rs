//! Known-wrong programs of the kit as submissions: `cargo lab grade tests/wrong/lab2.md --lab 2`.
//!
//! Each program is the solution with one answer replaced. It must lose exactly the marks of its
//! task and of the tasks that its section names. Otherwise a question misses a mistake or blames
//! the wrong task. The unusual right programs of `tests/right` must lose no marks.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use anyhow::Result;

use crate::record::{Record, Status};
use lab_kit::wrong::{self, Wrong};
use lab_kit::{Kit, Lab};

/// Lists the programs on the kit's page at `path`, as paths `PAGE/NAME`; empty for other files.
pub(crate) fn on_page(kit: &Kit, path: &Path) -> Result<Vec<PathBuf>> {
    let Some((_, programs)) = page_at(kit, path)? else { return Ok(Vec::new()) };
    Ok(programs.into_iter().map(|wrong| path.join(wrong.name)).collect())
}

/// Finds the known-wrong program of `lab` with this path.
pub(crate) fn at(kit: &Kit, lab: Lab, path: &Path) -> Result<Option<Wrong>> {
    let Some(page) = path.parent() else { return Ok(None) };
    let Some((_, programs)) = page_at(kit, page)?.filter(|(of, _)| *of == lab) else {
        return Ok(None);
    };
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    Ok(programs.into_iter().find(|wrong| wrong.name == name))
}

/// Returns the lab and the programs of the kit's page at `path`.
///
/// A symbolic link to the page is not followed, because a student may have submitted the link.
fn page_at(kit: &Kit, path: &Path) -> Result<Option<(Lab, Vec<Wrong>)>> {
    let lab = path.file_name().and_then(|name| name.to_str()?.strip_prefix("lab"));
    let lab = lab.and_then(|lab| lab.strip_suffix(".md")?.parse().ok());
    let (Some(lab), false) = (lab, path.is_symlink()) else { return Ok(None) };
    Ok(if is_same(path, &kit.path(wrong::page(lab))) {
        Some((lab, wrong::read(kit, lab)?))
    } else if is_same(path, &kit.path(wrong::right_page(lab))) {
        Some((lab, wrong::read_right(kit, lab)?))
    } else {
        None
    })
}

/// Whether both paths lead to the same existing file.
fn is_same(one: &Path, other: &Path) -> bool {
    one.canonicalize().is_ok_and(|one| other.canonicalize().is_ok_and(|other| one == other))
}

/// Describes how the marks differ from the manifest's; `None` if they are equal.
pub(crate) fn complaint(wrong: &Wrong, record: &Record) -> Option<String> {
    if record.found.status != Status::Graded {
        return Some(format!("WRONG MARKS: it must be graded: {}", record.found.message));
    }
    let own = (!wrong.fails.is_empty()).then_some(wrong.region.task);
    let must = own.into_iter().chain(wrong.loses.iter().copied());
    let must: BTreeSet<String> = must.map(|task| task.to_string()).collect();
    let lost: BTreeSet<String> =
        record.tasks.iter().filter(|task| !task.passed).map(|task| task.id.clone()).collect();
    if must == lost {
        return None;
    }
    let listed = must.into_iter().collect::<Vec<_>>().join(", ");
    let says = if listed.is_empty() { "that it loses none" } else { &listed };
    Some(format!("WRONG MARKS: its section says {says}"))
}

#[cfg(test)]
mod tests {
    use super::{at, on_page};
    use lab_kit::Kit;

    #[test]
    fn a_page_holds_known_wrong_programs() {
        let kit = Kit::find().unwrap();
        let lab = "2".parse().unwrap();
        let all = on_page(&kit, &kit.path("tests/wrong/lab2.md")).unwrap();
        assert!(all.len() >= 15);
        let name = all[0].file_name().unwrap().to_string_lossy();
        assert_eq!(at(&kit, lab, &all[0]).unwrap().unwrap().name, name);
        assert_eq!(at(&kit, lab, &kit.path("tests/lab2.rs")).unwrap(), None);
        let right = on_page(&kit, &kit.path("tests/right/lab6.md")).unwrap();
        let first = at(&kit, "6".parse().unwrap(), &right[0]).unwrap().unwrap();
        assert!(first.fails.is_empty() && !first.passes.is_empty());
        assert_eq!(
            on_page(&kit, &kit.path("tests/mutants.md")).unwrap(),
            [""; 0].map(Into::<std::path::PathBuf>::into)
        );
    }
}
