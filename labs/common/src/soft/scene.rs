//! Scenes of soft discs, which are checked when they are made.

use super::Particle;
use crate::SceneError;
use crate::scene_error::{self, check_body, check_length};

/// A square box of side [`size`](Scene::size) with particles in it.
///
/// Every scene is valid: it has a particle, every number in it is finite, every particle is in the
/// box, walls included, and ids count from 0. Labs rely on this and need no checks.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    size: f64,
    particles: Vec<Particle>,
}

impl Scene {
    /// The greatest number of particles.
    pub const MOST: usize = scene_error::MOST;

    /// Checks `particles` in a box of side `size`, numbers them in this order, and makes a scene.
    ///
    /// # Errors
    /// A [`SceneError`], which names the first particle that is not valid.
    pub fn new(size: f64, mut particles: Vec<Particle>) -> Result<Self, SceneError> {
        check_length("the side of the box", size)?;
        Self::check_count(particles.len() as u64)?;
        for (number, particle) in particles.iter_mut().enumerate() {
            let Particle { x, y, vx, vy, .. } = *particle;
            check_body("particle", number, [x, y, vx, vy], 0.0..=size, |field, value| {
                SceneError::OutsideBox { number, field, value, size }
            })?;
            particle.id = number as u32;
        }
        Ok(Self { size, particles })
    }

    pub(super) fn check_count(n: u64) -> Result<usize, SceneError> {
        scene_error::check_count("particle", n)
    }

    /// Returns the side of the box.
    pub fn size(&self) -> f64 {
        self.size
    }

    /// Returns the particles in id order.
    pub fn particles(&self) -> &[Particle] {
        &self.particles
    }

    /// Returns the number of particles, at least 1.
    #[expect(clippy::len_without_is_empty, reason = "a scene is never empty")]
    pub fn len(&self) -> usize {
        self.particles.len()
    }
}
