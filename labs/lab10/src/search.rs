//! Who could meet whom within a window.

use std::ops::Range;

use common::soft::CUTOFF;

use crate::path::{Span, closest_squared};
use crate::{Bodies, Cells};

/// Particles compared at a time.
const LANES: usize = 8;

/// A pair of places in the sorted order.
pub(crate) type Pair = [u32; 2];

/// Appends to `pairs` every particle j of `range` whose free flight comes within `reach` of that
/// of particle i within time `span`.
///
/// Eight are computed side by side; only if one of the eight is near does anybody look which.
/// Particles just beyond the range may be computed too, but never found.
#[inline(always)]
pub(crate) fn meet(
    bodies: &Bodies,
    i: usize,
    range: Range<usize>,
    span: f64,
    reach: f64,
    pairs: &mut Vec<Pair>,
) {
    let n = bodies.x.len();
    let (xi, yi, ui, vi) = (bodies.x[i], bodies.y[i], bodies.vx[i], bodies.vy[i]);
    let reach_squared = reach * reach;
    if n < LANES {
        for j in range {
            let (dx, dy) = (bodies.x[j] - xi, bodies.y[j] - yi);
            let (wx, wy) = (bodies.vx[j] - ui, bodies.vy[j] - vi);
            if closest_squared(dx, dy, wx, wy, span) <= reach_squared {
                pairs.push([i as u32, j as u32]);
            }
        }
        return;
    }
    let mut j = range.start;
    while j < range.end {
        let base = j.min(n - LANES);
        let lanes = base..base + LANES;
        let (x, y) = (&bodies.x[lanes.clone()], &bodies.y[lanes.clone()]);
        let (vx, vy) = (&bodies.vx[lanes.clone()], &bodies.vy[lanes]);
        let mut squared = [0.0; LANES];
        let mut any = false;
        for l in 0..LANES {
            squared[l] = closest_squared(x[l] - xi, y[l] - yi, vx[l] - ui, vy[l] - vi, span);
        }
        for s in squared {
            any |= s <= reach_squared;
        }
        if any {
            for (l, s) in squared.into_iter().enumerate() {
                if s <= reach_squared && (j..range.end).contains(&(base + l)) {
                    pairs.push([i as u32, (base + l) as u32]);
                }
            }
        }
        j += LANES;
    }
}

/// What a search brings back.
#[derive(Default)]
pub(crate) struct Found {
    /// Pairs whose free flights come close.
    pub(crate) pairs: Vec<Pair>,
    /// How many were looked at.
    pub(crate) tested: u64,
}

/// All pairs of particles in the stored cells `range` and ahead of them whose straight paths come
/// within cutoff + `margin` of each other.
#[inline(always)]
pub(crate) fn search(
    bodies: &Bodies,
    cells: &Cells,
    range: Range<usize>,
    span: &Span,
    margin: f64,
    mut found: Found,
) -> Found {
    found.pairs.clear();
    found.tested = 0;
    let (time, reach) = (span.forces(), CUTOFF + margin + span.rounding());
    cells.for_each_ahead(range, |own, end, next| {
        for i in own {
            meet(bodies, i, i + 1..end, time, reach, &mut found.pairs);
            meet(bodies, i, next.clone(), time, reach, &mut found.pairs);
            found.tested += (end - i - 1 + next.len()) as u64;
        }
    });
    found
}
