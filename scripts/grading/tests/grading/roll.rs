//! A class with a roster, a deadline and decisions: what `cargo lab regrade` makes of it.

use std::fs;
use std::path::Path;
use std::process::Command;

use serde_json::{Value, json};

use crate::sources::{kit, tasks};

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

/// A record of lab 1 with its first task right, handed in an hour too late.
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

fn regrade(folder: &Path) -> String {
    let mut command = Command::new(env!("CARGO_BIN_EXE_lab-grading"));
    let output = command.current_dir(kit()).arg("regrade").arg(folder).output().unwrap();
    let said = [output.stdout, output.stderr].map(|said| String::from_utf8(said).unwrap());
    assert!(output.status.success(), "{}", said[1]);
    said.concat()
}

#[test]
fn decisions_and_lateness_survive_a_regrade() {
    let folder = tempfile::tempdir().unwrap();
    let put = |name: &str, text: &str| fs::write(folder.path().join(name), text).unwrap();
    let read = |name: &str| fs::read_to_string(folder.path().join(name)).unwrap();
    put("class.toml", CLASS);
    put("roster.csv", ROSTER);
    for name in ["ada", "grace"] {
        put(&format!("{name}.json"), &record(name).to_string());
    }
    let said = regrade(folder.path());
    assert!(said.contains("Handed in nothing: Turing, Alan"), "{said}");
    assert!(
        said.contains("a person decided so")
            && said.contains("a day late for 10 %, before in time"),
        "{said}"
    );

    let once = ["marks.csv", "ada.json", "grace.json", "feedback/ada.md", "index.html"].map(read);
    assert!(regrade(folder.path()).contains("0 of 2 changed"));
    let again = ["marks.csv", "ada.json", "grace.json", "feedback/ada.md", "index.html"].map(read);
    assert_eq!(once, again);

    let [marks, _, _, letter, page] = once;
    // (20 + 12.5) less a tenth; 50 by hand are 50.
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

    // Whoever is no longer decided about has the grader's points again.
    put("class.toml", "");
    regrade(folder.path());
    assert_eq!(serde_json::from_str::<Value>(&read("grace.json")).unwrap()["points"], 20.0);
}

#[test]
fn who_is_spoken_of_and_is_not_there_is_named() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("ada.json"), record("ada").to_string()).unwrap();
    let class = "[[override]]\nstudent = \"adda\"\npoints = 1\nreason = \"r\"\n";
    fs::write(folder.path().join("class.toml"), class).unwrap();
    let said = regrade(folder.path());
    assert!(said.contains("class.toml: override 1: no submission belongs to 'adda'"), "{said}");
}
