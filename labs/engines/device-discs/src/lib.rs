//! Soft and hard discs on a graphics processor. Buffers, bins, parameters, statistics and the order of the
//! launches stand here; the kernels, in WGSL, come from the type that implements [`soft::SoftKernels`] or
//! [`hard::HardKernels`]. Lab 9 of the kit does, and its source is where to read how.
//!
//! - [`soft::SoftDiscs`]: particles that repel each other within a cutoff. They are sorted into bins on the
//!   device and never leave it; positions are double, or single and relative to their bin.
//! - [`hard::HardDiscs`]: discs that collide. The device looks at all pairs, in double or single precision, and
//!   passes on those that may collide; the host decides, in f64, so that the bytes are those of lab 7's
//!   sequential program on every device.
//!
//! # Example
//!
//! A hundred steps of any scene, in single precision, with whatever kernels are given:
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
//! Lengths, velocities and times are those of [`common::soft`] and [`common::hard`]; the kernels of hard discs
//! see lengths in sides of the square. A scene of n particles takes some 60 n bytes of the device in single
//! precision and 100 n in double. What a device cannot do is a [`device::GpuError`]; within a step, where nobody
//! can be told, it is a panic with the same words.

pub mod hard;
mod parameters;
pub mod soft;
