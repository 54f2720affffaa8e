//! A class full of cheats, graded as an instructor would: `cargo lab grade CLASS --lab 1`.
//!
//! Every submission is the solution of lab 1 with something added, so whoever does not get full
//! marks has lost them by the cheat, and whoever gets them has tried in vain.

mod class;

use std::collections::BTreeMap;
use std::fs;
use std::os::unix::process::CommandExt;
use std::path::Path;
use std::process::{Command, Stdio};
use std::thread;
use std::time::Duration;

use class::{CHEATS, Class};
use serde_json::Value;

/// What an attack looks for in our environment.
const SECRET: (&str, &str) = ("CUTOFF_TEST_SECRET", "31415926");

/// Seconds for a probe. Probes take one, and those who hang take all of them.
const LIMIT: &str = "15";

fn grade(class: &Class, into: &Path) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_lab"));
    command
        .current_dir(class::kit())
        .args(["grade", "--lab", "1", "--no-tests", "--no-timing", "--limit", LIMIT, "--into"])
        .arg(into)
        .arg(class.folder())
        .env(SECRET.0, SECRET.1)
        // What a killed command leaves lies here, and goes with the class.
        .env("TMPDIR", class.temporary())
        .process_group(0);
    command
}

fn record(into: &Path, name: &str) -> Value {
    let path = into.join(format!("{name}.json"));
    let text = fs::read(&path).unwrap_or_else(|e| panic!("there is no record of {name}: {e}"));
    serde_json::from_slice(&text).unwrap_or_else(|e| panic!("the record of {name}: {e}"))
}

/// The numbers that the records' inputs came from, by name: who is graded again gets another.
fn seeds(into: &Path) -> BTreeMap<String, Value> {
    let entries = fs::read_dir(into).into_iter().flatten().flatten();
    let names = entries.filter_map(|entry| {
        let name = entry.file_name().into_string().ok()?;
        Some(name.strip_suffix(".json")?.to_owned())
    });
    let names = names.filter(|name| CHEATS.iter().any(|(cheat, _)| cheat == name));
    names.map(|name| (name.clone(), record(into, &name)["seed"].clone())).collect()
}

/// Kills the command, and nobody else, as soon as some records are there.
fn begin_and_kill(class: &Class, into: &Path) -> Option<BTreeMap<String, Value>> {
    let mut command = grade(class, into);
    let mut child = command.stdout(Stdio::null()).stderr(Stdio::piped()).spawn().unwrap();
    while seeds(into).len() < 2 {
        if child.try_wait().unwrap().is_some() {
            let output = child.wait_with_output().unwrap();
            let said = String::from_utf8_lossy(&output.stderr).into_owned();
            if said.contains("cannot be kept in a sandbox here") {
                eprintln!("skipped: {said}");
                return None;
            }
            panic!("it ended before it was killed: {said}");
        }
        thread::sleep(Duration::from_millis(50));
    }
    child.kill().unwrap();
    child.wait().unwrap();
    Some(seeds(into))
}

#[test]
fn cheats_gain_nothing_and_a_killed_class_goes_on() {
    let class = Class::make();
    let into = class.temporary().join("records");
    let Some(before) = begin_and_kill(&class, &into) else { return };
    assert!(before.len() < CHEATS.len(), "it was killed half-way");

    let output = grade(&class, &into).output().unwrap();
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "one submission stopped the others: {said}");
    let after = seeds(&into);
    for (name, seed) in &before {
        assert_eq!(after.get(name), Some(seed), "{name} was graded again");
    }
    let complaints = CHEATS.iter().filter_map(|(name, expected)| {
        let record = record(&into, name);
        let what = expected.differs(&record)?;
        Some(format!("{name}: {what}: {record:#}"))
    });
    let complaints: Vec<String> = complaints.collect();
    assert!(complaints.is_empty(), "{}", complaints.join("\n"));
    class.assert_nothing_escaped();
}
