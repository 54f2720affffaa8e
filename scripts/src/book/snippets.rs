//! Code in chapters comes from the kit's own sources, and never shows an answer.

use std::fs;
use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result};

use crate::kit::Kit;
use crate::marks::{self, MarkError, Part};

/// Looks at every include of every chapter.
///
/// # Errors
/// A chapter cannot be read. What is wrong with it is returned, a line each.
pub(super) fn check(kit: &Kit) -> Result<Vec<String>> {
    let mut wrong = Vec::new();
    for page in pages(kit)? {
        let text =
            fs::read_to_string(&page).with_context(|| format!("cannot read {}", page.display()))?;
        for (number, line) in text.lines().enumerate() {
            for include in includes(line) {
                if let Err(why) = check_include(&page, include) {
                    let name = page.strip_prefix(kit.root()).unwrap_or(&page);
                    wrong.push(format!("{}:{}: {include}: {why}", name.display(), number + 1));
                }
            }
        }
    }
    Ok(wrong)
}

/// The chapters' files, those in folders too.
fn pages(kit: &Kit) -> Result<Vec<PathBuf>> {
    let mut folders = vec![kit.path("book/src")];
    let mut pages = Vec::new();
    while let Some(folder) = folders.pop() {
        let files =
            fs::read_dir(&folder).with_context(|| format!("cannot read {}", folder.display()))?;
        for file in files {
            let path = file?.path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|e| e == "md") {
                pages.push(path);
            }
        }
    }
    pages.sort();
    Ok(pages)
}

/// What a line includes: `path`, `path:anchor` or `path:first:last`.
fn includes(line: &str) -> impl Iterator<Item = &str> {
    line.split("{{#").skip(1).filter_map(|marker| {
        let (name, rest) = marker.split_once(char::is_whitespace)?;
        ["include", "rustdoc_include", "playground"].contains(&name).then_some(())?;
        Some(rest.split_once("}}")?.0.trim())
    })
}

fn check_include(page: &Path, include: &str) -> Result<(), String> {
    let (path, part) = include.split_once(':').unwrap_or((include, ""));
    let folder = page.parent().expect("a page lies in a folder");
    let source = fs::read_to_string(folder.join(path)).map_err(|e| e.to_string())?;
    let lines: Vec<&str> = source.lines().collect();
    let Some(shown) = shown(&lines, part) else {
        return Err(format!("there is no anchor '{part}'"));
    };
    if Path::new(path).extension().is_none_or(|e| e != "rs") {
        return Ok(());
    }
    match answer_within(Path::new(path), &source, &shown).map_err(|e| e.to_string())? {
        None => Ok(()),
        Some(answer) => {
            Err(format!("it shows the answer in lines {} to {}", answer.start(), answer.end()))
        }
    }
}

/// The lines, counted from 1, that mdBook would show.
fn shown(lines: &[&str], part: &str) -> Option<RangeInclusive<usize>> {
    let mut numbers = part.split(':');
    match (numbers.next().unwrap_or_default(), numbers.next()) {
        ("", None) => Some(1..=lines.len()),
        (first, last) if first.is_empty() || first.parse::<usize>().is_ok() => {
            let first = first.parse().unwrap_or(1);
            Some(first..=last.map_or(first, |last| last.parse().unwrap_or(lines.len())))
        }
        (anchor, _) => {
            let find = |key: &str| lines.iter().position(|l| is_anchor(l, key, anchor));
            Some(find("ANCHOR:")? + 1..=find("ANCHOR_END:")? + 1)
        }
    }
}

/// The text that an include of `part` of a file shows, without anchors; none if it would show an
/// answer.
///
/// # Errors
/// The file cannot be read, or has no such part.
pub(crate) fn excerpt(file: &Path, part: &str) -> Result<Option<String>> {
    let unread = || format!("cannot read {}", file.display());
    let source = fs::read_to_string(file).with_context(unread)?;
    let lines: Vec<&str> = source.lines().collect();
    let range = shown(&lines, part).with_context(|| format!("there is no anchor '{part}'"))?;
    let is_rust = file.extension().is_some_and(|e| e == "rs");
    if is_rust && answer_within(file, &source, &range)?.is_some() {
        return Ok(None);
    }
    let last = (*range.end()).min(lines.len());
    let kept = lines[range.start() - 1..last].iter().filter(|line| !line.contains("ANCHOR"));
    Ok(Some(kept.flat_map(|line| [*line, "\n"]).collect()))
}

