//! `cargo lab grade`, as an instructor runs it.

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
use crate::sources::kit;

/// What an attack looks for in our environment.
const SECRET: (&str, &str) = ("CUTOFF_TEST_SECRET", "31415926");

/// Seconds for a question. Most take less than one, and a submission that hangs takes all of them.
const LIMIT: &str = "10";

/// What it says where there is no sandbox.
pub(crate) const NO_SANDBOX: &str = "cannot be kept in a sandbox here";

/// Tasks only, no times.
pub(crate) const TASKS: &[&str] = &["--no-timing"];

/// The command that grades a class.
pub(crate) fn grade(class: &Class, into: &Path, options: &[&str]) -> Command {
    compile_what_all_need();
    grade_as_it_is(class, into, options)
}

/// What the lab of the quick tests depends on is compiled once, before several tests would do it at a time.
pub(crate) fn compile_what_all_need() {
    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        let class = Class::alone(QUICK);
        // Where it fails, the tests say why.
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
        // What a killed command leaves lies here, and goes with the class.
        .env("TMPDIR", class.temporary())
        .process_group(0);
    command
}

/// Writes a shell script that can be run.
pub(crate) fn script(path: &Path, text: &str) {
    fs::write(path, format!("#!/bin/sh\n{text}\n")).unwrap();
    fs::set_permissions(path, fs::Permissions::from_mode(0o755)).unwrap();
}

/// Where a program is; none if it is not on the path.
pub(crate) fn program(name: &str) -> Option<PathBuf> {
    let path = std::env::var_os("PATH").unwrap_or_default();
    let mut paths = std::env::split_paths(&path).map(|folder| folder.join(name));
    paths.find(|program| program.is_file())
}

/// Somebody's record; none if it is not there yet.
pub(crate) fn record(into: &Path, name: &str) -> Option<Value> {
    let text = fs::read(into.join(format!("{name}.json"))).ok()?;
    Some(serde_json::from_slice(&text).unwrap_or_else(|e| panic!("the record of {name}: {e}")))
}

/// The records that are there, by name.
pub(crate) fn records(class: &Class, into: &Path) -> BTreeMap<String, Value> {
    let names = class.members.iter().map(|(name, _)| name);
    names.filter_map(|name| Some((name.clone(), record(into, name)?))).collect()
}

/// Who has other marks than must be, and how.
pub(crate) fn complaints(class: &Class, into: &Path) -> Vec<String> {
    let complaints = class.members.iter().filter_map(|(name, expected)| {
        let Some(record) = record(into, name) else { return Some(format!("{name}: no record")) };
        let what = expected.differs(&record)?;
        let lost: Vec<&str> = lost_tasks(&record).collect();
        Some(format!("{name}: {what} (lost {lost:?}): {record:#}"))
    });
    complaints.collect()
}

/// Runs the command, and kills it, and nobody else, as soon as `enough` says so. It is false if
/// there is no sandbox here.
pub(crate) fn kill_when(mut command: Command, enough: impl Fn() -> bool) -> bool {
    let mut child = command.stdout(Stdio::null()).stderr(Stdio::piped()).spawn().unwrap();
    while !enough() {
        if child.try_wait().unwrap().is_some() {
            let output = child.wait_with_output().unwrap();
            let said = String::from_utf8_lossy(&output.stderr).into_owned();
            assert!(said.contains(NO_SANDBOX), "it ended before it was killed: {said}");
            eprintln!("skipped: {said}");
            return false;
        }
        thread::sleep(Duration::from_millis(50));
    }
    child.kill().unwrap();
    child.wait().unwrap();
    true
}

/// Runs the command to its end, which must be a good one. It is false if there is no sandbox here.
pub(crate) fn run(mut command: Command) -> bool {
    let output = command.output().unwrap();
    let said = String::from_utf8_lossy(&output.stderr);
    if said.contains(NO_SANDBOX) {
        eprintln!("skipped: {said}");
        return false;
    }
    print!("{}", String::from_utf8_lossy(&output.stdout));
    assert!(output.status.success(), "one submission stopped the others: {said}");
    true
}
