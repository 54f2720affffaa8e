//! Distinguishes a fault of the machine from a mistake of a submission.
//!
//! A full disk or a lack of processes stops a correct program in the same way as a mistake does.
//! The error messages of a program prove nothing, because a submission can print the same text. So
//! each run that a fault could have stopped is followed by a control run, which succeeds on a
//! machine that works. A failure counts only if it occurs in [`RUNS`] runs and the control succeeds
//! after each of them. If a control fails, the submission is not graded.

use std::os::unix::process::ExitStatusExt;
use std::thread::sleep;
use std::time::Duration;

use anyhow::Result;

use lab_kit::process::Finished;

/// Number of doubtful runs in a row after which the result of the last run counts.
const RUNS: usize = 3;

/// Number of attempts at a control. On a busy machine, starting a process may fail for a moment.
const ATTEMPTS: usize = 4;
/// Pause between two attempts.
const PAUSE: Duration = Duration::from_secs(2);

/// Beginning of the message about a submission that is not graded.
const FAULT: &str = "not graded because of a fault of this machine";

/// Parts of error messages about missing resources.
///
/// They come from the system, and from the programs that make the sandbox.
const SIGNS: [&str; 11] = [
    "bwrap: ",
    "setpriv: ",
    "prlimit: ",
    "os error ",
    "Os { code: ",
    "No space left on device",
    "Resource temporarily unavailable",
    "Cannot allocate memory",
    "Read-only file system",
    "Input/output error",
    "Too many open files",
];

/// Exit codes of a sandbox that cannot be made, of a shell that cannot start a program, and of a
/// sandbox whose program was killed. A Rust program that panics ends with 101.
const CODES: [i32; 4] = [1, 126, 127, 137];

/// Calls `once`, and repeats the call as long as its result `is_doubtful`. A result is doubtful if
/// a fault of the machine may have ended the run.
///
/// # Errors
/// If the control fails, which is a fault of the machine.
pub(crate) fn believed<T>(
    once: impl Fn() -> Result<T>,
    is_doubtful: impl Fn(&T) -> bool,
    control: impl Fn() -> Result<()>,
) -> Result<T> {
    let mut result = once()?;
    for run in 1..=RUNS {
        if !is_doubtful(&result) {
            break;
        }
        machine_works(&control)?;
        if run < RUNS {
            result = once()?;
        }
    }
    Ok(result)
}

/// Repeats the control until it succeeds.
///
/// # Errors
/// If every attempt fails.
pub(crate) fn machine_works(control: impl Fn() -> Result<()>) -> Result<()> {
    for _ in 1..ATTEMPTS {
        if control().is_ok() {
            return Ok(());
        }
        sleep(PAUSE);
    }
    // A control may call this function too, and then its error begins with the same words.
    control().map_err(|error| match error.to_string() {
        message if message == FAULT => error,
        _ => error.context(FAULT),
    })
}

/// Whether a fault of the machine could have ended a program.
pub(crate) fn could_end(finished: &Finished) -> bool {
    let Some(status) = finished.status.filter(|status| !status.success()) else { return false };
    let killed = status.signal() == Some(9);
    killed || status.code().is_some_and(|code| CODES.contains(&code)) || is_sign(&finished.stderr)
}

/// Whether an error message is about the machine.
pub(crate) fn is_sign(complaint: &str) -> bool {
    SIGNS.iter().any(|sign| complaint.contains(sign))
}

/// Returns the first line of an error message that names a missing resource, or else its first
/// line.
pub(crate) fn named(complaint: &str) -> &str {
    let mut lines = complaint.lines().map(str::trim).filter(|line| !line.is_empty());
    let first = lines.clone().next().unwrap_or("it printed nothing");
    lines.find(|line| is_sign(line)).unwrap_or(first)
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;
    use std::process::Command;
    use std::time::Duration;

    use anyhow::{Result, anyhow, bail};

    use super::{FAULT, RUNS, believed, could_end, machine_works, named};
    use lab_kit::process::run;

    fn count(calls: &Cell<usize>) -> Result<()> {
        calls.set(calls.get() + 1);
        Ok(())
    }

    #[test]
    fn a_doubtful_end_counts_only_on_a_machine_that_works() {
        let runs = Cell::new(0);
        let controls = Cell::new(0);
        believed(|| count(&runs), |()| false, || count(&controls)).unwrap();
        assert_eq!((runs.take(), controls.take()), (1, 0));
        believed(|| count(&runs), |()| true, || count(&controls)).unwrap();
        assert_eq!((runs.take(), controls.take()), (RUNS, RUNS));
        believed(|| count(&runs), |()| runs.get() < 2, || count(&controls)).unwrap();
        assert_eq!((runs.take(), controls.take()), (2, 1), "the fault was gone");
        let error = believed(|| count(&runs), |()| true, || bail!("the disk is full")).unwrap_err();
        assert_eq!(format!("{error:#}"), format!("{FAULT}: the disk is full"));
        assert_eq!(runs.take(), 1);
    }

    #[test]
    fn a_fault_in_a_control_of_a_control_is_reported_once() {
        let error = machine_works(|| Err(anyhow!("the disk is full").context(FAULT))).unwrap_err();
        assert_eq!(format!("{error:#}"), format!("{FAULT}: the disk is full"));
    }

    #[test]
    fn what_is_missing_is_named() {
        let message =
            "error: failed to write x\n\nCaused by:\n  No space left on device (os error 28)\n";
        assert_eq!(named(message), "No space left on device (os error 28)");
        assert_eq!(named("\nkilled\nby whom?"), "killed");
    }

    #[test]
    fn a_panic_is_no_fault_of_the_machine() {
        for (script, doubtful) in [
            ("exit 0", false),
            ("exit 1", true),
            ("echo 'No space left on device' >&2; exit 0", false),
            ("echo 'thread main panicked at src/lib.rs' >&2; exit 101", false),
            ("echo 'Os { code: 28, kind: StorageFull }' >&2; exit 101", true),
            ("/none", true),
            ("kill -9 $$", true),
            ("kill -11 $$", false),
        ] {
            let finished = run(Command::new("sh").args(["-c", script]), Duration::from_secs(60));
            assert_eq!(could_end(&finished.unwrap()), doubtful, "{script}");
        }
    }
}
