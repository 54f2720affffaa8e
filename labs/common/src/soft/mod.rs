//! Soft discs: particles that repel each other within a cutoff radius (labs 1 to 6, 9 and 10).
//!
//! The problem is Assignment 2 of Berkeley's CS267, to the bit. The box grows with the number of
//! particles, so that the density stays the same: 0.2 particles per square of side [`CUTOFF`]. If
//! particles were independent, each would have 0.6 neighbours; they repel each other, so each has
//! 0.1.

mod constants;
mod counter;
mod driver;
mod frames;
mod lattice;
mod official;
mod particle;
mod philox;
mod scene;
mod scene_file;
mod shuffle;
mod simulation;
mod statistics;

pub use crate::SceneError;
pub use constants::{CUTOFF, DENSITY, DT, MASS, MIN_R};
pub use counter::CounterParticles;
pub use driver::{drive, drive_on_rank};
pub use frames::{FrameFormat, FrameWriter, general};
pub use lattice::official_size;
pub use official::OfficialParticles;
pub use particle::{Particle, read_by_id};
pub use scene::Scene;
pub use scene_file::{SceneFileError, read_scene};
pub use simulation::Simulation;
pub use statistics::{Averages, NoStatistics, Observer, Statistics, merged};
