//! Who could meet whom within a window.

use std::ops::Range;

use common::soft::CUTOFF;

use crate::cells::Ahead;
use crate::path::{Span, closest_squared};
use crate::{Bodies, Cells};

/// Particles compared at a time.
const LANES: usize = 8;

/// A pair of places in the sorted order.
pub(crate) type Pair = [u32; 2];

/// How a window is laid out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Layout {
    pub(crate) span: Span,
    /// Pairs whose reference paths come within cutoff + `tight` are computed.
    pub(crate) tight: f64,
    /// Pairs whose reference paths come within cutoff + `margin` are watched.
    pub(crate) margin: f64,
    /// Particles that go further than this in the window are looked after one by one.
    pub(crate) reach: f64,
}

impl Layout {
    /// Length of a cell's side: who is not [special](Layout::is_special) and could come within
    /// the margin is in the same or in an adjacent cell.
    pub(crate) fn side(&self) -> f64 {
        let near = CUTOFF + self.span.rounding();
        if self.span.steps == 1 { near } else { near + self.margin + 2.0 * self.reach }
    }

    /// Whether a particle may leave the straight line or the adjacent cells.
    #[inline(always)]
    pub(crate) fn is_special(&self, bodies: &Bodies, i: usize) -> bool {
        let (vx, vy, fast) = (bodies.vx[i], bodies.vy[i], self.reach / self.span.whole());
        (vx * vx + vy * vy > fast * fast) | self.span.meets_wall(bodies.x[i], bodies.y[i], vx, vy)
    }
}

/// What a search finds.
#[derive(Default)]
pub(crate) struct Found {
    /// Pairs that are to be computed.
    pub(crate) close: Vec<Pair>,
    /// Pairs that are to be watched.
    pub(crate) watched: Vec<Pair>,
    /// How many were looked at.
    pub(crate) tested: u64,
}

/// The squares of distances that matter, and for how long.
#[derive(Clone, Copy)]
struct Limits {
    time: f64,
    close: f64,
    watched: f64,
}

/// A search under way.
struct Searching<'a> {
    found: &'a mut Found,
    bodies: &'a Bodies,
    limits: Limits,
}

impl Ahead for Searching<'_> {
    #[inline(always)]
    fn visit(&mut self, own: Range<usize>, end: usize, next: Range<usize>) {
        let Self { found, bodies, limits } = self;
        for i in own {
            found.meet(bodies, i, i + 1..end, limits);
            found.meet(bodies, i, next.clone(), limits);
            found.tested += (end - i - 1 + next.len()) as u64;
        }
    }
}

impl Found {
    #[inline(always)]
    fn offer(&mut self, pair: Pair, squared: f64, limits: &Limits) {
        if squared <= limits.close {
            self.close.push(pair);
        } else {
            self.watched.push(pair);
        }
    }

    /// Every particle j of `range` whose free flight comes close to that of particle i.
    ///
    /// Eight are computed side by side; only if one of the eight is near does anybody look which.
    /// Particles just beyond the range may be computed too, but never found.
    #[inline(always)]
    fn meet(&mut self, bodies: &Bodies, i: usize, range: Range<usize>, limits: &Limits) {
        let n = bodies.x.len();
        let (xi, yi, ui, vi) = (bodies.x[i], bodies.y[i], bodies.vx[i], bodies.vy[i]);
        if n < LANES {
            for j in range {
                let (dx, dy) = (bodies.x[j] - xi, bodies.y[j] - yi);
                let (wx, wy) = (bodies.vx[j] - ui, bodies.vy[j] - vi);
                let squared = closest_squared(dx, dy, wx, wy, limits.time);
                if squared <= limits.watched {
                    self.offer([i as u32, j as u32], squared, limits);
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
            for l in 0..LANES {
                let (wx, wy) = (vx[l] - ui, vy[l] - vi);
                squared[l] = closest_squared(x[l] - xi, y[l] - yi, wx, wy, limits.time);
            }
            let mut near = 0_u32;
            for (l, s) in squared.iter().enumerate() {
                near |= u32::from(*s <= limits.watched) << l;
            }
            // Lanes outside the range: those before it, if we had to step back, and those behind.
            near &= (0xff << (j - base)) & (0xff >> (base + LANES).saturating_sub(range.end));
            while near != 0 {
                let l = near.trailing_zeros() as usize;
                near &= near - 1;
                self.offer([i as u32, (base + l) as u32], squared[l], limits);
            }
            j = base + LANES;
        }
    }

    /// All pairs of particles in the stored cells `range` and ahead of them whose straight paths
    /// come within the margin. Special particles are left out.
    #[inline(always)]
    pub(crate) fn search(
        &mut self,
        bodies: &Bodies,
        cells: &Cells,
        range: Range<usize>,
        layout: &Layout,
    ) {
        self.close.clear();
        self.watched.clear();
        self.tested = 0;
        let span = &layout.span;
        let at_once = span.steps == 1;
        let close = CUTOFF + span.rounding() + if at_once { 0.0 } else { layout.tight };
        let watched = if at_once { close } else { close + layout.margin - layout.tight };
        let limits =
            Limits { time: span.forces(), close: close * close, watched: watched * watched };
        cells.for_each_ahead(range, &mut Searching { found: self, bodies, limits });
        if !at_once {
            let plain = |&[i, k]: &Pair| {
                !layout.is_special(bodies, i as usize) && !layout.is_special(bodies, k as usize)
            };
            self.close.retain(plain);
            self.watched.retain(plain);
        }
    }
}
