//! Given code between this lab and wgpu: a device, kernels, launches, memory that goes back and
//! forth, and a clock on the device's side.
//!
//! wgpu is safe and general, and a little wordy for a lab. What is left here is what CUDA's host
//! side has: `cudaMalloc` is [`Gpu::storage`], `cudaMemcpy` is [`Gpu::upload`] and [`Readback`],
//! `kernel<<<blocks, threads>>>` is a [`Kernel`] bound to its buffers and sent over a
//! [`Launch`](crate::Launch),
//! a stream is a [`Work`], and events are the [`Stopwatch`].

mod device;
mod error;
mod kernel;
mod readback;
mod stopwatch;
mod work;

pub use device::Gpu;
pub use error::{GpuError, LaunchError};
pub use kernel::{Bound, Kernel, Real, refuse_todo};
pub use readback::Readback;
pub use stopwatch::Stopwatch;
pub use work::Work;
