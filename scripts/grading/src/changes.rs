//! What changed between two records, and why.

use std::collections::BTreeSet;

use crate::escape::line;
use crate::record::{Measure, Record};

/// What changed, a line each; none if nothing that matters did.
pub(crate) fn words(before: &Record, after: &Record) -> Option<String> {
    let mut lines = Vec::new();
    if before.status != after.status {
        let say = |record: &Record| match record.message.lines().next() {
            Some(first) if !first.is_empty() => format!("{:?}: {}", record.status, line(first)),
            _ => format!("{:?}", record.status),
        };
        lines.push(format!("it was {}, now {}", say(before), say(after)));
    }
    tasks(before, after, &mut lines);
    measures(before, after, &mut lines);
    if lines.is_empty() && (before.points, before.out_of) == (after.points, after.out_of) {
        return None;
    }
    lines.extend(reasons(before, after));
    let points = format!("{} of {}", after.points, after.out_of);
    let was = format!("{} of {}", before.points, before.out_of);
    let head = format!("{}: {points}, before {was}", line(&after.name));
    Some(lines.into_iter().fold(head, |text, line| format!("{text}\n  {line}")))
}

fn tasks(before: &Record, after: &Record, lines: &mut Vec<String>) {
    for task in after.tasks_in_order() {
        let Some(was) = before.tasks.iter().find(|was| was.id == task.id) else {
            lines.push(format!("task {} is new, {} points", task.id, task.points));
            continue;
        };
        let points = format!("task {}, {} \u{2192} {} points", task.id, was.points, task.points);
        let (said, says) = (line(&was.message), line(&task.message));
        match (was.passed, task.passed) {
            (true, false) => lines.push(format!("{points}: {says}")),
            (false, true) => lines.push(format!("{points}: right now; it was: {said}")),
            (false, false) if said != says => {
                lines.push(format!("task {}, still wrong, now: {says}", task.id));
            }
            _ if was.out_of != task.out_of => lines
                .push(format!("{points}: it is worth {}, no longer {}", task.out_of, was.out_of)),
            _ if was.points != task.points => lines.push(points),
            _ => {}
        }
    }
    let gone = |was: &&crate::record::Task| after.tasks.iter().all(|task| task.id != was.id);
    lines.extend(before.tasks.iter().filter(gone).map(|was| format!("task {} is gone", was.id)));
}

fn measures(before: &Record, after: &Record, lines: &mut Vec<String>) {
    let say = |measure: &Measure| match measure.grade {
        Some(grade) => format!("{grade:.0} of 100"),
        None => "not graded".to_owned(),
    };
    for measure in &after.measures {
        let marks = |measure: &Measure| (measure.points, measure.out_of, measure.verdict);
        let was = before.measures.iter().find(|was| was.kind == measure.kind);
        if was.map(marks) != Some(marks(measure)) {
            let name = format!("{} of {}", measure.kind.name(), line(&measure.variant));
            let was = was.map_or("not there".to_owned(), say);
            let (now, why) = (say(measure), line(&measure.message));
            lines.push(format!("{name}: {was} \u{2192} {now}: {why}"));
        }
    }
}

/// What differs between the two that marks may follow from.
fn reasons(before: &Record, after: &Record) -> Vec<String> {
    let mut why = Vec::new();
    if before.hash != after.hash {
        let names: BTreeSet<&String> = before.files.keys().chain(after.files.keys()).collect();
        let changed =
            names.into_iter().filter(|name| before.files.get(*name) != after.files.get(*name));
        let changed: Vec<String> = changed.map(|name| line(name)).collect();
        why.push(format!("because other sources were handed in: {}", changed.join(", ")));
    }
    if before.seed != after.seed {
        why.push(format!("with other inputs: seed {}, before {}", after.seed, before.seed));
    }
    if before.grader != after.grader {
        why.push("by another grader: its probes or the solution changed".to_owned());
    }
    if before.by_hand != after.by_hand {
        why.push("because a person decided so: see class.toml".to_owned());
    }
    if before.late != after.late {
        let late = |record: &Record| match &record.late {
            Some(late) => format!("{} late for {:.0} %", late.days(), 100.0 * late.lost),
            None => "in time".to_owned(),
        };
        why.push(format!("{}, before {}", late(after), late(before)));
    }
    if before.runs != after.runs {
        why.push("timed anew".to_owned());
    }
    for (what, was, is) in [
        ("compiler", &before.toolchain, &after.toolchain),
        ("machine", &before.machine, &after.machine),
    ] {
        if was != is {
            why.push(format!("on another {what}: {is}, before {was}"));
        }
    }
    why
}

#[cfg(test)]
mod tests {
    use super::words;
    use crate::record::Record;

    #[test]
    fn the_same_says_nothing() {
        let mut after = Record::sample();
        assert_eq!(words(&Record::sample(), &after), None);
        after.seed += 1;
        assert_eq!(words(&Record::sample(), &after), None, "other inputs, the same marks");
    }

    #[test]
    fn what_changed_has_its_reason() {
        let mut after = Record::sample();
        after.tasks[1].passed = true;
        (after.tasks[1].points, after.points) = (40.0, 100.0);
        after.hash = "other".into();
        after.files.insert("src/lib.rs".into(), "other".into());
        let text = words(&Record::sample(), &after).unwrap();
        assert!(text.starts_with("ada: 100 of 100, before 60 of 100\n"), "{text}");
        assert!(
            text.contains("task 1.2, 0 \u{2192} 40 points: right now; it was: bounce"),
            "{text}"
        );
        assert!(text.contains("other sources were handed in: src/lib.rs"), "{text}");
    }

    #[test]
    fn a_new_rubric_is_a_reason_too() {
        let mut after = Record::sample();
        after.tasks[0].out_of = 20.0;
        (after.tasks[0].points, after.points, after.out_of) = (20.0, 20.0, 60.0);
        let text = words(&Record::sample(), &after).unwrap();
        assert!(
            text.contains("task 1.1, 60 \u{2192} 20 points: it is worth 20, no longer 60"),
            "{text}"
        );
    }
}
