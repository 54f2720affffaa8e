//! Which listed pairs really touch, and what they do to their particles.

use common::soft::{CUTOFF, Observer};

use crate::contacts::Vectors;
use crate::filter::{Places, ROOM, filter};
use crate::sums::Sums;

/// Pairs within the cutoff, waiting for their forces. They stand close together, so that their
/// square roots and divisions fill vector registers.
pub(crate) struct Touching {
    pairs: Box<[[u32; 2]; ROOM]>,
    vectors: Vectors<ROOM>,
}

impl Default for Touching {
    fn default() -> Self {
        Self { pairs: Box::new([[0; 2]; ROOM]), vectors: Vectors::default() }
    }
}

impl Touching {
    /// Adds the accelerations of `pairs` to `sums`, which begin with particle `first`.
    #[inline(always)]
    pub(crate) fn feel<O: Observer>(
        &mut self,
        pairs: &[[u32; 2]],
        places: Places<'_>,
        first: usize,
        sums: &mut Sums,
        observer: &mut O,
    ) {
        let Places { x, y, first: start } = places;
        let y = &y[..x.len()];
        let to = |[i, j]: [u32; 2]| {
            let (i, j) = (i as usize - start, j as usize - start);
            (x[j] - x[i], y[j] - y[i])
        };
        for some in pairs.chunks(ROOM) {
            let len = filter(some, places, CUTOFF * CUTOFF, &mut self.pairs);
            let Vectors { dx, dy, r2 } = &mut self.vectors;
            for (k, &pair) in self.pairs[..len].iter().enumerate() {
                (dx[k], dy[k]) = to(pair);
                r2[k] = dx[k] * dx[k] + dy[k] * dy[k];
            }
            self.vectors.accelerate(len);
            self.apply(len, first, sums, observer);
        }
    }

    /// Adds what the first `len` pairs do to both of their particles.
    #[inline(always)]
    fn apply<O: Observer>(&self, len: usize, first: usize, sums: &mut Sums, observer: &mut O) {
        let Sums { x, y } = sums;
        let (x, y) = (&mut x[..], &mut y[..]);
        for (k, &[i, j]) in self.pairs[..len].iter().enumerate() {
            let (i, j) = (i as usize - first, j as usize - first);
            let (ax, ay) = (self.vectors.dx[k], self.vectors.dy[k]);
            x[i] += ax;
            y[i] += ay;
            x[j] -= ax;
            y[j] -= ay;
            observer.seen(self.vectors.r2[k]);
            observer.seen(self.vectors.r2[k]);
        }
    }
}
