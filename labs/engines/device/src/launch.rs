//! The shape of a launch, and the decisions of lab 9 about it.

use wgpu::Limits;

use crate::device::Gpu;
use crate::error::{GpuError, LaunchError};
use crate::kernel::Kernel;

/// The shape of a launch: a number of workgroups, and a number of invocations in each.
///
/// In CUDA a launch is a grid of blocks of threads, `<<<blocks, threads>>>`. The device runs all of
/// a launch or nothing: a launch that exceeds the device's limits does not change the buffers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Launch {
    /// Number of workgroups along x and along y.
    pub groups: [u32; 2],
    /// Number of invocations in a workgroup.
    pub threads: u32,
}

impl Launch {
    /// Returns the number of workgroups.
    pub fn blocks(&self) -> u32 {
        self.groups[0] * self.groups[1]
    }
}

/// The decisions about launches: their size, and the detection of the device's errors.
pub trait Launcher {
    /// Returns a launch of at least `blocks` workgroups of `threads` invocations, within `limits`.
    ///
    /// The length of a row of workgroups is limited. So a launch may have several rows, and a few
    /// more workgroups than `blocks`.
    ///
    /// # Errors
    /// The device cannot run the launch.
    fn launch(blocks: u32, threads: u32, limits: &Limits) -> Result<Launch, LaunchError>;

    /// Returns a launch with an invocation for each of `n` items, in workgroups of `threads`. The
    /// launch has at least one workgroup.
    ///
    /// # Errors
    /// The device cannot run the launch.
    fn launch_over(n: u32, threads: u32, limits: &Limits) -> Result<Launch, LaunchError>;

    /// Calls `work`, and returns an error if the device or wgpu refused any part of it.
    ///
    /// # Errors
    /// [`GpuError::Refused`] with the reason; `what` is the name of the work in the message.
    fn checked<T>(gpu: &Gpu, what: &str, work: impl FnOnce() -> T) -> Result<T, GpuError>;

    /// Compiles the entry point `name` of `sources` for workgroups of `threads` ([`Kernel::new`]).
    ///
    /// # Errors
    /// The device refuses the sources.
    fn compiled(
        gpu: &Gpu,
        name: &'static str,
        sources: &[&str],
        threads: u32,
        constants: &[(&str, f64)],
    ) -> Result<Kernel, GpuError> {
        Self::checked(gpu, name, || Kernel::new(gpu, name, sources, threads, constants))
    }
}
