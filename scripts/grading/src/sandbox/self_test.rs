//! Self-test of the sandbox. A sandbox that does not isolate programs must not be used.

use std::time::Duration;

use anyhow::{Context, Result, bail, ensure};

use super::Sandbox;
use lab_kit::process::run as run_process;
use lab_kit::system::on_path;

/// Programs that make a sandbox, and the packages that contain them.
const PROGRAMS: [(&str, &str); 3] =
    [("bwrap", "bubblewrap"), ("prlimit", "util-linux"), ("setpriv", "util-linux")];

/// Shell script that succeeds if the sandbox isolates programs.
///
/// The script checks that there is no home folder and no network, and that no file of the kit can
/// be written. No environment may name the grader's folder. The user must not be root, and memory
/// must be limited. No program may choose its processors or become root of a namespace.
const SCRIPT: &str = "test ! -e /root && test ! -e /home && ! touch /kit/x 2>/dev/null \
                      && ! touch /usr/x 2>/dev/null && ! touch /dev/x 2>/dev/null \
                      && ! cat /proc/*/environ | tr '\\0' '\\n' | grep -v '^PWD=/kit$' | grep -q '^PWD=/.' \
                      && test $(id -u) != 0 && test $(grep -c : /proc/net/dev) -le 1 \
                      && test $(ulimit -v) != unlimited \
                      && ! taskset -pc 0 $$ >/dev/null 2>&1 \
                      && ! unshare --user true 2>/dev/null && echo kept in";

/// Tests the sandbox.
///
/// # Errors
/// If the sandbox cannot be made or does not isolate programs. The message gives the reason.
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
