//! `cargo lab regrade` with a rubric of one's own.

use std::process::Command;

use lab_kit::Kit;

/// What is said on stdout and stderr where the two tasks of a record are worth so much.
fn regraded(points: [u32; 2]) -> [String; 2] {
    let folder = tempfile::tempdir().unwrap();
    let [first, second] = points;
    let rubric = format!("[lab1.tasks]\n\"1.1\" = {first}\n\"1.2\" = {second}\n");
    let files = [
        ("labs/common/Cargo.toml", ""),
        ("records/ada.json", include_str!("../record.json")),
        ("tests/rubric.toml", &rubric),
    ];
    let kit = Kit::of_files(folder.path(), &files);
    let mut command = Command::new(env!("CARGO_BIN_EXE_lab-grading"));
    command.current_dir(kit.root()).args(["regrade", "records", "--dry-run"]);
    let output = command.output().unwrap();
    assert!(output.status.success());
    [output.stdout, output.stderr].map(|said| String::from_utf8(said).unwrap())
}

#[test]
fn a_rubric_of_more_than_a_hundred_points_is_pointed_out() {
    let [changes, warning] = regraded([70, 30]);
    assert!(changes.contains("1 of 1 changed") && warning.is_empty(), "{changes}{warning}");
    let [changes, warning] = regraded([60, 50]);
    assert!(changes.contains("1 of 1 changed"), "{changes}");
    assert_eq!(warning.lines().count(), 1, "{warning}");
    assert!(warning.contains("the tasks of lab 1 add up to 110, not 100"), "{warning}");
}
