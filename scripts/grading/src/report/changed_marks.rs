//! Differences between two records.

use similar::{ChangeTag, TextDiff};

use super::{Words, letter, points};
use crate::record::Record;
use lab_kit::escape::line;

/// Describes the differences between two records; `None` if no mark and no result of a task
/// changed.
///
/// The description contains the points before and after, and the changed lines of the letter.
pub(crate) fn changes(before: &Record, after: &Record) -> Option<String> {
    let measures = |record: &Record| -> Vec<_> {
        let all = record.marked.measures.iter();
        all.map(|measure| (measure.kind, measure.verdict, measure.points, measure.out_of)).collect()
    };
    let marks = |record: &Record| {
        (record.found.status, record.marked.attempt, record.marked.points, record.marked.out_of)
    };
    if marks(before) == marks(after)
        && before.tasks == after.tasks
        && measures(before) == measures(after)
    {
        return None;
    }
    let given = |record: &Record| {
        format!("{} of {}", points(record.marked.points), points(record.marked.out_of))
    };
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
