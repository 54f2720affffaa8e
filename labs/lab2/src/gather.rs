//! Task 2.9: neighbours summed in the order of their ids.

use common::Vec2;
use common::soft::{CUTOFF, Observer, Particle};
use solution1::add_pair;

/// A sum over the neighbours of a particle, in an order that depends only on their ids.
///
/// All-pairs adds up neighbours in ascending order of ids. A program with bins finds neighbours in
/// memory order. Threads and processes find some neighbours in the memory of other threads and
/// processes. Sorting the few neighbours within the cutoff before the sum gives the same bits in all
/// these cases.
///
/// A `Gather` reuses its memory for the next particle, so make one `Gather` for each thread, not for
/// each particle.
#[derive(Debug, Default)]
pub struct Gather {
    /// The id and the distance vector of each neighbour within the cutoff.
    found: Vec<(u32, Vec2)>,
}

impl Gather {
    /// Returns the acceleration of `particle` due to the `candidates` within the cutoff.
    ///
    /// - Start the sum at zero, and add the neighbours' contributions in ascending order of ids.
    /// - `candidates` are the bins around the particle, as slices. The slices and the particles in each
    ///   slice may be in any order. No particle occurs twice.
    /// - If `particle` itself is among the candidates, leave it out.
    /// - Report the number of all candidates to `observer` (`tested`). `add_pair` reports every pair
    ///   within the cutoff, so do not call `seen` yourself.
    ///
    /// At the official density, nine out of ten particles have no neighbour within the cutoff, and hardly
    /// any particle has two. Sort only if there is something to sort.
    ///
    /// Book: chapter 2, *The same bits*.
    #[inline]
    pub fn acceleration<'a, O: Observer>(
        &mut self,
        particle: &Particle,
        candidates: impl IntoIterator<Item = &'a [Particle]>,
        observer: &mut O,
    ) -> Vec2 {
        todo!("task 2.9: neighbours summed in the order of their ids")
    }
}
