//! Task 9.1: how many invocations a kernel is started with, and what a refusal looks like.

use device::{Gpu, GpuError, Launch, LaunchError, Launcher};
use wgpu::{ErrorFilter, Limits};

use crate::Lab9;

impl Launcher for Lab9 {
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
    fn launch(blocks: u32, threads: u32, limits: &Limits) -> Result<Launch, LaunchError> {
        // task 9.1: a launch that fits the device
        if blocks == 0 || threads == 0 {
            return Err(LaunchError::Nothing { blocks, threads });
        }
        let most =
            limits.max_compute_invocations_per_workgroup.min(limits.max_compute_workgroup_size_x);
        if threads > most {
            return Err(LaunchError::Threads { threads, most });
        }
        let most = limits.max_compute_workgroups_per_dimension;
        let rows = blocks.div_ceil(most);
        if rows > most {
            return Err(LaunchError::Blocks { blocks, most });
        }
        Ok(Launch { groups: [blocks.div_ceil(rows), rows], threads })
        // end 9.1
    }

    /// At least one invocation for each of `n` items, in workgroups of `threads`. The last
    /// workgroup may be partly idle; for n = 0 there is one that is wholly idle.
    ///
    /// # Errors
    /// See [`LaunchError`].
    fn launch_over(n: u32, threads: u32, limits: &Limits) -> Result<Launch, LaunchError> {
        // task 9.1b: one invocation for each item
        if threads == 0 {
            return Self::launch(1, threads, limits);
        }
        Self::launch(n.div_ceil(threads).max(1), threads, limits)
        // end 9.1b
    }

    /// Does `work`, and says so if the device or wgpu refused any of it.
    ///
    /// wgpu does not return errors from the calls that make kernels and launches: like CUDA it goes on
    /// with nothing in hand, and a launch that was refused leaves all buffers as they were. An *error
    /// scope* catches what went wrong inside it. Open one for [`ErrorFilter::Validation`] with
    /// `gpu.device.push_error_scope`, do the work, and close it with `pop`, which gives a future
    /// (`pollster::block_on` waits for it) of an `Option` of an error.
    ///
    /// Book: chapter 9, *A launch that never ran*.
    ///
    /// # Errors
    /// [`GpuError::Refused`] with the reason, and `what` was refused.
    fn checked<T>(gpu: &Gpu, what: &str, work: impl FnOnce() -> T) -> Result<T, GpuError> {
        // task 9.1c: a refusal is an error
        let scope = gpu.device.push_error_scope(ErrorFilter::Validation);
        let value = work();
        match pollster::block_on(scope.pop()) {
            None => Ok(value),
            Some(error) => Err(GpuError::Refused { what: what.into(), why: error.to_string() }),
        }
        // end 9.1c
    }
}
