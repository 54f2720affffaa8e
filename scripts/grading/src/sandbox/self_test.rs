//! Whether a sandbox keeps out what it must: one that cannot do what it is for is none.

use std::time::Duration;

use anyhow::{Context, Result, bail, ensure};

use super::Sandbox;
use lab_kit::process::run as run_process;
use lab_kit::system::on_path;

/// What makes a sandbox, and the packages that bring it.
const PROGRAMS: [(&str, &str); 3] =
    [("bwrap", "bubblewrap"), ("prlimit", "util-linux"), ("setpriv", "util-linux")];

/// The home folder is not there, nothing of the kit can be written, no environment names the grader's folder, nobody is
/// root, there is no network and a limit on memory, and no program can choose its processors or be root of a namespace.
const SCRIPT: &str = "test ! -e /root && test ! -e /home && ! touch /kit/x 2>/dev/null \
                      && ! touch /usr/x 2>/dev/null && ! touch /dev/x 2>/dev/null \
                      && ! cat /proc/*/environ | tr '\\0' '\\n' | grep -v '^PWD=/kit$' | grep -q '^PWD=/.' \
                      && test $(id -u) != 0 && test $(grep -c : /proc/net/dev) -le 1 \
                      && test $(ulimit -v) != unlimited \
                      && ! taskset -pc 0 $$ >/dev/null 2>&1 \
                      && ! unshare --user true 2>/dev/null && echo kept in";

/// Tries it.
///
/// # Errors
/// It cannot be made, or keeps too little out; the message says why.
pub(crate) fn check(sandbox: &Sandbox) -> Result<()> {
    ensure!(cfg!(target_os = "linux"), "there are namespaces on Linux only");
    for (program, package) in PROGRAMS {
        ensure!(
            on_path(program.as_ref()),
            "there is no {program} (on Debian and Ubuntu 'apt install {package}')"
        );
    }
    let folder = sandbox.folder()?;
    let mut command = sandbox.shell(folder.path());
    let finished = run_process(command.args(["-c", SCRIPT]), Duration::from_secs(20))
        .context("cannot start bubblewrap (bwrap), prlimit or setpriv")?;
    match finished.status {
        Some(status) if status.success() && finished.stdout == "kept in\n" => Ok(()),
        _ if finished.stderr.trim().is_empty() => {
            bail!("the sandbox does not keep out what it must")
        }
        _ => bail!("{}", finished.stderr.trim().lines().next().unwrap_or_default()),
    }
}
