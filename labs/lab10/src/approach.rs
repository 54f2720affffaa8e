//! Which listed pairs come close within a step.

use pulp::NullaryFnOnce;

use crate::Bodies;
use crate::filter::{Places, ROOM, filter};
use crate::layout::Layout;
use crate::path::closest_squared;
use crate::search::{Found, Pair};

/// Sorts the listed pairs of a block into those whose free flights come within the layout's
/// [`near`](Layout::near), those that stay outside by no more than its `aside`, and the rest.
///
/// Whose path ends `at_wall` has no straight line: all its pairs that are near enough are close.
/// No particle may be faster than the layout's `reach`. So most pairs are out by their distance
/// alone, and there is no branch to guess.
pub(crate) struct Approach<'a> {
    pub(crate) pairs: &'a [Pair],
    pub(crate) bodies: &'a Bodies,
    pub(crate) at_wall: &'a [bool],
    pub(crate) layout: &'a Layout,
    pub(crate) found: &'a mut Found,
}

impl NullaryFnOnce for Approach<'_> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        let Self { pairs, bodies, at_wall, layout, found } = self;
        found.close.clear();
        found.watched.clear();
        found.tested = pairs.len() as u64;
        let n = bodies.len();
        let (x, y) = (&bodies.x[..n], &bodies.y[..n]);
        let (vx, vy, at_wall) = (&bodies.vx[..n], &bodies.vy[..n], &at_wall[..n]);
        let square = |length: f64| length * length;
        let (near, watched) = (square(layout.near()), square(layout.near() + layout.aside));
        let (within, time) = (square(layout.within()), layout.span.forces());
        let (mut some_near, mut close, mut aside) =
            ([[0; 2]; ROOM], [[0; 2]; ROOM], [[0; 2]; ROOM]);
        let [mut dx, mut dy, mut wx, mut wy, mut closest] = [[0.0; ROOM]; 5];
        for some in pairs.chunks(ROOM) {
            let len = filter(some, Places::of(bodies), within, &mut some_near);
            for (k, pair) in some_near[..len].iter().enumerate() {
                let [i, j] = pair.map(|i| i as usize);
                (dx[k], dy[k]) = (x[j] - x[i], y[j] - y[i]);
                (wx[k], wy[k]) = (vx[j] - vx[i], vy[j] - vy[i]);
            }
            for k in 0..len.next_multiple_of(8) {
                closest[k] = closest_squared(dx[k], dy[k], wx[k], wy[k], time);
            }
            let (mut closes, mut asides) = (0, 0);
            for (pair, &closest) in some_near[..len].iter().zip(&closest) {
                let is_close =
                    (closest <= near) | at_wall[pair[0] as usize] | at_wall[pair[1] as usize];
                close[closes & (ROOM - 1)] = *pair;
                closes += usize::from(is_close);
                aside[asides & (ROOM - 1)] = *pair;
                asides += usize::from(!is_close & (closest <= watched));
            }
            found.close.extend_from_slice(&close[..closes]);
            found.watched.extend_from_slice(&aside[..asides]);
        }
    }
}
