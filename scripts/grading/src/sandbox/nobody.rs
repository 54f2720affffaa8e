//! Replacement where no sandbox can be made: submissions run as the user nobody, with limits.
//!
//! Only root can become nobody, and the user nobody must be able to run the compiler.
//! `scripts/gradescope` provides both. A submission then reads and writes only files that are open
//! to every user.

use std::path::Path;
use std::process::{Command, Stdio};

use rustix::process::getuid;

use super::{ENVIRONMENT, NOBODY, PATH, PROGRAM, launcher};

/// Shell script that gives a tree to the user nobody and then runs the remaining arguments.
const OWN: &str = "chown -R \"$1:$1\" \"$2\" && shift 2 && exec \"$@\"";

/// Whether the user nobody can run the compiler in `sysroot` and read the sources in `cargo_home`.
pub(super) fn can_build(sysroot: &Path, cargo_home: &Path) -> bool {
    getuid().is_root()
        && succeeds(nobody().arg(sysroot.join("bin/rustc")).arg("--version"))
        && succeeds(nobody().args(["test", "-x"]).arg(cargo_home.join("registry")))
}

fn succeeds(command: &mut Command) -> bool {
    command.stdout(Stdio::null()).stderr(Stdio::null()).status().is_ok_and(|it| it.success())
}

/// Returns a command that runs a program of a submission as nobody.
pub(super) fn program(path: &Path) -> Command {
    let mut command = nobody();
    command.envs(ENVIRONMENT).arg("prlimit").args(PROGRAM).arg(path);
    command
}

/// Returns a command that gives `tree` to the user nobody and runs Cargo there as this user.
pub(super) fn cargo(sysroot: &Path, cargo_home: &Path, tree: &Path) -> Command {
    let programs = sysroot.join("bin");
    let mut command = launcher("sh");
    command.args(["-c", OWN, "sh", NOBODY]).arg(tree);
    command.arg("setpriv").args(AS_NOBODY).args(["prlimit", "--core=0"]);
    command.arg(programs.join("cargo"));
    command.envs(ENVIRONMENT).env("CARGO_HOME", cargo_home);
    command.env("PATH", format!("{}:{PATH}", programs.display()));
    command
}

const AS_NOBODY: [&str; 6] =
    ["--reuid", NOBODY, "--regid", NOBODY, "--clear-groups", "--no-new-privs"];

fn nobody() -> Command {
    let mut command = launcher("setpriv");
    command.args(AS_NOBODY);
    command
}
