//! Tests a class that has already been graded, and the output during grading.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::process::Command;

use serde_json::Value;

use crate::cheats::QUICK;
use crate::class::Class;
use crate::grade_command::{NO_SANDBOX, TASKS, grade, program, record, records, run, script};

/// Runs a command without a terminal. Returns whether it succeeded, and its stderr.
fn message(mut command: Command) -> (bool, String) {
    let output = command.output().unwrap();
    (output.status.success(), String::from_utf8(output.stderr).unwrap())
}

/// Returns a path with a `rustc` that names a folder without a compiler, so that nothing can be
/// built.
fn without_compiler(top: &Path) -> String {
    let own = program("rustc").unwrap();
    let folder = top.join("without-compiler");
    fs::create_dir_all(&folder).unwrap();
    let own = own.display();
    let shown = folder.display();
    let text =
        format!("if [ \"$1\" = --print ]; then echo '{shown}'; else exec '{own}' \"$@\"; fi");
    script(&folder.join("rustc"), &text);
    format!("{shown}:{}", std::env::var("PATH").unwrap())
}

/// Returns the parts of a record that must not depend on the inputs.
///
/// The points of a wrong task depend on the inputs, because a wrong task gets partial points.
fn marks(record: &Value) -> (&Value, Vec<[&Value; 3]>) {
    let tasks = record["tasks"].as_array().into_iter().flatten();
    let marks = tasks.map(|task| {
        let points = if task["passed"] == true { &task["points"] } else { &Value::Null };
        [&task["id"], &task["passed"], points]
    });
    (&record["status"], marks.collect())
}

#[test]
fn a_class_gets_the_same_marks_twice_and_is_then_passed_over_without_a_build() {
    let class = Class::small(QUICK, &["bounce_single_if", "statistics_without_unit"]);
    let into = class.temporary().join("records");
    let (well, words) = message(grade(&class, &into, TASKS));
    if words.contains(NO_SANDBOX) {
        eprintln!("skipped: {words}");
        return;
    }
    assert!(well, "{words}");
    assert!(words.starts_with("Building the solution of lab 1, to compare with\n"), "{words}");
    let count = class.members.len();
    for number in 1..=count {
        assert!(words.contains(&format!("tasks, {number} of {count}: ")), "{words}");
    }
    assert!(words.contains("solved-too: all right\n"), "{words}");
    assert!(words.contains("untouched: lost 1.1, 1.2, 1.3, 1.4, 1.5\n"), "{words}");
    let before = records(&class, &into);
    assert_eq!(before.len(), class.members.len());

    let seeds: BTreeSet<u64> = before.values().filter_map(|it| it["seed"].as_u64()).collect();
    assert_eq!(seeds.len(), before.len(), "each is asked from a seed of its own");

    let other = class.temporary().join("other");
    assert!(run(grade(&class, &other, TASKS)));
    for (name, again) in &records(&class, &other) {
        let once = &before[name];
        assert_ne!(once["seed"], again["seed"], "{name} was asked the same");
        assert_eq!(marks(once), marks(again), "{name}");
    }

    let path = without_compiler(&class.temporary());
    let with = |options: &[&str]| {
        let mut command = grade(&class, &into, options);
        command.env("PATH", &path);
        message(command)
    };
    fs::remove_file(into.join("index.html")).unwrap();
    assert_eq!(with(TASKS), (true, String::new()));
    assert_eq!(records(&class, &into), before);
    assert!(into.join("index.html").is_file(), "pages are written anew");

    // A student can set the time of a folder's files.
    let deadline = "[late]\ndeadline = \"2026-11-20T22:59:00Z\"\npenalty = 10\n";
    fs::write(into.join("class.toml"), deadline).unwrap();
    let output = grade(&class, &into, TASKS).output().unwrap();
    let words = String::from_utf8(output.stdout).unwrap();
    assert!(
        words.contains(
            "and a student can change it: name a file of times in class.toml. Folders: bounce_"
        ),
        "{words}"
    );
    fs::remove_file(into.join("class.toml")).unwrap();
    assert_eq!(with(TASKS), (true, String::new()));
    assert_eq!(records(&class, &into), before);

    // With `--again`, the submission is graded again.
    let (well, words) = with(&["--no-timing", "--again", "--only", "untouched"]);
    assert!(!well && words.contains("the solution of lab 1 cannot be built"), "{words}");
    assert_eq!(records(&class, &into), before);

    // A changed submission is graded again, which needs a compiler.
    let source = class.folder().join("solved/labs/lab1/src/energy.rs");
    let text = fs::read_to_string(&source).unwrap();
    fs::write(&source, format!("{text}\n")).unwrap();
    let (well, words) = with(TASKS);
    assert!(!well && words.contains("the solution of lab 1 cannot be built"), "{words}");
    assert_eq!(record(&into, "solved").as_ref(), before.get("solved"));

    // A seed that letters will name must not be used for a first grading.
    assert!(!words.contains("--seed"), "{words}");
    fs::remove_file(into.join("untouched.json")).unwrap();
    let (_, words) = with(&["--no-timing", "--seed", "7"]);
    assert!(words.contains("--seed: letters name it"), "{words}");
}
