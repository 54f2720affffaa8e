//! Particles in a box, checked once.

use thiserror::Error;

use super::Particle;

/// A square box of side [`size`](Scene::size) with particles in it.
///
/// A scene that exists is sound: it has a particle, every number in it is finite, every particle
/// lies in the box, walls included, and ids count from 0. Labs rely on it and check nothing.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    size: f64,
    particles: Vec<Particle>,
}

/// Why particles and a size make no scene.
#[derive(Debug, Error, PartialEq)]
pub enum SceneError {
    /// No particle at all.
    #[error("a scene needs at least one particle")]
    Empty,
    /// More particles than ids.
    #[error("a scene holds at most {most} particles, not {0}", most = Scene::MOST)]
    TooMany(u64),
    /// The machine has too little memory for the particles.
    #[error("not enough memory for {0} particles")]
    Memory(u64),
    /// The generator's seed 0 means «random» in the original program, a run that cannot be repeated.
    #[error("seed 0 is refused: a run must be repeatable, so choose 1 or more")]
    SeedZero,
    /// The side of the box is no positive finite number.
    #[error("the side of the box must be positive and finite, not {0}")]
    Size(f64),
    /// A coordinate or velocity is infinite or no number.
    #[error("particle {id}: {field} is {value}, not a finite number")]
    NotFinite {
        /// The particle.
        id: usize,
        /// `x`, `y`, `vx` or `vy`.
        field: &'static str,
        /// Its value.
        value: f64,
    },
    /// A particle beyond a wall.
    #[error("particle {id}: {field} = {value} lies outside the box, 0 to {size}")]
    Outside {
        /// The particle.
        id: usize,
        /// `x` or `y`.
        field: &'static str,
        /// Its value.
        value: f64,
        /// Side of the box.
        size: f64,
    },
}

impl Scene {
    /// The greatest number of particles: ids are the original program's 32-bit integers.
    pub const MOST: usize = i32::MAX as usize;

    /// Checks `particles` in a box of side `size`, and numbers them in the order given.
    ///
    /// # Errors
    /// See [`SceneError`], which names the first particle at fault.
    pub fn new(size: f64, mut particles: Vec<Particle>) -> Result<Self, SceneError> {
        if !(size.is_finite() && size > 0.0) {
            return Err(SceneError::Size(size));
        }
        Self::check_count(particles.len() as u64)?;
        for (id, particle) in particles.iter_mut().enumerate() {
            let Particle { x, y, vx, vy, .. } = *particle;
            for (field, value) in [("x", x), ("y", y), ("vx", vx), ("vy", vy)] {
                if !value.is_finite() {
                    return Err(SceneError::NotFinite { id, field, value });
                }
            }
            for (field, value) in [("x", x), ("y", y)] {
                if !(0.0..=size).contains(&value) {
                    return Err(SceneError::Outside { id, field, value, size });
                }
            }
            particle.id = id as u32;
        }
        Ok(Self { size, particles })
    }

    pub(super) fn check_count(n: u64) -> Result<usize, SceneError> {
        match n {
            0 => Err(SceneError::Empty),
            _ if n > Self::MOST as u64 => Err(SceneError::TooMany(n)),
            _ => Ok(n as usize),
        }
    }

    /// Side of the box.
    pub fn size(&self) -> f64 {
        self.size
    }

    /// The particles in id order.
    pub fn particles(&self) -> &[Particle] {
        &self.particles
    }

    /// Number of particles, at least 1.
    #[expect(clippy::len_without_is_empty, reason = "a scene is never empty")]
    pub fn len(&self) -> usize {
        self.particles.len()
    }
}
