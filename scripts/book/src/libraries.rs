//! A library is introduced with a link to its documents where the book first names it.

use anyhow::{Context, Result};

use lab_kit::Kit;

use crate::pages::pages;

/// Libraries that a reader meets.
const LIBRARIES: [&str; 7] =
    ["rayon", "crossbeam", "parking_lot", "rsmpi", "insta", "wgpu", "pulp"];

/// Looks at the first paragraph of the book that names each library.
///
/// # Errors
/// A page cannot be read. Libraries without a link there are returned, a line each.
pub(crate) fn check(kit: &Kit) -> Result<Vec<String>> {
    let pages = pages(kit)?;
    let summary = pages.get("book/src/SUMMARY.md").context("the book has no SUMMARY.md")?;
    let in_order = summary.lines().filter_map(|line| {
        let page = line.rsplit_once("](")?.1.strip_suffix(')')?;
        pages.get_key_value(&format!("book/src/{page}"))
    });
    let first = |library: &&str| {
        let mut paragraphs =
            in_order.clone().flat_map(|(name, text)| prose(text).map(move |p| (name, p)));
        let (name, paragraph) = paragraphs.find(|(_, p)| names(p, library))?;
        let linked = paragraph
            .split("](http")
            .skip(1)
            .any(|link| link.split(')').next().is_some_and(|address| address.contains(*library)));
        (!linked).then(|| format!("{name}: {library} is first named here, without a link to it"))
    };
    Ok(LIBRARIES.iter().filter_map(first).collect())
}

/// The paragraphs of a page that are no code.
fn prose(text: &str) -> impl Iterator<Item = &str> {
    text.split("```").step_by(2).flat_map(|text| text.split("\n\n"))
}

/// Whether a paragraph names a library, as a word of its own.
fn names(paragraph: &str, library: &str) -> bool {
    paragraph.split(|c: char| !(c.is_alphanumeric() || c == '_')).any(|word| word == library)
}

#[cfg(test)]
mod tests {
    use super::check;
    use lab_kit::Kit;

    fn faults(first: &str) -> Vec<String> {
        let folder = tempfile::tempdir().unwrap();
        let files = [
            ("book/src/SUMMARY.md", "- [One](one.md)\n- [Two](two.md)\n- [Three]()\n"),
            ("book/src/one.md", first),
            ("book/src/two.md", "More of [rayon](https://docs.rs/rayon).\n"),
        ];
        check(&Kit::of_files(folder.path(), &files)).unwrap()
    }

    #[test]
    fn the_first_paragraph_links() {
        for text in [
            "",
            "The crate [rayon](https://docs.rs/rayon) steals.\n\nWith rayon it is short.",
            "```rust\nuse rayon::prelude::*;\n```\n",
            "crayons",
        ] {
            assert_eq!(faults(text), [""; 0], "{text}");
        }
    }

    #[test]
    fn a_later_link_does_not_count() {
        for text in [
            "With rayon it is short.\n\nThe crate [rayon](https://docs.rs/rayon).",
            "`rayon::scope` and [docs](https://docs.rs)",
        ] {
            let faults = faults(text);
            assert!(
                faults.len() == 1 && faults[0].starts_with("book/src/one.md: rayon"),
                "{faults:?}"
            );
        }
    }
}
