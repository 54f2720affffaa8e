//! Random particles for questions, and their pairs.

use common::Vec2;
use common::soft::{CUTOFF, Particle, Scene};
use neighbour_list_core::Bodies;
use neighbour_list_core::kernels::Pair;
use oracle::Random;
use oracle::scenes::anywhere;

/// A scene for the engine, from one cell with all particles to many empty cells.
pub(crate) struct Case {
    /// Side of the box in cutoffs.
    pub(crate) size: f64,
    /// Skin in cutoffs.
    pub(crate) skin: f64,
    pub(crate) scene: Scene,
}

impl Case {
    /// Draws boxes with few particles and with many.
    pub(crate) fn drawn(random: &mut Random) -> Vec<Self> {
        let sizes = random.sizes(257).into_iter().filter(|&n| n > 0);
        sizes.map(|n| Self::with(random, n)).collect()
    }

    fn with(random: &mut Random, n: usize) -> Self {
        let crowded = random.magnitude(0.05, 20.0);
        let size = (n as f64 / crowded).sqrt().max(1.0);
        let skin = random.magnitude(0.05, 3.0);
        Self { size, skin, scene: anywhere(random, n, size * CUTOFF, 1.0) }
    }

    /// Returns the beginning of questions about the scene.
    pub(crate) fn name(&self) -> String {
        format!("{} in a box of {:.2} cutoffs", particles(self.scene.len()), self.size)
    }
}

/// Draws `n` particles anywhere in a square of a few units.
pub(crate) fn bodies(random: &mut Random, n: usize, unit: f64) -> Bodies {
    let side = unit * (n as f64).sqrt().clamp(1.0, 8.0);
    let mut bodies = Bodies::default();
    for id in 0..n as u32 {
        let x = random.between(0.0, side);
        let y = random.between(0.0, side);
        bodies.push(Particle { x, y, id, ..Particle::default() });
    }
    bodies
}

/// Returns the vector from particle i to particle j.
pub(crate) fn vector(bodies: &Bodies, i: usize, j: usize) -> Vec2 {
    Vec2::new(bodies.x[j] - bodies.x[i], bodies.y[j] - bodies.y[i])
}

/// Returns the square of the distance of particles i and j.
pub(crate) fn squared(bodies: &Bodies, i: usize, j: usize) -> f64 {
    vector(bodies, i, j).norm_squared()
}

/// Formats a number of particles: `1 particle`, `2 particles`.
pub(crate) fn particles(n: usize) -> String {
    if n == 1 { "1 particle".into() } else { format!("{n} particles") }
}

/// Returns the numbers of some pairs, one after another.
pub(crate) fn flat(pairs: &[Pair]) -> Vec<f64> {
    pairs.iter().flatten().map(|&i| f64::from(i)).collect()
}
