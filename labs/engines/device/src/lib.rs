//! A graphics processor, driven through [wgpu]: kernels in WGSL, launches, memory, a device clock.
//!
//! wgpu is safe and general, but it needs many lines of code. This package reduces it to the host
//! side of CUDA:
//!
//! | CUDA | here |
//! |---|---|
//! | `cudaMalloc`, `cudaMemset` | [`Gpu::storage`], [`Work::clear`] |
//! | `cudaMemcpy` | [`Gpu::upload`], [`Readback`] |
//! | `kernel<<<blocks, threads>>>(buffers)` | a [`Kernel`] bound to its buffers ([`Bound`]), over a [`Launch`] |
//! | a stream | a [`Work`], submitted to the one queue |
//! | events | a [`Stopwatch`] |
//! | `cudaGetLastError` | a [`Launcher`], which also decides how large a launch may be |
//!
//! The program `device` prints the name and the properties of this machine's device: `cargo run -p
//! device`.
//!
//! # Example
//!
//! Every invocation squares one number. Sixteen invocations are launched for ten numbers, so each
//! invocation tests whether its number exists. Every kernel can use the function `invocation` and
//! the constant `THREADS`, the size of a workgroup.
//!
//! ```
//! use device::{Gpu, GpuError, Kernel, Launch, Readback, Work};
//!
//! const SQUARE: &str = "
//! @group(0) @binding(0) var<storage, read_write> numbers: array<u32>;
//!
//! @compute @workgroup_size(THREADS)
//! fn square(
//!     @builtin(global_invocation_id) id: vec3<u32>,
//!     @builtin(num_workgroups) groups: vec3<u32>,
//! ) {
//!     let i = invocation(id, groups);
//!     if i < 10u {
//!         numbers[i] = numbers[i] * numbers[i];
//!     }
//! }
//! ";
//!
//! let gpu = match Gpu::shared() {
//!     Err(GpuError::NoAdapter) => return Ok(()), // no device here
//!     gpu => gpu?,
//! };
//! let numbers = gpu.storage("the numbers", 10 * 4)?;
//! gpu.upload(&numbers, &[0_u32, 1, 2, 3, 4, 5, 6, 7, 8, 9]);
//! let square = Kernel::new(gpu, "square", &[SQUARE], 4, &[]).bind(gpu, &[(0, &numbers)]);
//! let mut work = Work::new(gpu, None);
//! work.launch(&square, Launch { groups: [4, 1], threads: 4 });
//! let [squares] = Readback::default().read::<u32, 1>(gpu, work, [(&numbers, 0..10)]);
//! assert_eq!(squares, [0, 1, 4, 9, 16, 25, 36, 49, 64, 81]);
//! # Ok::<(), GpuError>(())
//! ```
//!
//! # Units, shapes, errors
//!
//! Memory is measured in bytes, a launch in workgroups and in invocations per workgroup, and time
//! in seconds. If the machine lacks an adapter, double precision or a buffer of the requested size,
//! the function that needs it returns a [`GpuError`]. Functions that build kernels and submit work
//! return no error. If wgpu refuses such a call, the error goes to the innermost *error scope*;
//! without an error scope, wgpu panics. [`Launcher::checked`] opens such a scope.

mod device;
mod error;
mod kernel;
mod launch;
mod readback;
mod stopwatch;
mod work;

pub use device::Gpu;
pub use error::{GpuError, LaunchError};
pub use kernel::{Bound, Kernel, Real, refuse_todo};
pub use launch::{Launch, Launcher};
pub use readback::Readback;
pub use stopwatch::Stopwatch;
pub use work::Work;
