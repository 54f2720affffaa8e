//! Positions and velocities.

use common::Vec2;
use common::soft::{Particle, Scene};

/// Where particles are and how fast: one entry for each particle in both arrays, by ascending id.
///
/// A slope, which says how fast a state changes, has the same shape: `at` is then the velocities, and `v` the
/// accelerations.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct State {
    /// Positions, in units of length.
    pub at: Vec<Vec2>,
    /// Velocities, in lengths per unit of time.
    pub v: Vec<Vec2>,
}

impl State {
    /// The particles of a scene.
    pub fn of(scene: &Scene) -> Self {
        let particles = scene.particles();
        Self {
            at: particles.iter().map(|p| Vec2::new(p.x, p.y)).collect(),
            v: particles.iter().map(|p| Vec2::new(p.vx, p.vy)).collect(),
        }
    }

    /// The state that a straight line along `slope`, which is as long, leads to within a time `h`:
    /// `at + h * slope.at`, and `v + h * slope.v`.
    pub fn along(&self, slope: &Self, h: f64) -> Self {
        Self { at: along(&self.at, &slope.at, h), v: along(&self.v, &slope.v, h) }
    }

    /// Writes the particles with ids `first .. first + out.len()` into `out`.
    pub(crate) fn read(&self, first: usize, out: &mut [Particle]) {
        let moving = self.at.iter().zip(&self.v).enumerate().skip(first);
        for (slot, (id, (at, v))) in out.iter_mut().zip(moving) {
            *slot = Particle { x: at.x, y: at.y, vx: v.x, vy: v.y, id: id as u32 };
        }
    }
}

/// `from + h * slope`.
fn along(from: &[Vec2], slope: &[Vec2], h: f64) -> Vec<Vec2> {
    from.iter().zip(slope).map(|(&from, &slope)| from + h * slope).collect()
}
