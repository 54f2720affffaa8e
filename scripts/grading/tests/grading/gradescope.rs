//! `run_autograder`, in the folders that Gradescope lays out.

use std::fs;
use std::os::unix::fs::{PermissionsExt, symlink};
use std::path::Path;
use std::process::Command;

use serde_json::Value;

use crate::archives;
use crate::cheats::QUICK;
use crate::command::{compile_what_all_need, script};
use crate::sources::{Files, kit, solution, with};

/// Runs the autograder of lab 1 on what a student has handed in.
fn graded(hand_in: impl Fn(&Path)) -> Value {
    compile_what_all_need();
    let folder = tempfile::tempdir().unwrap();
    let top = folder.path();
    fs::set_permissions(top, fs::Permissions::from_mode(0o755)).unwrap();
    for folder in ["source", "submission", "temporary", "bin"] {
        fs::create_dir(top.join(folder)).unwrap();
    }
    fs::write(top.join("source/lab"), format!("{}\n", QUICK)).unwrap();
    symlink(kit(), top.join("source/kit")).unwrap();
    fs::copy(kit().join("scripts/gradescope/run_autograder"), top.join("run_autograder")).unwrap();
    fs::write(top.join("submission_metadata.json"), "{}").unwrap();
    hand_in(&top.join("submission"));

    // `cargo lab` is the command that is tested: it would be built anew otherwise.
    let lab = env!("CARGO_BIN_EXE_lab-grading");
    script(&top.join("bin/cargo"), &format!("shift; exec '{lab}' \"$@\""));
    let mut path = vec![top.join("bin")];
    path.extend(std::env::split_paths(&std::env::var_os("PATH").unwrap_or_default()));
    let output = Command::new("sh")
        .arg(top.join("run_autograder"))
        .current_dir(top)
        .env("AUTOGRADER", top)
        .env("TMPDIR", top.join("temporary"))
        // It looks for the compiler's own path there.
        .env("HOME", top)
        .env("RUSTUP_HOME", home("RUSTUP_HOME", ".rustup"))
        .env("CARGO_HOME", home("CARGO_HOME", ".cargo"))
        .env("PATH", std::env::join_paths(path).unwrap())
        .output()
        .unwrap();
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{said}");
    let results =
        fs::read(top.join("results/results.json")).unwrap_or_else(|e| panic!("{e}: {said}"));
    serde_json::from_slice(&results).unwrap()
}

fn home(variable: &str, folder: &str) -> std::path::PathBuf {
    let set = std::env::var_os(variable).map(Into::into);
    set.unwrap_or_else(|| std::env::home_dir().unwrap().join(folder))
}

#[test]
fn gradescope_shows_a_student_what_is_right_and_what_is_not() {
    // Gradescope unpacks a .zip, and keeps other archives as they are.
    let folder = |submission: &Path, files: Files| {
        for (path, text) in files {
            let path = submission.join("my-kit/labs/lab1").join(path);
            fs::create_dir_all(path.parent().unwrap()).unwrap();
            fs::write(path, text).unwrap();
        }
    };
    let solved = graded(|submission| folder(submission, solution(1)));
    assert_eq!(solved["score"], 100.0);
    let all = |test: &Value| test["score"] == test["max_score"] && test["score"] != 0.0;
    assert!(solved["tests"].as_array().unwrap().iter().all(all), "{solved}");

    let half = with(1, &[("1.4", "todo!(\"task 1.4\")")]);
    let half = graded(|submission| {
        fs::write(submission.join("lab1.tar.gz"), archives::tar(1, &half)).unwrap();
    });
    let tests = half["tests"].as_array().unwrap();
    let lost = tests.iter().find(|test| test["score"] == 0.0).unwrap();
    assert!((1.0..100.0).contains(&half["score"].as_f64().unwrap()), "{half}");
    assert!(lost["name"].as_str().unwrap().starts_with("Task 1.4: "));
    let output = lost["output"].as_str().unwrap();
    assert!(output.contains("task 1.4") && output.contains("\nRead \u{201c}"), "{output}");

    let none = graded(|submission| fs::write(submission.join("essay.pdf"), "an essay").unwrap());
    assert_eq!(none["score"], 0.0);
    assert!(none["output"].as_str().unwrap().contains("has nothing for this lab"));
}
