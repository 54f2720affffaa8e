//! Finds the listed pairs that come near each other in free flight.

use std::marker::PhantomData;

use common::soft::CUTOFF;
use neighbour_list::kernels::{Pair, ROOM};
use neighbour_list::{Bodies, filter};
use pulp::NullaryFnOnce;

use super::Found;
use super::layout::Layout;
use crate::rules::Rules;

/// A vector kernel that sorts pairs into close pairs, pairs to be watched, and the rest.
///
/// The processor cannot predict the kind of a pair, so there is no branch. Every pair is written,
/// and is overwritten by the next pair if its free flights stay too far apart.
pub(crate) struct Approach<'a, R> {
    pub(crate) pairs: [&'a [Pair]; 2],
    pub(crate) bodies: &'a Bodies,
    pub(crate) layout: &'a Layout,
    pub(crate) found: &'a mut Found,
    pub(crate) rules: PhantomData<R>,
}

impl<R: Rules> NullaryFnOnce for Approach<'_, R> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        let Self { pairs, bodies, layout, found, .. } = self;
        found.close.clear();
        found.watched.clear();
        found.tested = pairs.iter().map(|pairs| pairs.len() as u64).sum();
        let n = bodies.len();
        let [x, y] = [&bodies.x[..n], &bodies.y[..n]];
        let [vx, vy] = [&bodies.vx[..n], &bodies.vy[..n]];
        let time = layout.span.forces();
        let near = layout.near() * layout.near();
        let watched_squared = layout.watched() * layout.watched();
        let [mut close, mut watched] = [[[0; 2]; ROOM]; 2];
        let [mut dx, mut dy, mut wx, mut wy, mut closest] = [[0.0; ROOM]; 5];
        let within = (CUTOFF + layout.skin(1.0)).powi(2) * (1.0 + 1e-9);
        let mut near_now = [[0; 2]; ROOM];
        for some in pairs.into_iter().flat_map(|pairs| pairs.chunks(ROOM)) {
            // The present distance alone excludes most pairs.
            let len = filter(some, bodies.positions(), within, &mut near_now);
            let some = &near_now[..len];
            for (k, pair) in some.iter().enumerate() {
                let [i, j] = pair.map(|i| i as usize);
                dx[k] = x[j] - x[i];
                dy[k] = y[j] - y[i];
                wx[k] = vx[j] - vx[i];
                wy[k] = vy[j] - vy[i];
            }
            for k in 0..some.len().next_multiple_of(8) {
                closest[k] = R::closest_squared(dx[k], dy[k], wx[k], wy[k], time);
            }
            let mut closes = 0;
            let mut watched_count = 0;
            for (pair, &closest) in some.iter().zip(&closest) {
                // The mask never changes the index. It shows the compiler that the index is in
                // bounds.
                close[closes & (ROOM - 1)] = *pair;
                closes += usize::from(closest <= near);
                watched[watched_count & (ROOM - 1)] = *pair;
                watched_count += usize::from((closest > near) & (closest <= watched_squared));
            }
            found.close.extend_from_slice(&close[..closes]);
            found.watched.extend_from_slice(&watched[..watched_count]);
        }
    }
}
