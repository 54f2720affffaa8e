//! Grades classes as an instructor does: `cargo lab grade CLASS --lab 1`.
//!
//! The quick tests grade a class of cheats in lab 1. The test of the whole class, with times, is
//! run by hand:
//!
//! ```text
//! cargo test --package lab-grading --test grading -- --ignored --nocapture
//! ```

mod archives;
mod cheats;
mod class;
mod code;
mod expected;
mod finished;
mod grade_command;
mod machine_faults;
mod mixed;
mod refusal;
mod regraded;
mod run_autograder;
mod solution;

use std::fs;

use class::Class;
use grade_command::{TASKS, complaints, grade, kill_when, records, run};

#[test]
fn cheats_gain_nothing_and_a_killed_class_goes_on() {
    let class = Class::of_cheats();
    let into = class.temporary().join("records");
    if !kill_when(grade(&class, &into, TASKS), || records(&class, &into).len() >= 2) {
        return;
    }
    let before = records(&class, &into);
    assert!(before.len() < class.members.len(), "it was killed half-way");

    assert!(run(grade(&class, &into, TASKS)));
    let after = records(&class, &into);
    for (name, record) in &before {
        // A submission that is graded again gets different inputs.
        assert_eq!(after[name]["seed"], record["seed"], "{name} was graded again");
    }
    let complaints = complaints(&class, &into);
    assert!(complaints.is_empty(), "{}", complaints.join("\n"));
    class.assert_nothing_escaped();
    let letter = |name: &str| fs::read_to_string(into.join(format!("feedback/{name}.md"))).unwrap();
    assert!(letter("hangs").contains("it prints too much"), "{}", letter("hangs"));
    let printed = fs::read_to_string(into.join("printed/prints/1.2.txt")).unwrap();
    assert!(printed.contains("the bounce of"), "{printed}");
    for (name, _) in &class.members {
        assert!(!letter(name).contains("ask.exact("), "a line of a question: {}", letter(name));
    }
}
