//! Soft and hard discs on a graphics processor.
//!
//! This package contains buffers, bins, parameters, statistics and the order of the launches. A
//! type that implements [`soft::SoftKernels`] or [`hard::HardKernels`] supplies the kernels in
//! WGSL. Lab 9 of the kit has such types; read its source for an example.
//!
//! - [`soft::SoftDiscs`]: particles that repel each other within a cutoff. They stay on the device,
//!   where they are sorted into bins. Positions are in double precision, or in single precision
//!   relative to their bin.
//! - [`hard::HardDiscs`]: discs that collide. The device tests all pairs, in double or single
//!   precision, and returns the pairs that may collide. The host decides in f64, so every device
//!   gives the same bytes as lab 7's sequential program.
//!
//! # Example
//!
//! A hundred steps of any scene, in single precision, with any kernels:
//!
//! ```
//! use common::soft::{Particle, Scene, Simulation};
//! use device::{Gpu, GpuError};
//! use device_discs::soft::{Options, Single, SoftDiscs, SoftKernels};
//!
//! fn after_a_hundred_steps<K: SoftKernels>(scene: &Scene) -> Result<Vec<Particle>, GpuError> {
//!     let options = Options { threads: 64, bin: 1.0, in_flight: 1, statistics: false };
//!     let mut discs = SoftDiscs::<K, Single>::new(Gpu::shared()?, options, None)?;
//!     discs.try_load(scene)?;
//!     for _ in 0..100 {
//!         discs.step();
//!     }
//!     let mut particles = vec![Particle::default(); scene.len()];
//!     discs.read(0, &mut particles);
//!     Ok(particles)
//! }
//! ```
//!
//! # Units, shapes, errors
//!
//! Lengths, velocities and times are those of [`common::soft`] and [`common::hard`]; the kernels of
//! hard discs use sides of the square as the unit of length. A scene of n particles takes about 60
//! n bytes of device memory in single precision and 100 n in double precision. If a device cannot
//! do its work, functions return a [`device::GpuError`]. A step cannot return an error, so it
//! panics with the same message.

pub mod hard;
mod parameters;
pub mod soft;
