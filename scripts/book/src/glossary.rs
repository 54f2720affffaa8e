//! Checks that each word of the glossary occurs in the section that the glossary names.
//!
//! A row of `glossary.md` is `| words | definition | [Section](page.md#anchor) |`. Words with the
//! same meaning are separated by commas. Each word must be in one of the row's sections, and each
//! section must have one of the words.

use std::collections::BTreeMap;

use anyhow::{Context, Result};

use lab_kit::Kit;

use crate::pages::{Table, pages, section, tables};

const GLOSSARY: &str = "book/src/glossary.md";

/// Checks every row of the glossary. Returns the faults, one per line.
pub(crate) fn check(kit: &Kit) -> Result<Vec<String>> {
    let pages = pages(kit)?;
    let Some(glossary) = pages.get(GLOSSARY) else { return Ok(Vec::new()) };
    let mut wrong = Vec::new();
    for Table { line, rows, .. } in tables(glossary) {
        for (row, number) in rows.iter().zip(line..).skip(2) {
            let [words, _, sections] = row[..] else { continue };
            let faults = faults(&pages, words, sections);
            wrong.extend(faults.into_iter().map(|why| format!("{GLOSSARY}:{number}: {why}")));
        }
    }
    Ok(wrong)
}

fn faults(pages: &BTreeMap<String, String>, words: &str, sections: &str) -> Vec<String> {
    let words: Vec<String> = plain(&without_brackets(words)).split(", ").map(Into::into).collect();
    let links = sections.split("](").skip(1).filter_map(|rest| rest.split(')').next());
    let mut texts = Vec::new();
    let mut wrong = Vec::new();
    for link in links {
        match text_of(pages, link) {
            Ok(text) => {
                if !words.iter().any(|word| text.contains(word)) {
                    wrong.push(format!("{link} has none of '{}'", words.join(", ")));
                }
                texts.push(text);
            }
            Err(e) => wrong.push(e.to_string()),
        }
    }
    let missing = words.iter().filter(|word| !texts.iter().any(|text| text.contains(*word)));
    wrong.extend(missing.map(|word| format!("'{word}' is not in {sections}")));
    wrong
}

/// Returns the plain text of a section with its heading, or of a whole page if the link has no
/// `#anchor`.
fn text_of(pages: &BTreeMap<String, String>, link: &str) -> Result<String> {
    let (page, anchor) = link.split_once('#').unwrap_or((link, ""));
    let text = pages.get(&format!("book/src/{page}")).with_context(|| format!("no {page}"))?;
    Ok(plain(&section(text, anchor).with_context(|| format!("no section {link}"))?))
}

/// Returns the text in lower case and in one line, without marks of emphasis.
fn plain(text: &str) -> String {
    let text: String = text.chars().filter(|c| !"*`".contains(*c)).collect();
    text.split_whitespace().collect::<Vec<_>>().join(" ").to_lowercase()
}

/// Removes parts in brackets: `order (of a method)` becomes `order`.
fn without_brackets(text: &str) -> String {
    let mut parts = text.split(" (");
    let first = parts.next().unwrap_or_default().to_owned();
    parts.fold(first, |out, part| out + part.split_once(')').map_or("", |(_, rest)| rest))
}

#[cfg(test)]
mod tests {
    use super::check;
    use lab_kit::Kit;

    const PAGE: &str = "# Lab 5\n\n## Build\n\n### Two locks: deadlock\n\nIn a *lock\norder* none waits.\n\n\
        ```sh\n# a lock hierarchy\n```\n\n#### Once more\n\nIn time.\n\n### Queues\n\nA queue.\n";

    fn faults(row: &str) -> Vec<String> {
        let folder = tempfile::tempdir().unwrap();
        let glossary = format!("| word | what | section |\n|---|---|---|\n| {row} |\n");
        let files = [("book/src/lab5.md", PAGE), ("book/src/glossary.md", &glossary)];
        check(&Kit::of_files(folder.path(), &files)).unwrap()
    }

    #[test]
    fn words_that_their_sections_have() {
        for row in [
            "lock order, *lock hierarchy* | which first | [Two locks](lab5.md#two-locks-deadlock)",
            "order (of locks), time | which first | [Two locks](lab5.md#two-locks-deadlock)",
            "deadlock, queue | two | [Two locks](lab5.md#two-locks-deadlock), [Queues](lab5.md#queues)",
            "time | somewhere | [Lab 5](lab5.md)",
        ] {
            assert_eq!(faults(row), [""; 0], "{row}");
        }
    }

    #[test]
    fn words_that_they_lack() {
        for (row, why) in [
            (
                "lock order, monitor | w | [Two locks](lab5.md#two-locks-deadlock)",
                "'monitor' is not",
            ),
            ("queue | w | [Two locks](lab5.md#two-locks-deadlock)", "has none of 'queue'"),
            (
                "queue | w | [Queues](lab5.md#queues), [Build](lab5.md#once-more)",
                "#once-more has none",
            ),
            ("queue | w | [Gone](lab5.md#gone)", "no section lab5.md#gone"),
            ("queue | w | [Gone](lab6.md)", "no lab6.md"),
        ] {
            let faults = faults(row);
            assert!(faults[0].contains(why), "{row}: {faults:?}");
            assert!(faults[0].starts_with("book/src/glossary.md:3: "), "{faults:?}");
        }
    }
}
