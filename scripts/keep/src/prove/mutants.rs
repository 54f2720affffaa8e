//! Small changes that nobody thought of, each in one of a lab's answers: do the tests see them?
//!
//! `cargo mutants --list --json` says what can be changed, and where. A change inside an answer becomes
//! a wrong solution without a story, and so does another body for the function around an answer. All of
//! a lab's mutants are then compiled at once.

use std::path::Path;

use anyhow::{Context, Result};
use serde::Deserialize;

use super::copy::Copy;
use super::report::{Kind, Proof, Row};
use super::{Bench, choice};
use lab_kit::answers::{self, MarkedFile, Region, Task};
use lab_kit::files::read_text;
use lab_kit::harness::Verdict;
use lab_kit::machine::on_all_cores;
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

impl Bench<'_> {
    /// Which mutants survive all tests? Those of the mutant's own task are asked first.
    pub(super) fn mutants(&self, copy: &Copy, list: &Path) -> Result<Vec<Row>> {
        self.begin("mutants must be caught");
        let files = answers::read_solution(self.kit, self.lab)?;
        let mutants = read(self.kit, self.lab, list, &files)?;
        let (program, refused) = match self.mutated(copy, &files, &mutants) {
            Ok(built) => built,
            Err(why) => {
                return Ok(vec![self.row(Kind::Mutant, "all", 0, vec![format!("{why:#}")])]);
            }
        };
        let all = program.tests()?;
        self.bar.set_length(mutants.len() as u64);
        let indices: Vec<usize> = (0..mutants.len()).collect();
        let rows = on_all_cores(&indices, |&index| -> Result<Row> {
            let mutant = &mutants[index];
            let row = |tests, result, faults| {
                let (lab, name) = (self.lab, mutant.name.clone());
                Row { lab, kind: Kind::Mutant, name, tests, result, faults }
            };
            if let Some(why) = refused[index].first() {
                let why = why.lines().next().unwrap_or_default().to_owned();
                return Ok(row(0, Proof::Skipped, vec![why]));
            }
            let mut tests: Vec<_> = all.iter().collect();
            tests.sort_by_key(|test| Task::of_test(test) != Some(mutant.region.task));
            let mut asked = 0;
            for test in tests {
                asked += 1;
                let choice = choice::environment(self.lab, index);
                let how = match program.run(test, &[choice], self.limit)?.verdict {
                    Verdict::Passed | Verdict::Ignored | Verdict::Skipped => continue,
                    Verdict::Failed => Vec::new(),
                    Verdict::Crashed(how) => vec![format!("{test}: {how}")],
                    Verdict::TimedOut => vec![format!("{test} did not end")],
                };
                self.bar.inc(1);
                return Ok(row(asked, Proof::Proven, how));
            }
            self.bar.inc(1);
            Ok(row(asked, Proof::Faulty, vec!["no test fails".into()]))
        });
        rows.into_iter().collect()
    }
}

/// The mutants in `list` that change an answer in `files`, those of a lab's solution.
fn read(kit: &Kit, lab: Lab, list: &Path, files: &[MarkedFile]) -> Result<Vec<Wrong>> {
    let unread = || format!("cannot read {}", list.display());
    let mutants: Vec<Mutant> = serde_json::from_str(&read_text(list)?).with_context(unread)?;
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
        // Given code may follow the answer.
        return around.then(|| format!("return {replacement};\n"));
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
        assert_eq!(mutant((2, 5), (5, 10), "true").unwrap(), "return true;\n");
        assert_eq!(mutant((2, 18), (2, 19), "-"), None);
    }
}
