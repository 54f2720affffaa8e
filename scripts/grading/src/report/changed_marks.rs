//! Differences between two records.

use similar::{ChangeTag, TextDiff};

use super::{Words, letter, points};
use crate::record::{Marked, Record};
use lab_kit::escape::line;

/// Describes the differences between two records; `None` if no mark and no result of a task
/// changed.
///
/// The description contains the points before and after, and the changed lines of the letter.
pub(crate) fn changes(before: &Record, after: &Record) -> Option<String> {
    if marks(before) == marks(after) && before.tasks == after.tasks {
        return None;
    }
    let mut out =
        format!("{}: {}, before {}", line(&after.found.name), given(after), given(before));
    let [old, new] = [before, after].map(text);
    for change in TextDiff::from_lines(&old, &new).iter_all_changes() {
        if change.tag() != ChangeTag::Equal && !change.value().trim().is_empty() {
            out += &format!("\n  {} {}", change.tag(), change.value().trim_end());
        }
    }
    Some(out)
}

/// Returns the parts of a record whose differences count, in addition to its tasks.
fn marks(record: &Record) -> impl PartialEq {
    let Marked { attempt, points, out_of, measures, .. } = &record.marked;
    let measures = measures.iter().map(|it| (it.kind, it.verdict, it.points, it.out_of));
    (record.found.status, *attempt, *points, *out_of, measures.collect::<Vec<_>>())
}

fn given(record: &Record) -> String {
    format!("{} of {}", points(record.marked.points), points(record.marked.out_of))
}

/// Returns the letter to the student, with the files and programs that the marks depend on.
fn text(record: &Record) -> String {
    let mut out = letter::body(record, &Words::default());
    for (path, digest) in &record.found.files {
        out += &format!("{}: {digest}\n", line(path));
    }
    let toolchain = line(&record.found.toolchain);
    let machine = line(&record.found.machine);
    out + &format!("Grader: {}\nCompiler: {toolchain}\nMachine: {machine}\n", record.found.grader)
}
