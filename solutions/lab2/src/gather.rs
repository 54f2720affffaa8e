//! Task 2.9: neighbours summed in the order of their ids.

use common::Vec2;
use common::soft::{CUTOFF, Observer, Particle};
use solution1::add_pair;

/// Sums what neighbours do to a particle in an order that depends on nothing but their ids.
///
/// All-pairs adds up neighbours in ascending id. Bins find them in the order in which they lie in
/// memory, and threads or processes find some of them in memory that belongs to another. Sorting the few
/// that are within the cutoff before they are added gives the same bits in all these cases.
///
/// It keeps a little memory between particles: make one per thread, not one per particle.
#[derive(Debug, Default)]
pub struct Gather {
    /// The neighbours within the cutoff: id and distance vector.
    found: Vec<(u32, Vec2)>,
}

impl Gather {
    /// The acceleration of `particle` by those of the `candidates` that are within the cutoff,
    /// summed from zero in ascending id.
    ///
    /// `candidates` are slices, in any order, of particles in any order: those of the bins around.
    /// No particle may be in them twice. `particle` itself may be among them and counts for
    /// nothing. `observer` is told how many candidates there were (`tested`); `add_pair` tells it of every
    /// pair summed: do not call `seen` yourself.
    ///
    /// With this density nine of ten particles have no neighbour, and hardly any has two: sort only if
    /// there is something to sort.
    ///
    /// Book: chapter 2, *The same bits*.
    #[inline]
    pub fn acceleration<'a, O: Observer>(
        &mut self,
        particle: &Particle,
        candidates: impl IntoIterator<Item = &'a [Particle]>,
        observer: &mut O,
    ) -> Vec2 {
        // task 2.9: neighbours summed in the order of their ids
        self.found.clear();
        for slice in candidates {
            observer.tested(slice.len() as u64);
            for neighbour in slice {
                let d = particle.to(neighbour);
                if d.norm_squared() <= CUTOFF * CUTOFF && neighbour.id != particle.id {
                    self.found.push((neighbour.id, d));
                }
            }
        }
        if self.found.len() > 1 {
            self.found.sort_unstable_by_key(|(id, _)| *id);
        }
        let mut a = Vec2::ZERO;
        for (_, d) in &self.found {
            add_pair(&mut a, *d, observer);
        }
        a
        // end 2.9
    }
}
