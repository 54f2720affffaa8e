//! `cargo lab grade-diff`: what changed between two records, and why.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use anyhow::{Result, ensure};
use clap::Args;

use crate::escape::line;
use crate::record::{self, Measure, Record, Task};

/// Say what changed between two records, or two folders of records (for instructors)
///
/// Of every submission that is in both and did not come out the same: the points before and after,
/// each task and measure that changed with its reason, and whether sources, inputs or grader differ.
/// Exit code 1 if marks differ.
#[derive(Args)]
pub(crate) struct Options {
    /// A record, or a folder of them: before
    #[arg(value_name = "A")]
    before: PathBuf,
    /// A record, or a folder of them: after
    #[arg(value_name = "B")]
    after: PathBuf,
}

/// Compares and prints.
pub(crate) fn run(options: &Options) -> Result<ExitCode> {
    let (before, after) = (records(&options.before)?, records(&options.after)?);
    let one = |records: &BTreeMap<String, Record>, path: &Path| {
        (records.len() == 1 && path.is_file()).then(|| records.values().next().cloned()).flatten()
    };
    let pairs = match (one(&before, &options.before), one(&after, &options.after)) {
        // Two files are compared, whatever they are called.
        (Some(before), Some(after)) => vec![(before, after)],
        _ => {
            for (one, other, which) in [(&before, &after, "first"), (&after, &before, "second")] {
                for name in one.keys().filter(|name| !other.contains_key(*name)) {
                    println!("{}: only in the {which}", line(name));
                }
            }
            let both = before
                .into_iter()
                .filter_map(|(name, record)| after.get(&name).map(|after| (record, after.clone())));
            both.collect()
        }
    };
    ensure!(!pairs.is_empty(), "the two have no submission in common");
    let (mut changed, all) = (0, pairs.len());
    for (before, after) in &pairs {
        if let Some(text) = words(before, after) {
            println!("{text}");
            changed += usize::from(marks_differ(before, after));
        }
    }
    println!("{changed} of {all} got other marks.");
    Ok(if changed == 0 { ExitCode::SUCCESS } else { ExitCode::from(1) })
}

fn records(path: &Path) -> Result<BTreeMap<String, Record>> {
    let records = if path.is_dir() { record::read_all(path)? } else { vec![record::read(path)?] };
    Ok(records.into_iter().map(|record| (record.name.clone(), record)).collect())
}

fn marks_differ(before: &Record, after: &Record) -> bool {
    (before.points, before.out_of) != (after.points, after.out_of)
}

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
    if lines.is_empty() && !marks_differ(before, after) {
        return None;
    }
    lines.extend(reasons(before, after));
    let head = format!(
        "{}: {} of {}, before {} of {}",
        line(&after.name),
        after.points,
        after.out_of,
        before.points,
        before.out_of
    );
    Some(lines.into_iter().fold(head, |text, line| format!("{text}\n  {line}")))
}

fn tasks(before: &Record, after: &Record, lines: &mut Vec<String>) {
    let of = |record: &Record| -> BTreeMap<String, Task> {
        record.tasks.iter().map(|task| (task.id.clone(), task.clone())).collect()
    };
    let (old, new) = (of(before), of(after));
    for task in after.tasks_in_order() {
        let Some(was) = old.get(&task.id) else {
            lines.push(format!("task {} is new, {} points", task.id, task.points));
            continue;
        };
        let points = format!("{} \u{2192} {} points", was.points, task.points);
        match (was.passed, task.passed) {
            (true, false) => {
                lines.push(format!("task {}, {points}: {}", task.id, line(&task.message)));
            }
            (false, true) => lines.push(format!(
                "task {}, {points}: right now; it was: {}",
                task.id,
                line(&was.message)
            )),
            (false, false) if was.message != task.message => {
                lines.push(format!("task {}, still wrong, now: {}", task.id, line(&task.message)))
            }
            _ if was.out_of != task.out_of => lines.push(format!(
                "task {}, {points}: it is worth {}, no longer {}",
                task.id, task.out_of, was.out_of
            )),
            _ if was.points != task.points => lines.push(format!("task {}, {points}", task.id)),
            _ => {}
        }
    }
    for id in old.keys().filter(|id| !new.contains_key(*id)) {
        lines.push(format!("task {id} is gone"));
    }
}

fn measures(before: &Record, after: &Record, lines: &mut Vec<String>) {
    let say = |measure: &Measure| match measure.grade {
        Some(grade) => format!("{grade:.0} of 100"),
        None => "not graded".to_owned(),
    };
    for measure in &after.measures {
        let name = format!("{} of {}", measure.kind.name(), line(&measure.variant));
        let was = before.measures.iter().find(|was| was.kind == measure.kind);
        let changed = was.is_none_or(|was| {
            (was.points, was.out_of, was.verdict)
                != (measure.points, measure.out_of, measure.verdict)
        });
        if changed {
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
    let late = |record: &Record| match &record.late {
        Some(late) => format!("{} late for {:.0} %", late.days(), 100.0 * late.lost),
        None => "in time".to_owned(),
    };
    if before.late != after.late {
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
