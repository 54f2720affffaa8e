//! Checks that the sections that starters name exist in the chapters.

use std::fs;

use anyhow::Result;

use lab_kit::Kit;
use lab_kit::files::{read_text, sources_below};

/// The text before the name of a section in a doc comment: `Book: chapter 5, *Gather*.`
///
/// The heading may continue after a colon: `### Gather: a collective operation`.
const BOOK: &str = "Book: ";

/// Checks every source of every starter. Returns the sections that no chapter has, one per line.
pub(crate) fn check(kit: &Kit) -> Result<Vec<String>> {
    let mut wrong = Vec::new();
    for lab in kit.starters() {
        for path in sources_below(&kit.starter(lab).join("src"))? {
            let text = read_text(&path)?;
            let name = path.strip_prefix(kit.root()).unwrap_or(&path).display();
            for (number, line) in (1..).zip(text.lines()) {
                let Some((_, named)) = line.split_once(BOOK) else { continue };
                if !is_there(kit, named) {
                    wrong.push(format!("{name}:{number}: the book has no {named}"));
                }
            }
        }
    }
    Ok(wrong)
}

/// Whether the section in a text such as `chapter 5, *Gather*.` exists.
fn is_there(kit: &Kit, named: &str) -> bool {
    let place = named.strip_prefix("chapter ").and_then(|named| named.strip_suffix("*."));
    let Some((chapter, heading)) = place.and_then(|place| place.split_once(", *")) else {
        return false;
    };
    let page = fs::read_to_string(kit.path(format!("book/src/lab{chapter}.md")));
    page.is_ok_and(|page| page.lines().any(|line| is_heading(line, heading)))
}

/// Whether a line is this heading, below the page's title. The heading may continue after a colon.
fn is_heading(line: &str, heading: &str) -> bool {
    let after = line.trim_start_matches('#').trim().strip_prefix(heading);
    line.starts_with("##") && after.is_some_and(|rest| rest.is_empty() || rest.starts_with(": "))
}

#[cfg(test)]
mod tests {
    use super::check;
    use lab_kit::Kit;

    fn faults(source: &str) -> Vec<String> {
        let folder = tempfile::tempdir().unwrap();
        let files = [
            ("labs/lab5/Cargo.toml", ""),
            ("book/src/lab5.md", "# Gone\n\n### Gather\n\nScatter\n\n### Ghosts: a halo\n"),
            ("labs/lab5/src/halo/root.rs", source),
        ];
        check(&Kit::of_files(folder.path(), &files)).unwrap()
    }

    #[test]
    fn a_starter_s_sections_must_exist() {
        assert_eq!(faults("/// Book: chapter 5, *Gather*.\nfn gather() {}\n"), [""; 0]);
        assert_eq!(faults("/// Book: chapter 5, *Ghosts*.\nfn ghosts() {}\n"), [""; 0]);
        for odd in [
            "chapter 5, *Scatter*.",
            "chapter 5, *Gone*.",
            "chapter 5, *Gat*.",
            "chapter 6, *Gather*.",
            "chapter 5.",
        ] {
            let expected = format!("labs/lab5/src/halo/root.rs:2: the book has no {odd}");
            assert_eq!(faults(&format!("\n    /// Book: {odd}\n")), [expected]);
        }
    }
}
