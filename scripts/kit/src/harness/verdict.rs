//! Outcome of a test.

use std::os::unix::process::ExitStatusExt;

use serde::{Deserialize, Serialize};

use super::message::{PANIC, message};
use crate::answers::{RegionId, Task};
use crate::process::Finished;

/// Verdict on a test.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// The test passed.
    Passed,
    /// The test failed with a message.
    Failed,
    /// The test has the attribute `ignore`.
    Ignored,
    /// The test reported that something it needs is missing, such as a graphics adapter.
    Skipped,
    /// The process ended without a verdict, for instance by a signal.
    Crashed(String),
    /// The test exceeded its time limit.
    TimedOut,
}

/// Beginning of the line with which a test reports that something it needs is missing.
const SKIPPED: &str = "skipped: ";

/// A test and its outcome.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Outcome {
    /// Name of the test.
    pub test: String,
    /// Verdict on the test.
    pub verdict: Verdict,
    /// Reason for the failure, as a student reads it.
    pub message: String,
}

impl Outcome {
    /// Makes an outcome with these parts.
    pub fn new(test: &str, verdict: Verdict, message: impl Into<String>) -> Self {
        Self { test: test.into(), verdict, message: message.into() }
    }

    /// Reads the outcome of a process that ran only this test, with its output uncaptured.
    pub fn read(test: &str, done: &Finished) -> Self {
        let outcome = Self::new(test, verdict(done), message(test, done));
        if outcome.verdict == Verdict::Passed && outcome.skipped().is_some() {
            return Self { verdict: Verdict::Skipped, ..outcome };
        }
        outcome
    }

    /// Whether the test passed, was ignored, or could not run here.
    pub fn passes(&self) -> bool {
        matches!(self.verdict, Verdict::Passed | Verdict::Ignored | Verdict::Skipped)
    }

    /// Returns the reason why the test did not run; `None` if it ran.
    pub fn skipped(&self) -> Option<&str> {
        self.message.lines().find_map(|line| line.strip_prefix(SKIPPED))
    }

    /// Whether a watchdog ended the test: this program's watchdog or the oracle's.
    pub fn hung(&self) -> bool {
        self.verdict == Verdict::TimedOut || self.message.contains("no answer within ")
    }

    /// Whether the lab's own code panicked, so that the test could not judge its result.
    pub fn panicked(&self) -> bool {
        self.message.lines().any(|line| line.starts_with(PANIC))
    }

    /// Returns the task, such as `1.5b`, whose `todo!` the test met first.
    pub fn todo(&self) -> Option<&str> {
        let (_, rest) = self.message.split_once("not yet implemented: task ")?;
        rest.split_once(':').map(|(id, _)| id)
    }

    /// Whether the first `todo!` that the test met belongs to this task.
    pub fn meets_todo_of(&self, task: Task) -> bool {
        let region = self.todo().and_then(|id| id.parse::<RegionId>().ok());
        region.is_some_and(|region| region.task == task)
    }
}

fn verdict(done: &Finished) -> Verdict {
    let Some(status) = done.status else { return Verdict::TimedOut };
    let result = done.stdout.lines().rev().find_map(|line| line.strip_prefix("test result: "));
    match (status.code(), result) {
        (Some(0), Some(result)) if result.contains(" 1 passed;") => Verdict::Passed,
        (Some(0), Some(result)) if result.contains(" 1 ignored;") => Verdict::Ignored,
        (Some(101), Some(result)) if result.contains(" 1 failed;") => Verdict::Failed,
        (Some(code), _) => {
            Verdict::Crashed(format!("it ended with exit code {code} and no verdict"))
        }
        (None, _) => Verdict::Crashed(match status.signal() {
            Some(6) => "it aborted".into(),
            Some(11) => "it reached for memory that is not its own (signal 11)".into(),
            Some(signal) => format!("it was ended by signal {signal}"),
            None => "it ended without a verdict".into(),
        }),
    }
}

#[cfg(test)]
mod tests {
    use std::os::unix::process::ExitStatusExt;
    use std::process::ExitStatus;

    use super::{Outcome, Verdict};
    use crate::process::Finished;

    fn outcome(status: i32, stdout: &str, stderr: &str) -> Outcome {
        let status = Some(ExitStatus::from_raw(status));
        Outcome::read(
            "task_1_1::a",
            &Finished { status, stdout: stdout.into(), stderr: stderr.into() },
        )
    }

    #[test]
    fn a_todo_is_found() {
        let stdout = "\nrunning 1 test\ntest task_1_1::a ... FAILED\n\nfailures:\n\nfailures:\n    task_1_1::a\n\n\
                      test result: FAILED. 0 passed; 1 failed; 0 ignored; 0 measured; 3 filtered out\n";
        let stderr = "\nthread 'task_1_1::a' (7) panicked at labs/lab1/src/x.rs:9:5:\n\
                      not yet implemented: task 1.1b: the force\nnote: run with `RUST_BACKTRACE=1` to see\n";
        let outcome = outcome(101 << 8, stdout, stderr);
        assert_eq!(outcome.verdict, Verdict::Failed);
        assert_eq!(outcome.message, "not yet implemented: task 1.1b: the force");
        assert_eq!(outcome.todo(), Some("1.1b"));
    }

    #[test]
    fn a_crash_is_no_failure() {
        let stdout = "\nrunning 1 test\n";
        // Without a verdict of the harness, exit code 0 is not a pass.
        for status in [6, 0, 101 << 8] {
            assert!(matches!(outcome(status, stdout, "").verdict, Verdict::Crashed(_)), "{status}");
        }
    }

    #[test]
    fn a_test_passes_unless_it_has_no_device() {
        let stdout = "\nrunning 1 test\ntest task_1_1::a ... ok\n\ntest result: ok. 1 passed; 0 failed; 0 ignored;\n";
        let passed = outcome(0, stdout, "");
        assert_eq!((passed.verdict, &*passed.message), (Verdict::Passed, ""));
        let skipped = outcome(0, stdout, "skipped: no adapter: none is here\n");
        assert_eq!(skipped.verdict, Verdict::Skipped);
        assert_eq!(skipped.skipped(), Some("no adapter: none is here"));
    }
}
