//! Task 9.1: the number of invocations of a kernel, and the errors of refused launches.

use device::{Gpu, GpuError, Launch, LaunchError, Launcher};
use wgpu::{ErrorFilter, Limits};

use crate::Lab9;

impl Launcher for Lab9 {
    /// Returns a launch of `blocks` workgroups with `threads` invocations each, within `limits`.
    ///
    /// - A workgroup may have at most `max_compute_invocations_per_workgroup` invocations, and at
    ///   most `max_compute_workgroup_size_x` along x. This kit uses only the x direction in a
    ///   workgroup.
    /// - Along x and along y, a launch has at most `max_compute_workgroups_per_dimension`
    ///   workgroups, usually 65535. If `blocks` is greater, arrange the workgroups in rows along x:
    ///   as few rows as possible, all of the same length, and this length as short as possible.
    ///   There may still be a few more workgroups than `blocks`. They do no harm, because every
    ///   invocation checks its number.
    ///
    /// Book: chapter 9, *A launch*.
    ///
    /// # Errors
    /// [`LaunchError`] if `limits` does not allow the launch, or if `blocks` or `threads` is 0.
    fn launch(blocks: u32, threads: u32, limits: &Limits) -> Result<Launch, LaunchError> {
        todo!("task 9.1: a launch that fits the device")
    }

    /// Returns a launch with at least one invocation for each of `n` items, in workgroups of
    /// `threads`.
    ///
    /// The last workgroup may be partly idle. For n = 0 there is one workgroup, which is wholly
    /// idle.
    ///
    /// # Errors
    /// [`LaunchError`], as for [`launch`](Self::launch).
    fn launch_over(n: u32, threads: u32, limits: &Limits) -> Result<Launch, LaunchError> {
        todo!("task 9.1b: one invocation for each item")
    }

    /// Runs `work`, and returns an error if the device or wgpu refused any of it.
    ///
    /// The wgpu calls that make kernels and launches return no errors. Like CUDA, wgpu continues
    /// with an invalid object, and a refused launch leaves all buffers as they were. An *error
    /// scope* catches the errors inside it:
    ///
    /// 1. Open a scope for [`ErrorFilter::Validation`] with `gpu.device.push_error_scope`.
    /// 2. Run `work`.
    /// 3. Close the scope with `pop`. It returns a future of an `Option` of an error.
    ///    `pollster::block_on` waits for the future.
    ///
    /// Book: chapter 9, *A launch that never ran*.
    ///
    /// # Errors
    /// [`GpuError::Refused`], which contains `what` and the reason.
    fn checked<T>(gpu: &Gpu, what: &str, work: impl FnOnce() -> T) -> Result<T, GpuError> {
        todo!("task 9.1c: a refusal is an error")
    }
}
