//! Grades a whole class with times, and kills the grader while it takes times. It is run by hand
//! and prints a line for each submission.

use std::fs;
use std::time::Instant;

use crate::class::Class;
use crate::grade_command::{complaints, grade, kill_when, record, records, run};

/// Folder for records and pages, below the kit's target folder.
const KEPT: &str = "target/lab/mixed-class";

/// Every cheat changes a line that exists in the lab. This test checks it in seconds.
#[test]
fn a_mixed_class_can_be_made() {
    assert!(Class::mixed().members.len() > 20);
}

#[test]
#[ignore = "takes many minutes; run it by hand"]
fn a_mixed_class_with_times_is_graded_in_one_go() {
    let class = Class::mixed();
    let into = crate::solution::kit().join(KEPT);
    let _ = fs::remove_dir_all(&into);
    let start = Instant::now();
    let all = class.members.len();
    println!("{all} submissions of lab {}, into {}", class.lab, into.display());

    let is_killed = kill_when(grade(&class, &into, &[]), || {
        let records = records(&class, &into);
        records.values().filter(|record| record["timed"] == true).count() >= all / 2
    });
    if !is_killed {
        return;
    }
    say(start, "all tasks judged; killed with half of the times taken");
    let before = records(&class, &into);
    assert!(run(grade(&class, &into, &[])));
    say(start, "done");

    for (name, old) in &before {
        let new = record(&into, name).unwrap_or_default();
        assert_eq!(new["seed"], old["seed"], "{name} was graded again");
    }
    let complaints = complaints(&class, &into);
    assert!(complaints.is_empty(), "{}", complaints.join("\n"));
    class.assert_nothing_escaped();
}

fn say(start: Instant, what: &str) {
    println!("{:>5.0} s  {what}", start.elapsed().as_secs_f64());
}
