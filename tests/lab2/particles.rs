//! Particles at chosen and at random positions.

use std::ops::Range;

use common::soft::Particle;
use oracle::{Random, integers};

/// A particle, and the number of its bin.
#[derive(Clone, Copy)]
pub(crate) struct Binned {
    pub(crate) bin: usize,
    pub(crate) particle: Particle,
}

/// Returns particle number `id` at rest at (x, y).
pub(crate) fn numbered(id: usize, x: f64, y: f64) -> Particle {
    Particle { x, y, id: id as u32, ..Particle::default() }
}

/// Draws particle number `id` well inside a bin of a box of side 1 with `along` bins along a wall.
pub(crate) fn inside(random: &mut Random, along: usize, bin: usize, id: usize) -> Binned {
    let mut at = |index: usize| (index as f64 + random.between(0.05, 0.95)) / along as f64;
    Binned { bin, particle: numbered(id, at(bin % along), at(bin / along)) }
}

/// Draws `n` particles well inside bins of some rows: in any bins, or all in one bin. Some
/// particles have the position of the previous particle.
pub(crate) fn binned(
    random: &mut Random,
    along: usize,
    rows: &Range<usize>,
    n: usize,
) -> Vec<Binned> {
    let crowded = (random.below(3) == 0).then(|| any_bin(random, along, rows));
    let mut all: Vec<Binned> = Vec::with_capacity(n);
    for id in 0..n {
        let one = match all.last() {
            Some(&before) if random.below(5) == 0 => {
                Binned { particle: Particle { id: id as u32, ..before.particle }, ..before }
            }
            _ => {
                let bin = crowded.unwrap_or_else(|| any_bin(random, along, rows));
                inside(random, along, bin, id)
            }
        };
        all.push(one);
    }
    all
}

fn any_bin(random: &mut Random, along: usize, rows: &Range<usize>) -> usize {
    (rows.start + random.below(rows.len())) * along + random.below(along)
}

/// Returns the particles without their bins.
pub(crate) fn particles_of(all: &[Binned]) -> Vec<Particle> {
    all.iter().map(|one| one.particle).collect()
}

/// Returns the ids of particles.
pub(crate) fn ids<'a>(particles: impl IntoIterator<Item = &'a Particle>) -> Vec<f64> {
    integers(particles.into_iter().map(|p| p.id as usize))
}

/// Sorts numbers whose order does not matter.
pub(crate) fn in_any_order(mut numbers: Vec<f64>) -> Vec<f64> {
    numbers.sort_by(f64::total_cmp);
    numbers
}
