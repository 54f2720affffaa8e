//! Tests faults of the machine.
//!
//! No submission loses a mark, and the next grading run grades the submissions that were not
//! graded.

use std::fs;
use std::os::unix::fs::PermissionsExt;
use std::process::Command;

use crate::class::Class;
use crate::grade_command::{NO_SANDBOX, TASKS, grade, program, record, script};

/// Faults: a phase of grading, and the shell commands that run instead of it.
///
/// The first two builds are builds of the solution, so a fault affects only later builds, or the
/// questions after the builds.
const FAULTS: [(&str, &str); 2] = [
    ("building", "echo 'error: failed to write x: No space left on device' >&2; exit 101"),
    ("asking", "echo '/bin/sh: 1: exec: bwrap: not found' >&2; exit 127"),
];

/// Writes a bubblewrap that can fail.
///
/// While its folder contains a file `building` or `asking`, it runs the commands in that file and
/// fails.
fn lay(class: &Class) -> std::path::PathBuf {
    let folder = class.temporary().join("bin");
    fs::create_dir_all(&folder).unwrap();
    // Programs are started as nobody.
    fs::set_permissions(&folder, fs::Permissions::from_mode(0o777)).unwrap();
    let own = folder.display();
    let real = program("bwrap").unwrap_or_default();
    let text = format!(
        "case \" $* \" in\n\
         *' build '*) echo >> '{own}/builds'; fault='{own}/building'; first=3 ;;\n\
         *' /kit/answer '*) fault='{own}/asking'; first=4 ;;\n\
         *) fault=/none ;;\n\
         esac\n\
         if [ -e \"$fault\" ] && [ $(wc -l < '{own}/builds') -ge $first ]; then . \"$fault\"; fi\n\
         exec '{}' \"$@\"",
        real.display()
    );
    script(&folder.join("bwrap"), &text);
    folder
}

#[test]
fn a_fault_of_the_machine_costs_no_marks() {
    let class = Class::alone(1);
    let into = class.temporary().join("records");
    let bin = lay(&class);
    let path = format!("{}:{}", bin.display(), std::env::var("PATH").unwrap());
    let run = |options: &[&str]| {
        let _ = fs::remove_file(bin.join("builds"));
        let output = grade(&class, &into, options).env("PATH", &path).output().unwrap();
        (output.status.code(), String::from_utf8_lossy(&output.stderr).into_owned())
    };
    for (when, fault) in FAULTS {
        fs::write(bin.join(when), fault).unwrap();
        let (code, message) = run(TASKS);
        if message.contains(NO_SANDBOX) {
            return eprintln!("skipped: {message}");
        }
        let record = record(&into, "solved").unwrap();
        assert_eq!((code, &record["status"]), (Some(1), &"failed".into()), "{fault}: {message}");
        assert!(message.contains("because of a fault of this machine: "), "{fault}: {message}");
        fs::remove_file(bin.join(when)).unwrap();
    }
    let (code, message) = run(&["--no-timing", "--seed", "7"]);
    let record = record(&into, "solved").unwrap();
    assert_eq!((code, &record["points"]), (Some(0), &100.0.into()), "{message}");
    assert_eq!(record["seed"], 7, "it can be asked the same again");
}

#[test]
fn records_that_cannot_be_written_are_noticed_before_a_build() {
    let class = Class::alone(1);
    // No user can make a folder in `/proc`.
    let mut command: Command = grade(&class, "/proc/records".as_ref(), TASKS);
    let output = command.output().unwrap();
    let message = String::from_utf8_lossy(&output.stderr);
    if message.contains(NO_SANDBOX) {
        return eprintln!("skipped: {message}");
    }
    assert_eq!(output.status.code(), Some(2));
    assert!(message.starts_with("error: cannot write in /proc/records: "), "{message}");
}
