//! Task 9.1: how many invocations a kernel is started with.

use thiserror::Error;
use wgpu::Limits;

/// The shape of a launch: so many workgroups of so many invocations each. CUDA says a grid of
/// blocks of threads, and `<<<blocks, threads>>>`.
///
/// A launch exists only if the device can run it. One that asks for too much is not run *in part*:
/// it is not run at all, and the buffers keep what was in them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Launch {
    /// Workgroups along x and along y.
    pub groups: [u32; 2],
    /// Invocations in a workgroup.
    pub threads: u32,
}

/// A launch that the device cannot run.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum LaunchError {
    /// No workgroup, or none in it.
    #[error("a launch needs at least one workgroup of one thread, not {blocks} of {threads}")]
    Nothing {
        /// Workgroups asked for.
        blocks: u32,
        /// Threads a workgroup asked for.
        threads: u32,
    },
    /// The workgroup does not fit on one multiprocessor.
    #[error("a workgroup of {threads} threads is too large: this device runs at most {most}")]
    Threads {
        /// Threads a workgroup asked for.
        threads: u32,
        /// The device's limit.
        most: u32,
    },
    /// More workgroups than the device counts.
    #[error("{blocks} workgroups are too many: this device takes at most {most} by {most}")]
    Blocks {
        /// Workgroups asked for.
        blocks: u32,
        /// The device's limit along x and along y.
        most: u32,
    },
}

impl Launch {
    /// `blocks` workgroups of `threads` invocations, or an error if `limits` does not allow it.
    ///
    /// - A workgroup may have at most `max_compute_invocations_per_workgroup` invocations, and
    ///   at most `max_compute_workgroup_size_x` along x, which is the only direction used here.
    /// - Along x and along y a launch has at most `max_compute_workgroups_per_dimension`
    ///   workgroups, mostly 65535. If `blocks` is more, use as few rows as suffice, all of the
    ///   same length; a few workgroups too many do no harm, since every kernel checks its number.
    ///
    /// Book: chapter 9, *A launch*.
    ///
    /// # Errors
    /// See [`LaunchError`].
    pub fn new(blocks: u32, threads: u32, limits: &Limits) -> Result<Self, LaunchError> {
        todo!("task 9.1: a launch that fits the device")
    }

    /// At least one invocation for each of `n` items, in workgroups of `threads`. The last
    /// workgroup may be partly idle; for n = 0 there is one that is wholly idle.
    ///
    /// # Errors
    /// See [`LaunchError`].
    pub fn over(n: u32, threads: u32, limits: &Limits) -> Result<Self, LaunchError> {
        todo!("task 9.1b: one invocation for each item")
    }

    /// Workgroups in all.
    pub fn blocks(&self) -> u32 {
        self.groups[0] * self.groups[1]
    }
}
