//! The form of a particle in a message.
//!
//! MPI must know the layout of a struct in memory. `Equivalence` describes it, so that a slice of
//! these types can be sent unchanged.

use common::soft::Particle;
use mpi::traits::Equivalence;

/// All data of a particle that moves to another rank.
#[derive(Clone, Copy, Debug, Default, PartialEq, Equivalence)]
#[repr(C)]
pub struct Wire {
    /// Position along x.
    pub x: f64,
    /// Position along y.
    pub y: f64,
    /// Velocity along x.
    pub vx: f64,
    /// Velocity along y.
    pub vy: f64,
    /// Number of the particle in the scene.
    pub id: u64,
}

/// A ghost: the data of another rank's particle that the forces on its neighbours need. The id is
/// part of these data, because neighbours are summed in ascending order of their ids.
#[derive(Clone, Copy, Debug, Default, PartialEq, Equivalence)]
#[repr(C)]
pub struct Ghost {
    /// Position along x.
    pub x: f64,
    /// Position along y.
    pub y: f64,
    /// Number of the particle in the scene.
    pub id: u64,
}

impl From<&Particle> for Wire {
    fn from(p: &Particle) -> Self {
        Self { x: p.x, y: p.y, vx: p.vx, vy: p.vy, id: p.id.into() }
    }
}

impl From<&Wire> for Particle {
    fn from(w: &Wire) -> Self {
        Self { x: w.x, y: w.y, vx: w.vx, vy: w.vy, id: w.id as u32 }
    }
}

impl From<&Particle> for Ghost {
    fn from(p: &Particle) -> Self {
        Self { x: p.x, y: p.y, id: p.id.into() }
    }
}

impl From<&Ghost> for Particle {
    /// The velocity is 0, because a ghost does not move on this rank.
    fn from(g: &Ghost) -> Self {
        Self { x: g.x, y: g.y, vx: 0.0, vy: 0.0, id: g.id as u32 }
    }
}
