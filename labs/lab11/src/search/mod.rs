//! Which particles could meet within a window.

mod flights;
mod found;
mod layout;
mod meeting;
mod specials;

use std::ops::Range;

use pulp::NullaryFnOnce;
use solution10::cells::Ahead;
use solution10::kernels::{Kernel, Pair, ROOM, Signs};
use solution10::{Bodies, Cells, filter};

pub(crate) use flights::Flights;
pub(crate) use found::Found;
pub(crate) use layout::Layout;
pub(crate) use specials::{Specials, SweptBox, Walls, pairs_with_plain, plain_near};

use crate::flight::closest_squared;
use meeting::View;

/// Finds all pairs of particles in the stored cells `range` and ahead of them whose free flights may
/// come within `limit`. Pairs with a special particle are not among them.
pub(crate) struct Search<'a> {
    pub(crate) found: &'a mut Found,
    pub(crate) flights: &'a Flights,
    pub(crate) cells: &'a Cells,
    pub(crate) range: Range<usize>,
    pub(crate) limit: f32,
}

impl Kernel for Search<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self, signs: impl Signs) {
        let Self { found, flights, cells, range, limit } = self;
        found.begin();
        let flights = flights.view();
        cells.for_each_ahead(range, &mut Searching { found: &mut *found, flights, limit, signs });
        found.end();
    }
}

/// A search under way.
struct Searching<'a, S> {
    found: &'a mut Found,
    flights: View<'a>,
    limit: f32,
    signs: S,
}

impl<S: Signs> Ahead for Searching<'_, S> {
    #[inline(always)]
    fn visit(&mut self, i: usize, end: usize, next: Range<usize>) {
        let Self { found, flights, limit, signs } = self;
        found.tested += (end - i - 1 + next.len()) as u64;
        flights.pairs(*signs, i, i + 1..end, next, *limit, found);
    }
}

/// Sorts the listed pairs of a block into pairs whose free flights come within the layout's
/// [`near`](Layout::near), pairs that stay outside by no more than its `aside`, and the rest.
///
/// A particle whose path ends `at_wall` has no straight line: all its pairs that are near enough
/// are close. No particle may be faster than the layout's `reach`. So most pairs are out by their
/// distance alone, and there is no branch to guess.
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
            let len = filter(some, bodies.places(), within, &mut some_near);
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
