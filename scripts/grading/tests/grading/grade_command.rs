//! Runs `cargo lab grade` as an instructor does.

use std::collections::BTreeMap;
use std::fs;
use std::os::unix::fs::PermissionsExt;
use std::os::unix::process::CommandExt;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::Once;
use std::thread;
use std::time::Duration;

use serde_json::Value;

use crate::cheats::QUICK;
use crate::class::Class;
use crate::expected::lost_tasks;
use crate::solution::kit;

/// Variable of the grader's environment that an attack looks for.
const SECRET: (&str, &str) = ("CUTOFF_TEST_SECRET", "31415926");

/// Time limit of a question in seconds. Most questions take less than a second, but a submission
/// that hangs takes the whole time.
const LIMIT: &str = "10";

/// Part of the message on a machine without a sandbox.
pub(crate) const NO_SANDBOX: &str = "cannot be kept in a sandbox here";

/// Options for grading tasks only.
pub(crate) const TASKS: &[&str] = &["--no-timing"];

/// Returns the command that grades a class.
pub(crate) fn grade(class: &Class, into: &Path, options: &[&str]) -> Command {
    compile_what_all_need();
    grade_as_it_is(class, into, options)
}

/// Compiles the dependencies of the quick tests' lab once, because the tests run at the same time.
pub(crate) fn compile_what_all_need() {
    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        let class = Class::alone(QUICK);
        // If grading fails here, the tests report the reason.
        let _ = grade_as_it_is(&class, &class.temporary().join("records"), TASKS).output();
    });
}

fn grade_as_it_is(class: &Class, into: &Path, options: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_lab-grading"));
    command
        .current_dir(kit())
        .args(["grade", "--lab", &class.lab.to_string(), "--limit", LIMIT, "--into"])
        .arg(into)
        .args(options)
        .arg(class.folder())
        .env(SECRET.0, SECRET.1)
        // A killed command leaves its files in this folder, which is removed with the class.
        .env("TMPDIR", class.temporary())
        .process_group(0);
    command
}

/// Writes an executable shell script.
pub(crate) fn script(path: &Path, text: &str) {
    fs::write(path, format!("#!/bin/sh\n{text}\n")).unwrap();
    fs::set_permissions(path, fs::Permissions::from_mode(0o755)).unwrap();
}

/// Finds a program; `None` if it is not on the path.
pub(crate) fn program(name: &str) -> Option<PathBuf> {
    let path = std::env::var_os("PATH").unwrap_or_default();
    let mut paths = std::env::split_paths(&path).map(|folder| folder.join(name));
    paths.find(|program| program.is_file())
}

/// Reads a submission's record; `None` if there is no record yet.
pub(crate) fn record(into: &Path, name: &str) -> Option<Value> {
    let text = fs::read(into.join(format!("{name}.json"))).ok()?;
    Some(serde_json::from_slice(&text).unwrap_or_else(|e| panic!("the record of {name}: {e}")))
}

/// Reads the records of a class, by name.
pub(crate) fn records(class: &Class, into: &Path) -> BTreeMap<String, Value> {
    let names = class.members.iter().map(|(name, _)| name);
    names.filter_map(|name| Some((name.clone(), record(into, name)?))).collect()
}

/// Lists the submissions whose marks differ from the expected marks.
pub(crate) fn complaints(class: &Class, into: &Path) -> Vec<String> {
    let complaints = class.members.iter().filter_map(|(name, expected)| {
        let Some(record) = record(into, name) else { return Some(format!("{name}: no record")) };
        let what = expected.differs(&record)?;
        let lost: Vec<&str> = lost_tasks(&record).collect();
        Some(format!("{name}: {what} (lost {lost:?}): {record:#}"))
    });
    complaints.collect()
}

/// Runs the command, and kills only this command as soon as `enough` is true. Returns false if
/// there is no sandbox.
pub(crate) fn kill_when(mut command: Command, enough: impl Fn() -> bool) -> bool {
    let mut child = command.stdout(Stdio::null()).stderr(Stdio::piped()).spawn().unwrap();
    while !enough() {
        if child.try_wait().unwrap().is_some() {
            let output = child.wait_with_output().unwrap();
            let message = String::from_utf8_lossy(&output.stderr).into_owned();
            assert!(message.contains(NO_SANDBOX), "it ended before it was killed: {message}");
            eprintln!("skipped: {message}");
            return false;
        }
        thread::sleep(Duration::from_millis(50));
    }
    child.kill().unwrap();
    child.wait().unwrap();
    true
}

/// Runs the command, which must succeed. Returns false if there is no sandbox.
pub(crate) fn run(mut command: Command) -> bool {
    let output = command.output().unwrap();
    let message = String::from_utf8_lossy(&output.stderr);
    if message.contains(NO_SANDBOX) {
        eprintln!("skipped: {message}");
        return false;
    }
    print!("{}", String::from_utf8_lossy(&output.stdout));
    assert!(output.status.success(), "one submission stopped the others: {message}");
    true
}
