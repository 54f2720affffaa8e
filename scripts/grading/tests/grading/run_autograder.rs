//! Tests `run_autograder` in the folders that Gradescope provides.

use std::ffi::OsString;
use std::fs;
use std::os::unix::fs::{MetadataExt, PermissionsExt, symlink};
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use lab_kit::files::write_file;
use serde_json::Value;
use tempfile::TempDir;

use crate::archives;
use crate::cheats::QUICK;
use crate::grade_command::{compile_what_all_need, script};
use crate::solution::{Files, kit, solution, with};

/// Shell script that mounts a compiler and the sources of dependencies, then runs the autograder.
///
/// `$0` is the top folder, `$1` the compiler's folder, and `$2` the folder of the sources.
const WITHOUT_NAMESPACES: &str = "mount --bind \"$1\" \"$0/rust\" && mount --bind \"$2\" \"$0/cargo/registry\" && \
                                  export CARGO_HOME=\"$0/cargo\" && exec sh \"$0/run_autograder\"";

/// Script with the message of bubblewrap in a container that allows no namespaces.
const REFUSED: &str = "echo 'bwrap: No permissions to create new namespace' >&2; exit 1";

/// A container of lab 1.
struct Container(TempDir);

impl Container {
    /// Makes a container with a student's submission.
    fn of(hand_in: impl Fn(&Path)) -> Self {
        compile_what_all_need();
        let folder = tempfile::tempdir().unwrap();
        let top = folder.path();
        fs::set_permissions(top, fs::Permissions::from_mode(0o755)).unwrap();
        for folder in ["source", "submission", "temporary", "bin", "rust", "cargo/registry"] {
            fs::create_dir_all(top.join(folder)).unwrap();
        }
        fs::write(top.join("source/lab"), format!("{}\n", QUICK)).unwrap();
        symlink(kit(), top.join("source/kit")).unwrap();
        let autograder = kit().join("scripts/gradescope/run_autograder");
        fs::copy(autograder, top.join("run_autograder")).unwrap();
        fs::write(top.join("submission_metadata.json"), "{}").unwrap();
        hand_in(&top.join("submission"));
        // `cargo lab` runs the tested command, because Cargo would build it again.
        let lab = env!("CARGO_BIN_EXE_lab-grading");
        script(&top.join("bin/cargo"), &format!("shift; exec '{lab}' \"$@\""));
        Self(folder)
    }

    fn top(&self) -> &Path {
        self.0.path()
    }

    /// Runs a command in the container, with these folders first on the path.
    fn run(&self, command: &mut Command, first: &[&str]) -> Output {
        let mut path: Vec<PathBuf> = first.iter().map(|folder| self.top().join(folder)).collect();
        path.extend(std::env::split_paths(&std::env::var_os("PATH").unwrap_or_default()));
        command
            .current_dir(self.top())
            .env("AUTOGRADER", self.top())
            .env("TMPDIR", self.top().join("temporary"))
            .env("RUSTUP_HOME", home("RUSTUP_HOME", ".rustup"))
            .env("CARGO_HOME", home("CARGO_HOME", ".cargo"))
            // With the libraries of Cargo's compiler, the mounted compiler would name their folder.
            .env_remove("LD_LIBRARY_PATH")
            .env("PATH", std::env::join_paths(path).unwrap())
            .output()
            .unwrap()
    }

    /// Reads the results for Gradescope.
    fn results(&self, output: &Output) -> Value {
        let message = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{message}");
        let results = fs::read(self.top().join("results/results.json"));
        serde_json::from_slice(&results.unwrap_or_else(|e| panic!("{e}: {message}"))).unwrap()
    }
}

fn home(variable: &str, folder: &str) -> PathBuf {
    let set: Option<OsString> = std::env::var_os(variable);
    set.map_or_else(|| std::env::home_dir().unwrap().join(folder), PathBuf::from)
}

/// Runs the autograder of lab 1 on a student's submission.
fn graded(hand_in: impl Fn(&Path)) -> Value {
    let container = Container::of(hand_in);
    let autograder = container.top().join("run_autograder");
    let output = container.run(Command::new("sh").arg(autograder), &["bin"]);
    container.results(&output)
}

