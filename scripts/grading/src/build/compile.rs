//! Runs Cargo in a tree, and finds out whether the sources are the cause of a failed build.

use std::os::unix::process::ExitStatusExt;
use std::path::Path;
use std::time::{Duration, Instant};

use anyhow::{Result, ensure};

use super::PROBE;
use crate::sandbox::faults::{machine_works, named};
use crate::sandbox::{BUILT_FILE, GIVEN_FILE, Sandbox};
use lab_kit::process::run as run_process;
use lab_kit::sources::Sources;

/// Beginning of the message about a build that exceeded its time limit.
const LATE: &str = "no build within";

/// Input of a build: sources, names of programs, time limit, and size limit of a file in bytes.
#[derive(Clone, Copy)]
pub(super) struct Order<'a> {
    pub(super) sources: &'a Sources,
    pub(super) names: &'a [&'a str],
    pub(super) limit: Duration,
    pub(super) most: u64,
}

impl<'a> Order<'a> {
    pub(super) fn of_submission(
        sandbox: &Sandbox,
        sources: &'a Sources,
        names: &'a [&'a str],
    ) -> Self {
        Self { sources, names, limit: sandbox.limits.build, most: BUILT_FILE }
    }
}

/// Compiles the programs in a tree. Returns the compiler's errors; `None` if the
/// programs compile.
pub(super) fn compile(
    root: &Path,
    sandbox: &Sandbox,
    order: &Order<'_>,
    until: Instant,
    format: &str,
) -> Result<Option<String>> {
    let mut cargo = sandbox.cargo(root, order.most);
    cargo.args(["build", "--quiet", "--offline", "--release", "--package", PROBE]);
    cargo.args(order.names.iter().flat_map(|name| ["--bin", *name]));
    cargo.args(["--message-format", format]);
    let finished = run_process(&mut cargo, until.saturating_duration_since(Instant::now()))?;
    Ok(match finished.status {
        None => Some(format!("{LATE} {} s", order.limit.as_secs())),
        Some(status) if status.signal() == Some(9) => {
            Some("its build needed more memory than it may have".into())
        }
        Some(status) if status.success() => None,
        Some(_) if finished.stderr.contains("SIGXFSZ") => Some(format!(
            "its build made a larger file than the {} MiB that it may make: a constant or a static is too large",
            order.most >> 20
        )),
        Some(_) => Some(finished.stderr),
    })
}

/// Whether a failed build is the fault of the sources.
///
/// The sources are at fault if the build took too long, or if an error has a location in a source.
pub(super) fn is_of_a_source(why: &str) -> bool {
    is_late(why) || why.lines().any(names_a_place)
}

/// Whether a build exceeded its time limit, in either pass.
pub(super) fn is_late(why: &str) -> bool {
    why.lines().any(|line| line.starts_with(LATE))
}

/// Whether a line of the compiler's output is `--> src/lib.rs:3:5` or `src/lib.rs:3:5: error`.
fn names_a_place(line: &str) -> bool {
    line.trim_start().starts_with("--> ")
        || line.split_once(": error").is_some_and(|(place, _)| is_place(place))
}

/// Whether a text ends with the numbers of a line and a column.
fn is_place(text: &str) -> bool {
    text.rsplit(':').take(2).filter(|part| part.parse::<u32>().is_ok()).count() == 2
}

/// Removes the compiled files of packages, because `include_bytes!` could read them. Dependencies
/// stay compiled.
///
/// # Errors
/// If every attempt fails, which is a fault of the machine.
pub(super) fn clean(root: &Path, packages: &[&str], sandbox: &Sandbox) -> Result<()> {
    machine_works(|| {
        let mut cargo = sandbox.cargo(root, GIVEN_FILE);
        cargo.args(["clean", "--quiet", "--offline", "--release"]);
        cargo.args(packages.iter().flat_map(|package| ["--package", *package]));
        let finished = run_process(&mut cargo, sandbox.limits.build)?;
        let succeeded = finished.status.is_some_and(|status| status.success());
        ensure!(succeeded, "old build files cannot be removed: {}", named(&finished.stderr));
        Ok(())
    })
}

#[cfg(test)]
mod tests {
    use super::{LATE, is_of_a_source};

    #[test]
    fn an_error_with_a_place_is_of_a_source() {
        for (why, own) in [
            ("error[E0425]: `x`\n  --> src/lib.rs:3:5\n", true),
            ("it compiles, but not:\nsrc/bin/answer.rs:3:5: error[E0308]: types\n", true),
            ("thread panicked at write.rs:1967:6:\n   at ./nptl/create.c:442:8\n", false),
            (&format!("{LATE} 120 s"), true),
            (&format!("it compiles, but not:\n{LATE} 120 s"), true),
            ("error: failed to write x: No space left on device (os error 28)", false),
            ("error: linking with `cc` failed\ncollect2: error: ld returned 1 exit status", false),
            ("its build needed more memory than it may have", false),
            ("thread 'rustc' panicked", false),
        ] {
            assert_eq!(is_of_a_source(why), own, "{why}");
        }
    }
}
