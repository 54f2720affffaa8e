//! Positions and velocities.

use common::Vec2;
use common::soft::{Particle, Scene};

/// Where particles are and how fast: one entry for each particle in both arrays, by ascending id.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct State {
    /// Positions, in units of length.
    pub at: Vec<Vec2>,
    /// Velocities, in lengths per unit of time.
    pub v: Vec<Vec2>,
}

impl State {
    /// The particles of a scene.
    pub(crate) fn of(scene: &Scene) -> Self {
        let particles = scene.particles();
        Self {
            at: particles.iter().map(|p| Vec2::new(p.x, p.y)).collect(),
            v: particles.iter().map(|p| Vec2::new(p.vx, p.vy)).collect(),
        }
    }

    /// Writes the particles with ids `first .. first + out.len()` into `out`.
    pub(crate) fn read(&self, first: usize, out: &mut [Particle]) {
        let moving = self.at.iter().zip(&self.v).enumerate().skip(first);
        for (slot, (id, (at, v))) in out.iter_mut().zip(moving) {
            *slot = Particle { x: at.x, y: at.y, vx: v.x, vy: v.y, id: id as u32 };
        }
    }
}
