//! Checks the code locations that are named in tables of the book.
//!
//! A column with the title "where in the kit" contains cells `` `WORD` in `PATH` ``. The path is
//! below `solutions/` or `labs/`, and the code of the file must contain the word.

use std::fs;

use anyhow::Result;

use lab_kit::Kit;

use crate::pages::{Table, pages, tables};

const TITLE: &str = "where in the kit";

/// Checks every table that has a column with this title. Returns the faults, one per line.
pub(crate) fn check(kit: &Kit) -> Result<Vec<String>> {
    let mut wrong = Vec::new();
    for (page, text) in pages(kit)? {
        for Table { line, rows, .. } in tables(&text) {
            let Some(at) = rows[0].iter().position(|title| *title == TITLE) else { continue };
            for (row, number) in rows.iter().zip(line..).skip(2) {
                let claims = row.get(at).copied().unwrap_or_default();
                let faults = claims.split("; ").filter_map(|claim| fault(kit, claim));
                wrong.extend(faults.map(|why| format!("{page}:{number}: {why}")));
            }
        }
    }
    Ok(wrong)
}

/// Returns the fault of a cell, or `None` if it is right.
fn fault(kit: &Kit, claim: &str) -> Option<String> {
    // A cell without backticks is a word such as "everywhere", which needs no location.
    if !claim.contains('`') {
        return None;
    }
    let quoted: Vec<&str> = claim.split('`').collect();
    let ["", word, " in ", path, ""] = quoted[..] else {
        return Some(format!("'{claim}' is not `WORD` in `PATH`"));
    };
    let sources = ["solutions", "labs"].map(|folder| kit.path(folder).join(path));
    let Some(source) = sources.iter().find_map(|source| fs::read_to_string(source).ok()) else {
        return Some(format!("there is no solutions/{path}"));
    };
    let mut code = source.lines().filter(|line| !line.trim_start().starts_with("//"));
    let there = code.any(|line| line.contains(word));
    (!there).then(|| format!("solutions/{path} has no {word}"))
}

#[cfg(test)]
mod tests {
    use super::check;
    use lab_kit::Kit;

    fn faults(claim: &str) -> Vec<String> {
        let folder = tempfile::tempdir().unwrap();
        let source = "// no rayon::scope here\nlet sum = list.par_iter().sum();\n";
        let page = format!("| Rust | where in the kit |\n|---|---|\n| x | {claim} |\n\nText.\n");
        let files = [("solutions/lab3/src/sum.rs", source), ("book/src/page.md", &page)];
        check(&Kit::of_files(folder.path(), &files)).unwrap()
    }

    #[test]
    fn what_is_there() {
        for claim in [
            "`par_iter` in `lab3/src/sum.rs`",
            "everywhere",
            "",
            "nowhere; `sum()` in `lab3/src/sum.rs`",
        ] {
            assert_eq!(faults(claim), [""; 0], "{claim}");
        }
    }

    #[test]
    fn what_is_not() {
        for (claim, why) in [
            ("`par_chunks` in `lab3/src/sum.rs`", "has no par_chunks"),
            ("`rayon::scope` in `lab3/src/sum.rs`", "has no rayon::scope"),
            ("`sum` in `lab3/src/gone.rs`", "there is no solutions/lab3/src/gone.rs"),
            ("`sum`, lab 3", "is not `WORD` in `PATH`"),
        ] {
            let faults = faults(claim);
            assert!(faults.len() == 1 && faults[0].contains(why), "{claim}: {faults:?}");
            assert!(faults[0].starts_with("book/src/page.md:3: "), "{faults:?}");
        }
    }
}
