//! The second line of defence, where no sandbox can be made: what was handed in runs as nobody, within limits.
//!
//! Only root can become nobody, and nobody must find the compiler: `scripts/gradescope` sees to both. Then a
//! submission reads and writes only what everybody may.

use std::path::Path;
use std::process::{Command, Stdio};

use rustix::process::getuid;

use super::{ENVIRONMENT, NOBODY, PATH, PROGRAM, launcher};

/// Changes the owner of a tree to nobody, who then may build there, and goes on with the arguments behind it.
const OWN: &str = "chown -R \"$1:$1\" \"$2\" && shift 2 && exec \"$@\"";

/// Whether nobody can run the compiler in `sysroot` and read the sources in `cargo_home`.
pub(super) fn can_build(sysroot: &Path, cargo_home: &Path) -> bool {
    let well = |command: &mut Command| {
        command.stdout(Stdio::null()).stderr(Stdio::null()).status().is_ok_and(|it| it.success())
    };
    getuid().is_root()
        && well(nobody().arg(sysroot.join("bin/rustc")).arg("--version"))
        && well(nobody().args(["test", "-x"]).arg(cargo_home.join("registry")))
}

/// A program of a submission as nobody.
pub(super) fn program(path: &Path) -> Command {
    let mut command = nobody();
    command.envs(ENVIRONMENT).arg("prlimit").args(PROGRAM).arg(path);
    command
}

/// Cargo as nobody, in a tree that belongs to nobody from now on.
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
