//! Pushes from outside of an engine.

use std::ops::Range;

use super::sums::Sums;

/// What particles elsewhere do to some of an engine's particles in a step.
#[derive(Clone, Copy, Default)]
pub struct Pushes<'a> {
    /// The pushed particles as indices into the engine's order, ascending.
    pub places: &'a [u32],
    /// Their accelerations along x.
    pub x: &'a [f64],
    /// Their accelerations along y.
    pub y: &'a [f64],
}

impl Pushes<'_> {
    /// Those on the particles of `range`.
    pub(super) fn among(&self, range: &Range<usize>) -> Self {
        let before = |end: usize| self.places.partition_point(|&place| (place as usize) < end);
        let part = before(range.start)..before(range.end);
        Self { places: &self.places[part.clone()], x: &self.x[part.clone()], y: &self.y[part] }
    }

    /// Adds them to `sums`.
    #[inline(always)]
    pub(super) fn add_to(&self, sums: &mut Sums) {
        for ((&place, x), y) in self.places.iter().zip(self.x).zip(self.y) {
            sums.add(place, *x, *y);
        }
    }
}
