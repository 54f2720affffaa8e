//! Programs of several ranks, run from outside: tests start `mpiexec` as a student does.

mod job;
mod launcher;

pub use job::{Ended, Job};
pub use launcher::{Launcher, NoLauncher};
