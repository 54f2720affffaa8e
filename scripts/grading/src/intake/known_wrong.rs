//! The kit's known-wrong solutions as submissions: `cargo lab grade tests/wrong/lab2 --lab 2`.
//!
//! Each is the solution with one answer replaced. It must lose the marks of its task and of those
//! that its manifest names, and no others: what a probe misses, or blames on the wrong task, shows
//! here.

use std::collections::BTreeSet;
use std::path::Path;

use anyhow::Result;

use crate::record::{Record, Status};
use lab_kit::wrong::{self, Wrong};
use lab_kit::{Kit, Lab};

/// The known-wrong solution that lies at `path`, if one does.
pub(crate) fn at(kit: &Kit, lab: Lab, path: &Path) -> Result<Option<Wrong>> {
    let whole = |path: &Path| path.canonicalize().ok();
    let folder = whole(&kit.path(format!("tests/wrong/lab{lab}")));
    let inside = whole(path).is_some_and(|path| path.parent() == folder.as_deref());
    if folder.is_none() || !inside || path.is_symlink() {
        return Ok(None);
    }
    let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    Ok(wrong::read(kit, lab)?.into_iter().find(|wrong| wrong.name == name))
}

/// Where the marks differ from what the manifest says, if they do.
pub(crate) fn complaint(wrong: &Wrong, record: &Record) -> Option<String> {
    if record.status != Status::Graded {
        return Some(format!("WRONG MARKS: it must be graded: {}", record.message));
    }
    let must = [wrong.region.task].into_iter().chain(wrong.loses.iter().copied());
    let must: BTreeSet<String> = must.map(|task| task.to_string()).collect();
    let lost: BTreeSet<String> =
        record.tasks.iter().filter(|task| !task.passed).map(|task| task.id.clone()).collect();
    let list = |tasks: &BTreeSet<String>| tasks.iter().cloned().collect::<Vec<_>>().join(", ");
    (must != lost).then(|| format!("WRONG MARKS: its manifest says {}", list(&must)))
}

#[cfg(test)]
mod tests {
    use super::at;
    use lab_kit::Kit;

    #[test]
    fn what_lies_among_the_known_wrong_is_one_of_them() {
        let kit = Kit::find().unwrap();
        let lab = "2".parse().unwrap();
        let path = kit.path("tests/wrong/lab2/missing_corners.rs");
        assert_eq!(at(&kit, lab, &path).unwrap().unwrap().name, "missing_corners");
        assert_eq!(at(&kit, lab, &kit.path("tests/lab2.rs")).unwrap(), None);
    }
}
