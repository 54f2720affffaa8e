//! The team of a program that is one process: itself.

use std::marker::PhantomData;
use std::process::ExitCode;

/// What carries out an order: one process, or the ranks of a job.
pub struct Team<'a>(PhantomData<&'a ()>);

impl Team<'_> {
    /// Whether this process talks to the grader.
    pub fn is_first(&self) -> bool {
        true
    }

    /// What the first was told, told to all.
    pub fn share(&self, told: String) -> String {
        told
    }
}

/// Brings the team together and has it do its work.
pub fn gather(_workers: usize, work: impl FnOnce(&Team<'_>) -> ExitCode) -> ExitCode {
    work(&Team(PhantomData))
}
