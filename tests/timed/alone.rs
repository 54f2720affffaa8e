//! The team of a program that is a single process.

use std::marker::PhantomData;
use std::process::ExitCode;

/// The executor of an order: one process, or the ranks of a job.
pub struct Team<'a>(PhantomData<&'a ()>);

impl Team<'_> {
    /// Returns whether this process communicates with the grader.
    pub fn is_first(&self) -> bool {
        true
    }

    /// Returns the order that the first process received, on all processes.
    pub fn share(&self, line: String) -> String {
        line
    }
}

/// Assembles the team and makes it do its work.
pub fn gather(_workers: usize, work: impl FnOnce(&Team<'_>) -> ExitCode) -> ExitCode {
    work(&Team(PhantomData))
}