fn is_anchor(line: &str, key: &str, anchor: &str) -> bool {
    let Some((before, after)) = line.split_once(key) else { return false };
    !before.ends_with('_') && after.split_whitespace().next() == Some(anchor)
}

/// The first answer that these lines show something of.
fn answer_within(
    file: &Path,
    source: &str,
    shown: &RangeInclusive<usize>,
) -> Result<Option<RangeInclusive<usize>>, MarkError> {
    let mut answers = answers(file, source)?.into_iter();
    Ok(answers.find(|a| a.start() <= shown.end() && shown.start() <= a.end()))
}

/// The lines, marks included, of answers and of what only answers need.
fn answers(file: &Path, source: &str) -> Result<Vec<RangeInclusive<usize>>, MarkError> {
    let mut answers = Vec::new();
    let mut line = 1;
    for part in marks::parse(file, source)?.parts {
        let (text, marks) = match &part {
            Part::Given(text) => (text, 0),
            Part::Answer(region) => (&region.body, 2),
            Part::AnswerOnly(text) => (text, 2),
        };
        let next = line + text.lines().count() + marks;
        if marks > 0 {
            answers.push(line..=next - 1);
        }
        line = next;
    }
    Ok(answers)
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::{check, includes};
    use crate::kit::Kit;

    const SOURCE: &str = "\
// ANCHOR: given
fn given() {}
// ANCHOR_END: given
// ANCHOR: whole
fn answer() {
    // task 1.1: the answer
    42
    // end 1.1
}
// ANCHOR_END: whole
// answer only
fn helper() {}
// end answer only
";

    fn faults(chapter: &str) -> Vec<String> {
        let kit = tempfile::tempdir().unwrap();
        fs::create_dir_all(kit.path().join("book/src")).unwrap();
        fs::write(kit.path().join("book/src/lab.rs"), SOURCE).unwrap();
        fs::write(kit.path().join("book/src/lab1.md"), chapter).unwrap();
        check(&Kit::at(kit.path())).unwrap()
    }

    #[test]
    fn given_code_may_be_shown() {
        assert!(faults("{{#include lab.rs:given}}").is_empty());
        assert!(faults("{{#include lab.rs:1:3}}").is_empty());
    }

    #[test]
    fn answers_may_not() {
        for part in ["", ":whole", ":5:6", ":8", ":12", ":7:"] {
            let faults = faults(&format!("text\n{{{{#include lab.rs{part}}}}}"));
            assert_eq!(faults.len(), 1, "lab.rs{part}: {faults:?}");
            assert!(
                faults[0].starts_with("book/src/lab1.md:2: ") && faults[0].contains("answer"),
                "{faults:?}"
            );
        }
    }

    #[test]
    fn pages_in_folders_are_looked_at() {
        let kit = tempfile::tempdir().unwrap();
        let folder = kit.path().join("book/src/instructor");
        fs::create_dir_all(&folder).unwrap();
        fs::write(folder.join("answers.rs"), SOURCE).unwrap();
        fs::write(folder.join("page.md"), "{{#include answers.rs:whole}}").unwrap();
        let faults = check(&Kit::at(kit.path())).unwrap();
        assert!(faults[0].starts_with("book/src/instructor/page.md:1: "), "{faults:?}");
    }

    #[test]
    fn an_anchor_must_exist() {
        assert!(faults("{{#include lab.rs:gone}}")[0].contains("no anchor 'gone'"));
        assert_eq!(faults("{{#include gone.rs}}").len(), 1);
    }

    #[test]
    fn only_includes_count() {
        assert_eq!(includes("{{#hints 1}} {{#include a:b}}").collect::<Vec<_>>(), ["a:b"]);
    }
}