/// Runs the autograder with a bubblewrap that fails; `None` if this machine cannot do that.
///
/// The autograder runs as root of a namespace, in which every user can find the compiler.
fn graded_without_namespaces(hand_in: impl Fn(&Path)) -> Option<Value> {
    let is_root = fs::metadata("/proc/self").is_ok_and(|own| own.uid() == 0);
    let unshared = Command::new("unshare").args(["--mount", "true"]).status();
    if !is_root || !unshared.is_ok_and(|it| it.success()) {
        return None;
    }
    let container = Container::of(hand_in);
    let top = container.top();
    script(&top.join("bin/bwrap"), REFUSED);
    let rustc = Command::new("rustc").args(["--print", "sysroot"]).current_dir(kit()).output();
    let sysroot = String::from_utf8(rustc.unwrap().stdout).unwrap();
    let mut command = Command::new("unshare");
    command.args(["--mount", "sh", "-c", WITHOUT_NAMESPACES]).arg(top).arg(sysroot.trim());
    command.arg(home("CARGO_HOME", ".cargo").join("registry"));
    let output = container.run(&mut command, &["bin", "rust/bin"]);
    Some(container.results(&output))
}

/// Writes a submission as a folder of lab 1.
fn folder(submission: &Path, files: Files) {
    for (path, text) in files {
        write_file(&submission.join("my-kit/labs/lab1").join(path), text).unwrap();
    }
}

#[test]
fn gradescope_shows_a_student_what_is_right_and_what_is_not() {
    // Gradescope unpacks a .zip, and keeps other archives.
    let solved = graded(|submission| folder(submission, solution(1)));
    assert_eq!(solved["score"], 100.0);
    for test in solved["tests"].as_array().unwrap() {
        assert!(test["score"] == test["max_score"] && test["score"] != 0.0, "{solved}");
    }

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

#[test]
fn a_grader_that_does_not_run_leaves_no_points() {
    let container = Container::of(|submission| folder(submission, solution(1)));
    let top = container.top();
    fs::create_dir(top.join("results")).unwrap();
    fs::write(top.join("results/results.json"), "{ \"score\": 0 }").unwrap();
    script(&top.join("bin/cargo"), "echo 'error: no space left' >&2; exit 2");
    let autograder = top.join("run_autograder");
    let output = container.run(Command::new("sh").arg(autograder), &["bin"]);
    let message = String::from_utf8_lossy(&output.stderr);
    assert!(!output.status.success() && message.contains("no space left"), "{message}");
    assert!(!top.join("results/results.json").exists(), "Gradescope would take it for a mark");
}

/// Writes a submission whose code reaches for the files of the autograder, which are below `TOP`.
fn reach(submission: &Path, code: &str) {
    let top = submission.parent().unwrap().display().to_string();
    folder(submission, with(1, &[("1.4", &code.replace("TOP", &top))]));
}

/// This test compiles the lab's dependencies twice, so scripts/test.sh runs it in a separate stage.
#[test]
#[ignore = "takes minutes"]
fn without_namespaces_a_submission_reads_no_solution_and_writes_no_results() {
    let at_run_time = "let read = std::fs::read(\"TOP/source/kit/solutions/lab1/src/force.rs\").map_err(|e| e.kind());
        let wrote = std::fs::write(\"TOP/results/results.json\", \"{}\").map_err(|e| e.kind());
        let of_kit = std::fs::write(\"TOP/source/lab\", \"2\").map_err(|e| e.kind());
        panic!(\"read {read:?}, wrote {wrote:?}, {of_kit:?}\");";
    let Some(seen) = graded_without_namespaces(|submission| reach(submission, at_run_time)) else {
        eprintln!("left out: only root can become nobody");
        return;
    };
    let denied = "read Err(PermissionDenied), wrote Err(PermissionDenied), Err(PermissionDenied)";
    assert!(seen.to_string().contains(denied), "{seen}");
    assert_eq!(seen["extra_data"]["sandboxed"], false);
    assert!(
        (1.0..100.0).contains(&seen["score"].as_f64().unwrap()),
        "the results are the grader's: {seen}"
    );

    let by_the_compiler =
        "panic!(\"{}\", include_str!(\"TOP/source/kit/solutions/lab1/src/force.rs\"));";
    let built = graded_without_namespaces(|submission| reach(submission, by_the_compiler)).unwrap();
    assert_eq!(built["score"], 0.0, "{built}");
    assert!(built["output"].as_str().unwrap().contains("does not compile"), "{built}");
}
