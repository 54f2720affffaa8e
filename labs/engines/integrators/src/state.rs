//! Positions and velocities.

use common::Vec2;
use common::soft::{Particle, Scene};

/// Positions and velocities of particles, in ascending order of ids.
///
/// A slope, the change of a state per unit of time, has the same shape: `at` then contains the
/// velocities, and `v` the accelerations.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct State {
    /// Positions, in units of length.
    pub at: Vec<Vec2>,
    /// Velocities, in lengths per unit of time.
    pub v: Vec<Vec2>,
}

impl State {
    /// Returns the state of a scene's particles.
    pub fn of(scene: &Scene) -> Self {
        let particles = scene.particles();
        Self {
            at: particles.iter().map(|p| Vec2::new(p.x, p.y)).collect(),
            v: particles.iter().map(|p| Vec2::new(p.vx, p.vy)).collect(),
        }
    }

    /// Returns the state that is reached from this state along the constant `slope` in a time `h`.
    ///
    /// It is `at + h * slope.at` and `v + h * slope.v`.
    ///
    /// `slope` has as many particles as the state.
    pub fn along(&self, slope: &Self, h: f64) -> Self {
        Self { at: along(&self.at, &slope.at, h), v: along(&self.v, &slope.v, h) }
    }

    /// Writes the particles with ids `first .. first + out.len()` to `out`.
    pub(crate) fn read(&self, first: usize, out: &mut [Particle]) {
        let moving = self.at.iter().zip(&self.v).enumerate().skip(first);
        for (slot, (id, (at, v))) in out.iter_mut().zip(moving) {
            *slot = Particle { x: at.x, y: at.y, vx: v.x, vy: v.y, id: id as u32 };
        }
    }
}

/// Returns `from + h * slope`, element by element.
fn along(from: &[Vec2], slope: &[Vec2], h: f64) -> Vec<Vec2> {
    from.iter().zip(slope).map(|(&from, &slope)| from + h * slope).collect()
}
