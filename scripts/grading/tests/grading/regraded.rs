//! Tests `cargo lab regrade` with a different rubric, and with a roster, a deadline and decisions.

use std::fs;
use std::path::Path;
use std::process::Command;

use lab_kit::Kit;
use serde_json::{Value, json};
use tempfile::TempDir;

use crate::solution::{kit, tasks};

const CLASS: &str = r#"
roster = "roster.csv"

[late]
deadline = "2026-11-20T22:59:00Z"
penalty = 10

[[override]]
student = "Lovelace, Ada"
task = "1.2"
points = 12.5
reason = "The idea is right, *one* sign is not"

[[override]]
student = "grace"
points = 50
reason = "Explained it at the blackboard"
"#;

const ROSTER: &str = "Student,ID,SIS Login ID,Section,Lab 1 (7)\n\
    Points Possible,,,,100\n\
    \"Lovelace, Ada\",1,ada,A,\n\
    \"Hopper, Grace\",2,grace,A,\n\
    \"Turing, Alan\",3,alan,A,\n";

/// Makes a record of lab 1 with its first task right, handed in an hour too late.
fn record(name: &str) -> Value {
    let mut record: Value = serde_json::from_str(include_str!("../record.json")).unwrap();
    let all = tasks(1).into_iter().enumerate().map(|(at, id)| {
        json!({"id": id, "passed": at == 0, "message": "no", "points": 0.0, "out_of": 0.0})
    });
    record["tasks"] = all.collect();
    record["name"] = name.into();
    record["handed_in"] = "2026-11-20T23:59:00Z".into();
    record
}

/// Runs `cargo lab regrade`; returns stdout and stderr.
fn regrade(kit: &Path, folder: &Path, options: &[&str]) -> [String; 2] {
    let mut command = Command::new(env!("CARGO_BIN_EXE_lab-grading"));
    let command = command.current_dir(kit).arg("regrade").arg(folder).args(options);
    let output = command.output().unwrap();
    let message = [output.stdout, output.stderr].map(|message| String::from_utf8(message).unwrap());
    assert!(output.status.success(), "{}", message[1]);
    message
}

/// Makes a kit whose two tasks of lab 1 are worth `points`. It contains the records of two grading
/// runs.
fn kit_of(points: [u32; 2]) -> (TempDir, Kit) {
    let folder = tempfile::tempdir().unwrap();
    let [first, second] = points;
    let facts = format!(
        "title = 'x'\ndiscs = 'soft'\nworkers = 'threads'\n[tasks]\n\
         '1.1' = {{ points = {first}, hours = 1, mark = 1, section = 'x' }}\n\
         '1.2' = {{ points = {second}, hours = 1, mark = 1, section = 'x' }}\n"
    );
    let ada = include_str!("../record.json");
    let other = ada.replace("\"seed\": 7", "\"seed\": 8").replace("rustc ", "rustc 0");
    let files = [
        ("labs/common/Cargo.toml", ""),
        ("records/ada.json", ada),
        ("before/ada.json", &other),
        ("before/bob.json", &other.replace("\"ada\"", "\"bob\"")),
        ("solutions/lab1/lab.toml", &facts),
    ];
    let kit = Kit::of_files(folder.path(), &files);
    (folder, kit)
}

#[test]
fn a_rubric_of_more_than_a_hundred_points_is_pointed_out() {
    for (points, warned) in
        [([70, 30], ""), ([60, 50], "the tasks of lab 1 add up to 110, not 100")]
    {
        let (_folder, kit) = kit_of(points);
        let [changes, warning] = regrade(kit.root(), "records".as_ref(), &["--dry-run"]);
        assert!(changes.contains("1 of 1 would change."), "{changes}");
        assert_eq!(warning.lines().count(), usize::from(!warned.is_empty()), "{warning}");
        assert!(warning.contains(warned), "{warning}");
    }
}

#[test]
fn another_grading_is_compared_with_this_one() {
    let (_folder, kit) = kit_of([70, 30]);
    let options = ["--dry-run", "--since", "before"];
    let [changes, _] = regrade(kit.root(), "records".as_ref(), &options);
    assert!(changes.starts_with("ada: 70 of 100, before 60 of 100\n"), "{changes}");
    for line in ["- | Task 1.1 | 60 of 60 |", "+ | Task 1.1 | 70 of 70 |", "- Compiler: rustc 0"] {
        assert!(changes.contains(line), "{line}: {changes}");
    }
    assert!(changes.contains("with the inputs of seed 8"), "{changes}");
    assert!(changes.ends_with("bob: it is no longer there\n1 of 1 changed.\n"), "{changes}");
}

