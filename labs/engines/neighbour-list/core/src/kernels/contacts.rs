//! Finds the pairs in contact among listed pairs, and computes their accelerations side by side.

use std::marker::PhantomData;

use common::soft::CUTOFF;

use super::{EIGHT, Pair, Positions, Primitives, ROOM, coefficient};

/// Memory for pairs within the cutoff.
///
/// The pairs are stored without gaps, so that their square roots and divisions fill vector
/// registers.
pub struct Contacts<P> {
    pairs: Box<[Pair; ROOM]>,
    dx: Box<[f64; ROOM]>,
    dy: Box<[f64; ROOM]>,
    r2: Box<[f64; ROOM]>,
    primitives: PhantomData<P>,
}

impl<P> Default for Contacts<P> {
    fn default() -> Self {
        Self {
            pairs: Box::new([[0; 2]; ROOM]),
            dx: Box::new([0.0; ROOM]),
            dy: Box::new([0.0; ROOM]),
            r2: Box::new([0.0; ROOM]),
            primitives: PhantomData,
        }
    }
}

impl<P: Primitives> Contacts<P> {
    /// Calls `each` for every pair within the cutoff, in the order of `pairs`.
    ///
    /// The arguments are the pair, the acceleration of its first particle, and the square of its
    /// distance.
    #[inline(always)]
    pub fn for_each(
        &mut self,
        pairs: &[Pair],
        positions: Positions<'_>,
        mut each: impl FnMut(Pair, [f64; 2], f64),
    ) {
        let Positions { x, y, first } = positions;
        let y = &y[..x.len()];
        let Self { pairs: near, dx, dy, r2, .. } = self;
        for some in pairs.chunks(ROOM) {
            let len = P::filter(some, positions, CUTOFF * CUTOFF, near);
            for (k, pair) in near[..len].iter().enumerate() {
                let [i, j] = pair.map(|i| i as usize - first);
                dx[k] = x[j] - x[i];
                dy[k] = y[j] - y[i];
                r2[k] = dx[k] * dx[k] + dy[k] * dy[k];
            }
            for k in 0..len.next_multiple_of(EIGHT).min(ROOM) {
                let coef = coefficient(r2[k]);
                dx[k] *= coef;
                dy[k] *= coef;
            }
            for (k, pair) in near[..len].iter().enumerate() {
                each(*pair, [dx[k], dy[k]], r2[k]);
            }
        }
    }
}
