//! Small changes that nobody thought of, each in one of a lab's answers: do the tests see them?
//!
//! `cargo mutants --list --json` says what can be changed, and where. A change inside an answer becomes
//! a wrong solution without a story, and so does another body for the function around an answer. All of
//! a lab's mutants are then compiled at once.

use std::fs;
use std::path::Path;

use anyhow::{Context, Result};
use serde::Deserialize;

use lab_kit::answers::{MarkedFile, Region};
use lab_kit::wrong::Wrong;
use lab_kit::{Kit, Lab};

/// A change as cargo-mutants writes it down.
#[derive(Deserialize)]
struct Mutant {
    /// Relative to the workspace's top folder.
    file: String,
    name: String,
    span: Span,
    replacement: String,
}

/// From a place up to another, which is no part of it.
#[derive(Deserialize)]
struct Span {
    start: At,
    end: At,
}

/// A place in a file, both counted from 1.
#[derive(Deserialize)]
struct At {
    line: usize,
    column: usize,
}

/// The mutants in `list` that change an answer in `files`, those of a lab's solution.
pub(crate) fn read(kit: &Kit, lab: Lab, list: &Path, files: &[MarkedFile]) -> Result<Vec<Wrong>> {
    let unread = || format!("cannot read {}", list.display());
    let text = fs::read_to_string(list).with_context(unread)?;
    let mutants: Vec<Mutant> = serde_json::from_str(&text).with_context(unread)?;
    let folder = kit.solution(lab);
    let mut found = Vec::new();
    for mutant in &mutants {
        for file in files.iter().filter(|f| folder.join(&f.path) == kit.path(&mutant.file)) {
            for region in file.marked.regions() {
                found.extend(body(region, mutant).map(|body| Wrong {
                    name: mutant.name.clone(),
                    region: region.id,
                    fails: Vec::new(),
                    loses: Vec::new(),
                    story: String::new(),
                    body,
                }));
            }
        }
    }
    Ok(found)
}

/// The answer with the change in it; none if the change is elsewhere.
fn body(region: &Region, Mutant { span, replacement, .. }: &Mutant) -> Option<String> {
    let last = region.line + region.body.lines().count();
    if span.start.line <= region.line || span.end.line > last {
        let around = span.start.line <= region.line + 1 && span.end.line >= last;
        return around.then(|| format!("{replacement}\n"));
    }
    let offset = |at: &At| {
        let lines = region.body.split_inclusive('\n');
        let before: usize = lines.take(at.line - region.line - 1).map(str::len).sum();
        let line = region.body[before..].chars().take(at.column - 1);
        before + line.map(char::len_utf8).sum::<usize>()
    };
    let (before, after) = (&region.body[..offset(&span.start)], &region.body[offset(&span.end)..]);
    Some(format!("{before}{replacement}{after}"))
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::{At, Mutant, Span, body};
    use lab_kit::answers::parse;

    const SOURCE: &str = "\
fn less(a: u8, b: u8) -> bool {
    let more = a + 1;
    // task 1.2: the answer
    // «a»
    a < b
    // end 1.2
}
";

    fn mutant(start: (usize, usize), end: (usize, usize), replacement: &str) -> Option<String> {
        let marked = parse(Path::new("src/a.rs"), SOURCE).unwrap();
        let at = |(line, column)| At { line, column };
        let span = Span { start: at(start), end: at(end) };
        let replacement = replacement.into();
        let mutant = Mutant { file: String::new(), name: String::new(), span, replacement };
        body(marked.regions().next().unwrap(), &mutant)
    }

    #[test]
    fn a_change_in_an_answer_or_of_the_whole_function_is_a_mutant() {
        assert_eq!(mutant((5, 7), (5, 8), "<=").unwrap(), "    // «a»\n    a <= b\n");
        assert_eq!(mutant((2, 5), (5, 10), "true").unwrap(), "true\n");
        assert_eq!(mutant((2, 18), (2, 19), "-"), None);
    }
}
