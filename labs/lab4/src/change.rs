//! Tasks 4.3 and 4.4: a particle changes its bin, under locks.

use common::Vec2;
use common::soft::Particle;
use solution1::advance;
use solution2::Grid;

use crate::{Bin, Meter, Regions};

/// The change of a particle that has moved from bin `from` to bin `to`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Change {
    /// The number of the particle.
    pub particle: u32,
    /// The number of the old bin, whose list still contains the particle.
    pub from: usize,
    /// The number of the bin that contains the particle's new position.
    pub to: usize,
}

/// Takes a particle out of a bin, wherever it is in the list.
///
/// # Panics
/// If the particle is not in the list.
pub fn remove(bin: &mut Bin, particle: u32) {
    let index = bin.iter().position(|inside| *inside == particle);
    bin.swap_remove(index.unwrap_or_else(|| {
        panic!("particle {particle} is not in the bin that it leaves: {bin:?}")
    }));
}

/// Moves a particle from its old bin to its new bin, under the locks of both regions.
///
/// Other threads do the same with other particles at the same time.
///
/// - [`Regions::cut`] finds the region of a bin, and [`Regions::locks`] contains the lock of each
///   region. Take a lock with [`Meter::lock`].
/// - Take both locks before you change a bin. A thread that looks at both bins under their locks
///   then finds the particle in exactly one of them.
/// - Both bins may be in the same region. Then there is only one lock, and a thread that takes it
///   twice waits for itself forever.
///
/// Two threads may want the same two locks at once. In which order should each thread take them?
///
/// Book: chapter 4, *Two locks*.
pub fn change_bin(regions: &Regions, meter: &mut Meter, change: Change) {
    todo!("task 4.3: from one bin into another, under two locks")
}

/// Moves a thread's `particles`, and reports each change of bin at once.
///
/// - `accelerations[i]` belongs to `particles[i]`. [`advance`] moves one particle.
/// - If a particle is in a different bin of `grid` after its move, call `changed` before you move
///   the next particle.
///
/// Book: chapter 4, *At that moment*.
pub fn move_own(
    grid: &Grid,
    particles: &mut [Particle],
    accelerations: &[Vec2],
    mut changed: impl FnMut(Change),
) {
    todo!("task 4.4: move particles, and report each change of bin at once")
}
