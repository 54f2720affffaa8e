//! The official scene: the start that CS267's `init_particles` makes, to the bit.
//!
//! Particles are on a lattice in shuffled order, so neighbours in memory are far apart in the box.
//! Velocities are random numbers from -1 to 1. The original uses the C++ library's Mersenne Twister
//! and distributions; this module repeats their arithmetic.

use rand_mt::Mt;

use super::lattice::Lattice;
use super::{Particle, Scene, SceneError};
use crate::room::room_for;

impl Scene {
    /// Makes the official scene of `n` particles.
    ///
    /// # Errors
    /// `n` is 0, beyond [`Scene::MOST`] or beyond the machine's memory, or the seed is 0.
    pub fn official(n: u64, seed: u32) -> Result<Self, SceneError> {
        let generator = OfficialParticles::new(n, seed)?;
        let mut particles =
            room_for(generator.lattice.n).ok_or(SceneError::Memory("particle", n))?;
        let size = generator.lattice.size;
        particles.extend(generator);
        Self::new(size, particles)
    }
}

/// The particles of an official scene, one after the other, for a program that keeps only some
/// particles.
///
/// The shuffle takes 4 bytes for each particle of the scene.
#[derive(Clone, Debug)]
pub struct OfficialParticles {
    lattice: Lattice,
    shuffle: Vec<u32>,
    twister: Mt,
    next: usize,
}

impl OfficialParticles {
    /// Makes the generator, before its first particle.
    ///
    /// # Errors
    /// The same as those of [`Scene::official`].
    pub fn new(n: u64, seed: u32) -> Result<Self, SceneError> {
        let count = Scene::check_count(n)?;
        if seed == 0 {
            return Err(SceneError::SeedZero);
        }
        let mut shuffle: Vec<u32> = room_for(count).ok_or(SceneError::Memory("particle", n))?;
        shuffle.extend(0..count as u32);
        Ok(Self { lattice: Lattice::new(count), shuffle, twister: Mt::new(seed), next: 0 })
    }
}

impl Iterator for OfficialParticles {
    type Item = Particle;

    fn next(&mut self) -> Option<Particle> {
        let id = self.next;
        let last = self.lattice.n.checked_sub(id + 1)?;
        self.next += 1;
        let pick = uniform_int(&mut self.twister, last as u32) as usize;
        let site = self.shuffle[pick] as usize;
        self.shuffle[pick] = self.shuffle[last];
        Some(Particle {
            x: self.lattice.x(site),
            y: self.lattice.y(site / self.lattice.columns),
            vx: unit_speed(self.twister.next_u32()),
            vy: unit_speed(self.twister.next_u32()),
            id: id as u32,
        })
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        let left = self.lattice.n - self.next;
        (left, Some(left))
    }
}

/// Returns an integer in 0 ..= `greatest`, with Lemire's method for 32-bit numbers.
fn uniform_int(twister: &mut Mt, greatest: u32) -> u32 {
    let range = greatest + 1;
    let mut product = u64::from(twister.next_u32()) * u64::from(range);
    if (product as u32) < range {
        let threshold = range.wrapping_neg() % range;
        while (product as u32) < threshold {
            product = u64::from(twister.next_u32()) * u64::from(range);
        }
    }
    (product >> 32) as u32
}

/// Returns a number in -1 .. 1 from a random word, in single precision.
pub(super) fn unit_speed(word: u32) -> f64 {
    const BELOW_ONE: f32 = 1.0 - f32::EPSILON / 2.0;
    let unit = (word as f32 / 4_294_967_296.0).min(BELOW_ONE);
    f64::from(unit * 2.0 + -1.0)
}
