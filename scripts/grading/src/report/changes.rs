//! What changed between two records.

use similar::{ChangeTag, TextDiff};

use super::{Words, letter, points};
use crate::escape::line;
use crate::record::Record;

/// The points before and after, and the lines that a student reads otherwise; none if nothing that
/// matters did.
pub(crate) fn changes(before: &Record, after: &Record) -> Option<String> {
    let measures = |record: &Record| -> Vec<_> {
        let all = record.measures.iter();
        all.map(|measure| (measure.kind, measure.verdict, measure.points, measure.out_of)).collect()
    };
    let marks = |record: &Record| (record.status, record.points, record.out_of);
    if marks(before) == marks(after)
        && before.tasks == after.tasks
        && measures(before) == measures(after)
    {
        return None;
    }
    let given = |record: &Record| format!("{} of {}", points(record.points), points(record.out_of));
    let mut out = format!("{}: {}, before {}", line(&after.name), given(after), given(before));
    let [old, new] = [before, after].map(text);
    for change in TextDiff::from_lines(&old, &new).iter_all_changes() {
        if change.tag() != ChangeTag::Equal && !change.value().trim().is_empty() {
            out += &format!("\n  {} {}", change.tag(), change.value().trim_end());
        }
    }
    Some(out)
}

/// What a student reads, and what the marks rest on.
fn text(record: &Record) -> String {
    let mut out = letter::said(record, &Words::default());
    for (path, digest) in &record.files {
        out += &format!("{}: {digest}\n", line(path));
    }
    let (toolchain, machine) = (line(&record.toolchain), line(&record.machine));
    out + &format!("Grader: {}\nCompiler: {toolchain}\nMachine: {machine}\n", record.grader)
}

#[cfg(test)]
mod tests {
    use super::changes;
    use crate::record::Record;

    #[test]
    fn the_same_says_nothing() {
        let mut after = Record::sample();
        assert_eq!(changes(&Record::sample(), &after), None);
        after.seed += 1;
        assert_eq!(changes(&Record::sample(), &after), None, "other inputs, the same marks");
    }

    #[test]
    fn what_changed_has_its_reason() {
        let mut after = Record::sample();
        after.tasks[1].passed = true;
        (after.tasks[1].points, after.points) = (40.0, 100.0);
        after.files.insert("src/lib.rs".into(), "other".into());
        after.toolchain = "rustc 2".into();
        let text = changes(&Record::sample(), &after).unwrap();
        let lines: Vec<&str> = text.lines().collect();
        assert_eq!(lines[0], "ada: 100 of 100, before 60 of 100");
        for line in [
            "  - | Task 1.2 | 0 of 40 **lost** |",
            "  + | Task 1.2 | 40 of 40 |",
            "  - bounce of 0.12 in a box of 0.1: value 1 is 0.12, not 0.08",
            "  + src/lib.rs: other",
            "  + Compiler: rustc 2",
        ] {
            assert!(lines.contains(&line), "{line}: {text}");
        }
    }

    #[test]
    fn a_new_rubric_is_a_reason_too() {
        let mut after = Record::sample();
        after.tasks[0].out_of = 20.0;
        (after.tasks[0].points, after.points, after.out_of) = (20.0, 20.0, 60.0);
        let text = changes(&Record::sample(), &after).unwrap();
        assert!(text.contains("- | Task 1.1 | 60 of 60 |"), "{text}");
        assert!(text.contains("+ | Task 1.1 | 20 of 20 |"), "{text}");
    }
}
