//! How a program starts itself again as several ranks.

use std::env;
use std::process::Command;

/// `mpiexec`, with this program and what it was told.
///
/// # Panics
/// The program's own path is unknown.
pub fn itself_on(ranks: usize) -> Command {
    let itself = env::current_exe().expect("a program knows its own path");
    let mut command = mpiexec();
    let version = mpiexec().arg("--version").output().map(|output| output.stdout);
    let version = String::from_utf8_lossy(&version.unwrap_or_default()).into_owned();
    if version.contains("OpenRTE") {
        command.args(["--oversubscribe", "--bind-to", "none", "--allow-run-as-root"]);
    } else if version.contains("Open MPI") {
        command.args(["--map-by", ":OVERSUBSCRIBE", "--bind-to", "none", "--allow-run-as-root"]);
    }
    command.arg("-n").arg(ranks.to_string()).arg(itself).args(env::args().skip(1));
    command
}

fn mpiexec() -> Command {
    let mut command = Command::new("mpiexec");
    // A sandbox has no environment.
    if env::var_os("PATH").is_none() {
        command.env("PATH", "/usr/local/bin:/usr/bin:/bin");
    }
    if env::var_os("HOME").is_none() {
        command.env("HOME", "/tmp");
    }
    command
}
