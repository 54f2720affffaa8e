//! The official scene: the start that CS267's `init_particles` makes, to the bit.
//!
//! Particles stand on a lattice, in shuffled order so that neighbours in memory are strangers in
//! space, with velocities drawn from -1 to 1. The original uses the C++ library's Mersenne
//! Twister and its distributions; their arithmetic is repeated here.

use rand_mt::Mt;

use super::{DENSITY, Particle, Scene, SceneError};

/// Side of the official box for `n` particles.
pub fn official_size(n: usize) -> f64 {
    (DENSITY * n as f64).sqrt()
}

impl Scene {
    /// The official scene of `n` particles.
    ///
    /// # Errors
    /// `n` is 0, beyond [`Scene::MOST`] or beyond the machine's memory, or the seed is 0.
    pub fn official(n: u64, seed: u32) -> Result<Self, SceneError> {
        let count = Self::check_count(n)?;
        if seed == 0 {
            return Err(SceneError::SeedZero);
        }
        let memory = |_| SceneError::Memory(n);
        let mut shuffle: Vec<u32> = Vec::new();
        let mut particles = Vec::new();
        shuffle.try_reserve_exact(count).map_err(memory)?;
        particles.try_reserve_exact(count).map_err(memory)?;

        let size = official_size(count);
        let columns = (count as f64).sqrt().ceil() as usize;
        let rows = count.div_ceil(columns);
        let mut twister = Mt::new(seed);
        shuffle.extend(0..count as u32);
        for id in 0..count {
            let last = count - id - 1;
            let pick = uniform_int(&mut twister, last as u32) as usize;
            let place = shuffle[pick] as usize;
            shuffle[pick] = shuffle[last];
            particles.push(Particle {
                x: size * (1.0 + (place % columns) as f64) / (1 + columns) as f64,
                y: size * (1.0 + (place / columns) as f64) / (1 + rows) as f64,
                vx: uniform_real(&mut twister),
                vy: uniform_real(&mut twister),
                id: id as u32,
            });
        }
        Self::new(size, particles)
    }
}

/// An integer in 0 ..= `greatest`, by Lemire's method on 32-bit draws.
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

/// A number in -1 .. 1, drawn in single precision.
fn uniform_real(twister: &mut Mt) -> f64 {
    const BELOW_ONE: f32 = 1.0 - f32::EPSILON / 2.0;
    let unit = (twister.next_u32() as f32 / 4_294_967_296.0).min(BELOW_ONE);
    f64::from(unit * 2.0 + -1.0)
}
