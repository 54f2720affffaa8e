//! The shape of a launch, and who decides about it.

use wgpu::Limits;

use crate::device::Gpu;
use crate::error::{GpuError, LaunchError};
use crate::kernel::Kernel;

/// The shape of a launch: a number of workgroups, and a number of invocations in each. CUDA says a grid of
/// blocks of threads, and `<<<blocks, threads>>>`.
///
/// One that asks for more than the device can run is not run *in part*: it is not run at all, and the buffers
/// keep what was in them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Launch {
    /// Workgroups along x and along y.
    pub groups: [u32; 2],
    /// Invocations in a workgroup.
    pub threads: u32,
}

impl Launch {
    /// Workgroups in all.
    pub fn blocks(&self) -> u32 {
        self.groups[0] * self.groups[1]
    }
}

/// What an engine asks about launches: how large they may be, and whether the device refused something.
pub trait Launcher {
    /// `blocks` workgroups of `threads` invocations, in rows as short as `limits` asks for. A few workgroups
    /// more than `blocks` do no harm.
    ///
    /// # Errors
    /// The device cannot run it.
    fn launch(blocks: u32, threads: u32, limits: &Limits) -> Result<Launch, LaunchError>;

    /// At least one invocation for each of `n` items, in workgroups of `threads`, and at least one workgroup.
    ///
    /// # Errors
    /// The device cannot run it.
    fn launch_over(n: u32, threads: u32, limits: &Limits) -> Result<Launch, LaunchError>;

    /// Does `work`, and says so if the device or wgpu refused any of it.
    ///
    /// # Errors
    /// [`GpuError::Refused`] with the reason, and `what` was refused.
    fn checked<T>(gpu: &Gpu, what: &str, work: impl FnOnce() -> T) -> Result<T, GpuError>;

    /// Compiles the entry point `name` of `sources` for workgroups of `threads` ([`Kernel::new`]).
    ///
    /// # Errors
    /// The device refuses it.
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
