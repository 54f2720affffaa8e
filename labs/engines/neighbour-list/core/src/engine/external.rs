//! Accelerations from outside of an engine.

use std::ops::Range;

/// The accelerations of some of an engine's particles in a step by particles elsewhere.
#[derive(Clone, Copy, Default)]
pub struct External<'a> {
    /// The particles as indices into the engine's order, ascending.
    pub indices: &'a [u32],
    /// Their accelerations along x.
    pub x: &'a [f64],
    /// Their accelerations along y.
    pub y: &'a [f64],
}

impl External<'_> {
    /// Those of the particles of `range`: the index and the acceleration.
    pub(super) fn among(&self, range: &Range<usize>) -> impl Iterator<Item = (u32, [f64; 2])> {
        let before = |end: usize| self.indices.partition_point(|&i| (i as usize) < end);
        let part = before(range.start)..before(range.end);
        part.map(|k| (self.indices[k], [self.x[k], self.y[k]]))
    }
}
