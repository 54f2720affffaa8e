//! Tests that submissions do not run without a sandbox unless the instructor allows it.

use std::fs;
use std::os::unix::fs::symlink;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::cheats::QUICK;
use crate::class::Class;
use crate::grade_command::{TASKS, grade, program, record, script};

/// Programs that grading needs in addition to the sandbox.
const NEEDED: [&str; 9] =
    ["cargo", "rustc", "rustfmt", "cc", "ld", "as", "cp", "setpriv", "prlimit"];

/// Makes a folder for the path, with the needed programs and without bubblewrap.
fn path_without(top: &Path) -> PathBuf {
    let folder = top.join("bin");
    fs::create_dir_all(&folder).unwrap();
    for (name, program) in NEEDED.iter().filter_map(|name| Some((name, program(name)?))) {
        symlink(program, folder.join(name)).unwrap();
    }
    folder
}

/// Returns the single line that a refusing command prints.
fn refusal(mut command: Command) -> String {
    let output = command.output().unwrap();
    assert_eq!(output.status.code(), Some(2));
    let message = String::from_utf8(output.stderr).unwrap();
    assert_eq!(message.lines().count(), 1, "{message}");
    assert!(message.contains("cannot be kept in a sandbox here"), "{message}");
    assert!(message.contains("say --trusted"), "{message}");
    message
}

#[test]
fn without_a_sandbox_it_refuses_unless_the_code_is_trusted() {
    let class = Class::alone(QUICK);
    let into = class.temporary().join("records");
    let path = path_without(&class.temporary());
    let command = |options: &[&str]| {
        let mut command = grade(&class, &into, &[TASKS, options].concat());
        command.env("PATH", &path);
        command
    };
    let message = refusal(command(&[]));
    assert!(message.contains("there is no bwrap"), "{message}");

    // This bubblewrap is not allowed to make namespaces, as in most containers.
    let bwrap = path.join("bwrap");
    script(&bwrap, "echo 'bwrap: No permissions to create new namespace' >&2; exit 1");
    let message = refusal(command(&[]));
    assert!(message.contains("No permissions to create new namespace"), "{message}");
    // This bubblewrap isolates nothing.
    script(&bwrap, "exit 0");
    let message = refusal(command(&[]));
    assert!(message.contains("does not keep out what it must"), "{message}");
    assert!(!into.exists(), "nothing was graded");

    fs::remove_file(&bwrap).unwrap();
    let output = command(&["--trusted"]).output().unwrap();
    let message = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success() && message.contains("NO SANDBOX"), "{message}");
    let record = record(&into, "solved").unwrap();
    assert_eq!((&record["sandboxed"], &record["points"]), (&false.into(), &100.0.into()));
}
