//! `cargo lab classroom`: prints a lab's tasks as declarative tests of Classroom 50.
//!
//! Each task is a test with the points in `lab.toml`. The test passes if `cargo lab test` passes
//! for the task. The form of the tests is documented in
//! <https://github.com/foundation50/classroom50/wiki/Autograding-Basics>.

use std::process::ExitCode;

use anyhow::{Result, ensure};
use clap::Args;
use serde_json::{Value, json};

use lab_kit::{Kit, Lab, rubric, task_list};

/// Print the tests of a lab for Classroom 50 (for instructors)
///
/// Save the output in a file, and name this file when you add the assignment: gh teacher assignment
/// add … --tests FILE. The template of the assignment is a class's kit, which 'cargo lab handout'
/// writes.
#[derive(Args)]
pub struct Options {
    /// The lab, such as 3
    lab: Lab,
}

/// Seconds for installing the lab's software and for the first build: the longest time that
/// Classroom 50 allows.
const BUILD: u64 = 600;

/// Seconds for the tests of a task. A test that hangs is stopped much sooner.
const TASK: u64 = 300;

/// Prints the tests.
///
/// # Errors
/// There is no such lab, or the points of a task are not an integer.
pub fn run(kit: &Kit, options: &Options) -> Result<ExitCode> {
    println!("{}", serde_json::to_string_pretty(&tests(kit, options.lab)?)?);
    Ok(ExitCode::SUCCESS)
}

/// Returns the tests of a lab: first the set-up, which is worth no points, then the tasks.
fn tests(kit: &Kit, lab: Lab) -> Result<Vec<Value>> {
    let workers = serde_json::to_value(rubric::read(kit, lab)?.workers)?;
    let workers = workers.as_str().unwrap_or_default();
    let build = format!("cargo test --locked --no-run --package lab{lab} --test lab{lab}");
    let mut tests = vec![json!({
        "name": "setup", "type": "run", "timeout": BUILD, "points": 0,
        "run": format!("scripts/setup.sh --for {workers} && {build}"),
    })];
    for (id, task) in task_list::read(kit, lab)? {
        let points = task.points;
        let is_whole = points.fract() == 0.0;
        ensure!(is_whole, "task {id} has {points} points; Classroom 50 takes whole numbers");
        tests.push(json!({
            "name": format!("Task {id}: {}", task.title), "type": "run", "timeout": TASK,
            "points": points as u64, "run": format!("cargo lab test {id}"),
        }));
    }
    Ok(tests)
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::tests;
    use lab_kit::{Kit, rubric};

    const KEYS: [&str; 5] = ["name", "points", "run", "timeout", "type"];

    /// The documentation of Classroom 50 allows at most 100 tests, unique names of at most 100
    /// bytes, 1 to 600 seconds and 0 to 1000 points.
    #[test]
    fn the_tests_of_every_lab_have_the_documented_form() {
        let kit = Kit::find().unwrap();
        for lab in kit.solutions() {
            let facts = rubric::read(&kit, lab).unwrap();
            let tests = tests(&kit, lab).unwrap();
            let names: BTreeSet<&str> =
                tests.iter().map(|test| test["name"].as_str().unwrap()).collect();
            assert_eq!(names.len(), tests.len(), "names are unique");
            assert!(tests.len() <= 100 && tests[0]["name"] == "setup" && tests[0]["points"] == 0);
            assert!(names.iter().all(|name| name.len() <= 100 && !name.contains(char::is_control)));
            for test in &tests {
                let mut keys = test.as_object().unwrap().keys();
                assert!(keys.all(|key| KEYS.contains(&&**key)), "{test}");
                assert!(test["type"] == "run" && !test["run"].as_str().unwrap().is_empty());
                assert!((1..=600).contains(&test["timeout"].as_u64().unwrap()), "{test}");
            }
            let points: u64 = tests.iter().map(|test| test["points"].as_u64().unwrap()).sum();
            let of_tasks: f64 = facts.tasks.values().map(|task| task.points).sum();
            assert_eq!(points as f64, of_tasks, "lab {lab}");
        }
    }

    #[test]
    fn tasks_come_in_their_order_after_the_set_up() {
        let kit = Kit::find().unwrap();
        let of_ranks = tests(&kit, "5".parse().unwrap()).unwrap();
        let set_up = "scripts/setup.sh --for ranks && cargo test --locked --no-run --package lab5 --test lab5";
        assert_eq!(of_ranks[0]["run"], set_up);
        assert_eq!(of_ranks[1]["run"], "cargo lab test 5.1");
        assert!(of_ranks[1]["name"].as_str().unwrap().starts_with("Task 5.1: "));
        let last = tests(&kit, "3".parse().unwrap()).unwrap().pop().unwrap();
        assert_eq!(last["run"], "cargo lab test 3.12");
    }
}