#[test]
fn decisions_and_lateness_survive_a_regrade() {
    let folder = tempfile::tempdir().unwrap();
    let read = |name: &str| fs::read_to_string(folder.path().join(name)).unwrap();
    for (name, text) in [
        ("class.toml", CLASS),
        ("roster.csv", ROSTER),
        ("ada.json", &record("ada").to_string()),
        ("grace.json", &record("grace").to_string()),
    ] {
        fs::write(folder.path().join(name), text).unwrap();
    }
    let message = regrade(kit(), folder.path(), &[]).concat();
    assert!(message.contains("Handed in nothing: Turing, Alan"), "{message}");
    assert!(
        message.contains("+ Task 1.2: Your instructor gave 12.5 points")
            && message.contains("It came a day late, which costs 10 % of the points."),
        "{message}"
    );

    let once = ["marks.csv", "ada.json", "grace.json", "feedback/ada.md", "index.html"].map(read);
    assert!(regrade(kit(), folder.path(), &[]).concat().contains("0 of 2 changed"));
    let again = ["marks.csv", "ada.json", "grace.json", "feedback/ada.md", "index.html"].map(read);
    assert_eq!(once, again);

    let [marks, _, _, letter, page] = once;
    assert!(letter.contains("\u{201c}Walls\u{201d} in Lab 1"), "{letter}");
    assert!(read("class.csv").contains("\ngrace,"));
    assert!(read("gradescope/grace.json").contains("\"output_format\": \"md\""));
    // The marks are 20 + 12.5 less a tenth. Points that a person gave have no penalty: 50 remain
    // 50.
    assert!(marks.contains("\"Lovelace, Ada\",1,ada,A,29.25\n"), "{marks}");
    assert!(marks.contains("\"Hopper, Grace\",2,grace,A,50\n"), "{marks}");
    assert!(marks.contains("\"Turing, Alan\",3,alan,A,\n"), "{marks}");
    assert!(
        letter.contains(
            "**Lovelace, Ada**: 29.25 of 100 points. It came a day late, which costs 10 %"
        ),
        "{letter}"
    );
    assert!(letter.contains("| 12.5 of 20 **by hand** |"), "{letter}");
    assert!(
        letter.contains("gave 12.5 points: The idea is right, \\*one\\* sign is not"),
        "{letter}"
    );
    assert!(page.contains("<b>Handed in nothing: </b>Turing, Alan"), "{page}");
    assert!(
        page.contains("<span class=\"hand\" title=\"Your instructor gave 12.5 points"),
        "{page}"
    );

    // Without the decision, the submission has the grader's points again.
    fs::write(folder.path().join("class.toml"), "").unwrap();
    regrade(kit(), folder.path(), &[]);
    assert_eq!(serde_json::from_str::<Value>(&read("grace.json")).unwrap()["points"], 20.0);
}

#[test]
fn who_is_spoken_of_and_is_not_there_is_named() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("ada.json"), record("ada").to_string()).unwrap();
    let class = "[[override]]\nstudent = \"adda\"\npoints = 1\nreason = \"r\"\n";
    fs::write(folder.path().join("class.toml"), class).unwrap();
    let message = regrade(kit(), folder.path(), &[]).concat();
    assert!(
        message.contains("class.toml: override 1: no submission belongs to 'adda'"),
        "{message}"
    );
}

#[test]
#[cfg(target_os = "linux")]
fn a_full_disk_behind_standard_output_is_said_in_one_line() {
    let (_folder, kit) = kit_of([70, 30]);
    let full = fs::File::options().write(true).open("/dev/full").unwrap();
    let mut command = Command::new(env!("CARGO_BIN_EXE_lab-grading"));
    let command = command.current_dir(kit.root()).args(["regrade", "records", "--dry-run"]);
    let output = command.stdout(full).output().unwrap();
    let message = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{message}");
    assert!(message.starts_with("error: cannot write to standard output: "), "{message}");
    assert_eq!(message.lines().count(), 1, "{message}");
}
