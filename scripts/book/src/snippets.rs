//! Checks that code in chapters comes from the kit's sources, and that it never shows an answer.

use anyhow::Result;

use lab_kit::Kit;
use lab_kit::excerpt::excerpt;

use crate::pages::pages;

/// Checks every include of every chapter. Returns the faults, one per line.
pub(crate) fn check(kit: &Kit) -> Result<Vec<String>> {
    let mut wrong = Vec::new();
    for (page, text) in pages(kit)? {
        for (number, line) in (1..).zip(text.lines()) {
            for include in includes(line) {
                let (path, part) = include.split_once(':').unwrap_or((include, ""));
                if let Err(why) = excerpt(&kit.path(&page).with_file_name(path), part) {
                    wrong.push(format!("{page}:{number}: {include}: {why:#}"));
                }
            }
        }
    }
    Ok(wrong)
}

/// Returns the files that a line includes: `path`, `path:anchor` or `path:first:last`.
fn includes(line: &str) -> impl Iterator<Item = &str> {
    line.split("{{#").skip(1).filter_map(|marker| {
        let (name, rest) = marker.split_once(char::is_whitespace)?;
        (name == "include").then_some(rest.split_once("}}")?.0.trim())
    })
}

#[cfg(test)]
mod tests {
    use super::{check, includes};
    use lab_kit::Kit;

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
        let folder = tempfile::tempdir().unwrap();
        let files = [("book/src/lab.rs", SOURCE), ("book/src/lab1.md", chapter)];
        check(&Kit::of_files(folder.path(), &files)).unwrap()
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
            assert!(faults[0].starts_with("book/src/lab1.md:2: "), "{faults:?}");
            assert!(faults[0].contains("answer"), "{faults:?}");
        }
    }

    #[test]
    fn pages_in_folders_are_looked_at() {
        let folder = tempfile::tempdir().unwrap();
        let page = ("book/src/instructor/page.md", "{{#include answers.rs:whole}}");
        let files = [("book/src/instructor/answers.rs", SOURCE), page];
        let faults = check(&Kit::of_files(folder.path(), &files)).unwrap();
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
