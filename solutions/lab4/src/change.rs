//! Tasks 4.3 and 4.4: a particle changes its bin, under locks.

use common::Vec2;
use common::soft::Particle;
use solution1::advance;
use solution2::Grid;

use crate::{Bin, Meter, Regions};

/// A particle has left bin `from` and lies in bin `to` now.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Change {
    /// Its number.
    pub particle: u32,
    /// The number of the bin whose list it is in.
    pub from: usize,
    /// The number of the bin that it lies in.
    pub to: usize,
}

/// Takes a particle out of a bin, wherever in the list it is.
///
/// # Panics
/// It is not there.
pub fn remove(bin: &mut Bin, particle: u32) {
    let index = bin.iter().position(|inside| *inside == particle);
    bin.swap_remove(index.unwrap_or_else(|| {
        panic!("particle {particle} is not in the bin that it leaves: {bin:?}")
    }));
}

/// Takes a particle out of the list of its old bin and puts it into that of the new one, under the
/// locks of both regions, while other threads do the same with other particles.
///
/// [`Regions::locks`] has the lock of each region and [`Regions::cut`] finds it; take it by
/// [`Meter::lock`]. Hold both locks until the change is done: a thread that looks at both bins
/// under their locks then finds the particle in one of them, never in two or in none. Both bins may
/// lie in one region: then there is one lock, and a thread that asks for it twice waits for itself.
///
/// Two threads may want the same two locks at once. In which order does each take them?
///
/// Book: chapter 4, *Two locks*.
pub fn change_bin(regions: &Regions, meter: &mut Meter, change: Change) {
    // task 4.3: from one bin into another, under two locks
    let (from, old) = regions.cut.find(change.from);
    let (to, new) = regions.cut.find(change.to);
    if from == to {
        let mut region = meter.lock(&regions.locks[from]);
        remove(&mut region[old], change.particle);
        region[new].push(change.particle);
        return;
    }
    // The lower number first, whichever way the particle goes.
    let mut lower = meter.lock(&regions.locks[from.min(to)]);
    let mut upper = meter.lock(&regions.locks[from.max(to)]);
    let (source, target) =
        if from < to { (&mut lower, &mut upper) } else { (&mut upper, &mut lower) };
    remove(&mut source[old], change.particle);
    target[new].push(change.particle);
    // end 4.3
}

/// Moves a thread's `particles`, and calls `changed` for each that lies in another bin of `grid`
/// than before, at the moment in which it does.
///
/// `accelerations[i]` belongs to `particles[i]`; [`advance`] moves one particle.
///
/// Book: chapter 4, *At that moment*.
pub fn move_own(
    grid: &Grid,
    particles: &mut [Particle],
    accelerations: &[Vec2],
    mut changed: impl FnMut(Change),
) {
    // task 4.4: move, and change bins at that moment
    for (particle, a) in particles.iter_mut().zip(accelerations) {
        let from = grid.bin(particle);
        advance(particle, *a, grid.size());
        let to = grid.bin(particle);
        if from != to {
            changed(Change { particle: particle.id, from, to });
        }
    }
    // end 4.4
}
