//! Who could meet whom within a window.

use std::ops::Range;

use common::soft::CUTOFF;

use crate::cells::Ahead;
use crate::path::{Span, closest_squared};
use crate::{Bodies, Cells};

/// Particles compared at a time.
pub(crate) const EIGHT: usize = 8;

/// A pair of places in the sorted order.
pub(crate) type Pair = [u32; 2];

/// How a window is laid out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Layout {
    pub(crate) span: Span,
    /// Pairs whose reference paths come within cutoff + `margin` are computed.
    pub(crate) margin: f64,
    /// Particles that go further than this in the window are looked after one by one.
    pub(crate) reach: f64,
}

impl Layout {
    /// How close reference paths come that are computed.
    pub(crate) fn near(&self) -> f64 {
        let margin = if self.span.steps == 1 { 0.0 } else { self.margin };
        CUTOFF + self.span.rounding() + margin
    }

    /// When particles are put into cells: halfway from the first forces of the window to the
    /// last. Nobody is then further from there than half of what it goes.
    pub(crate) fn halfway(&self) -> f64 {
        0.5 * self.span.forces()
    }

    /// Length of a cell's side: who is not [special](Layout::is_special) and could come near is
    /// halfway in the same or in an adjacent cell.
    pub(crate) fn side(&self) -> f64 {
        if self.span.steps == 1 { self.near() } else { self.near() + self.reach }
    }

    /// Whether a particle may leave the straight line or the adjacent cells.
    #[inline(always)]
    pub(crate) fn is_special(&self, bodies: &Bodies, i: usize) -> bool {
        let (vx, vy, fast) = (bodies.vx[i], bodies.vy[i], self.reach / self.span.whole());
        (vx * vx + vy * vy > fast * fast) | self.span.meets_wall(bodies.x[i], bodies.y[i], vx, vy)
    }

    /// Appends the special ones of `range` to `list`.
    #[inline(always)]
    pub(crate) fn specials(&self, bodies: &Bodies, range: Range<usize>, list: &mut Vec<u32>) {
        let mut first = range.start;
        while first < range.end {
            let end = (first + EIGHT).min(range.end);
            let mut any = false;
            for i in first..end {
                any |= self.is_special(bodies, i);
            }
            if any {
                list.extend((first..end).filter(|&i| self.is_special(bodies, i)).map(|i| i as u32));
            }
            first = end;
        }
    }
}

/// By how much the square of the closest approach of particle `i` and each of eight from `base` on
/// exceeds the square of `near`, one for each: negative for those that come nearer. The flights
/// begin at 0 and end at `time`.
#[inline(always)]
fn excess(bodies: &Bodies, i: usize, base: usize, time: f64, near: &[f64; EIGHT]) -> [f64; EIGHT] {
    let lanes = base..base + EIGHT;
    let (x, y) = (&bodies.x[lanes.clone()], &bodies.y[lanes.clone()]);
    let (vx, vy) = (&bodies.vx[lanes.clone()], &bodies.vy[lanes]);
    let (xi, yi, ui, vi) = (bodies.x[i], bodies.y[i], bodies.vx[i], bodies.vy[i]);
    let mut excess = [0.0; EIGHT];
    for l in 0..EIGHT {
        let (wx, wy) = (vx[l] - ui, vy[l] - vi);
        let squared = closest_squared(x[l] - xi, y[l] - yi, wx, wy, time);
        excess[l] = squared - near[l] * near[l];
    }
    excess
}

/// Which of sixteen numbers are negative: a bit for each.
///
/// Not inlined on purpose. The compiler would begin at the bits that somebody asks for, and compute
/// what leads to each of them one by one.
#[inline(never)]
fn negative(numbers: &[f64; 2 * EIGHT]) -> u32 {
    numbers.iter().enumerate().map(|(l, x)| ((x.to_bits() >> 63) as u32) << l).sum()
}

/// Where eight lanes begin that hold the first of `range`, in arrays of `n` ≥ 8.
#[inline(always)]
fn base(range: &Range<usize>, n: usize) -> usize {
    range.start.min(n - EIGHT)
}

/// Of bits for eight lanes from [`base`] on, those for `range`.
#[inline(always)]
fn those_of(bits: u32, range: &Range<usize>, n: usize) -> u32 {
    (bits >> (range.start - base(range, n))) & (0xff >> EIGHT.saturating_sub(range.len()))
}

/// Appends to `list` every particle k of `one` and `two` whose free flight comes within `near` +
/// `bent[k]` of that of particle `i`, until `time`.
///
/// Both ranges at once, since most are much shorter than eight.
#[inline(always)]
#[expect(clippy::too_many_arguments, reason = "a window is wide")]
pub(crate) fn near_in(
    bodies: &Bodies,
    i: usize,
    mut one: Range<usize>,
    mut two: Range<usize>,
    time: f64,
    near: f64,
    bent: Option<&[f32]>,
    mut found: impl Taker,
) {
    let n = bodies.len();
    if n < EIGHT {
        let p = bodies.get(i);
        for k in one.chain(two) {
            let q = bodies.get(k);
            let near = near + bent.map_or(0.0, |bent| f64::from(bent[k]));
            let (dx, dy) = (q.x - p.x, q.y - p.y);
            if closest_squared(dx, dy, q.vx - p.vx, q.vy - p.vy, time) < near * near {
                found.add(k as u32);
            }
        }
        return;
    }
    loop {
        let mut numbers = [0.0; 2 * EIGHT];
        for (half, range) in [&one, &two].into_iter().enumerate() {
            let base = base(range, n);
            let mut limit = [near; EIGHT];
            if let Some(bent) = bent {
                let bent = &bent[base..base + EIGHT];
                for l in 0..EIGHT {
                    limit[l] += f64::from(bent[l]);
                }
            }
            let excess = excess(bodies, i, base, time, &limit);
            numbers[half * EIGHT..(half + 1) * EIGHT].copy_from_slice(&excess);
        }
        let all = negative(&numbers);
        let mut bits = those_of(all & 0xff, &one, n) | those_of(all >> EIGHT, &two, n) << EIGHT;
        while bits != 0 {
            let l = bits.trailing_zeros() as usize;
            bits &= bits - 1;
            found.add(if l < EIGHT { one.start + l } else { two.start + l - EIGHT } as u32);
        }
        if (one.len() <= EIGHT) & (two.len() <= EIGHT) {
            return;
        }
        one.start = (one.start + EIGHT).min(one.end);
        two.start = (two.start + EIGHT).min(two.end);
    }
}

/// Somebody who takes what was found. Not a closure, for the reason given at
/// [`Ahead`](crate::cells::Ahead).
pub(crate) trait Taker {
    fn add(&mut self, k: u32);
}

impl Taker for &mut Vec<u32> {
    #[inline(always)]
    fn add(&mut self, k: u32) {
        self.push(k);
    }
}

/// Pairs of particle `.0` with those found.
struct PairsOf<'a>(u32, &'a mut Vec<Pair>);

impl Taker for PairsOf<'_> {
    #[inline(always)]
    fn add(&mut self, k: u32) {
        self.1.push([self.0, k]);
    }
}

/// What a search finds.
#[derive(Default)]
pub(crate) struct Found {
    /// Pairs that are to be computed.
    pub(crate) close: Vec<Pair>,
    /// How many were looked at.
    pub(crate) tested: u64,
}

/// A search under way.
struct Searching<'a> {
    found: &'a mut Found,
    bodies: &'a Bodies,
    time: f64,
    near: f64,
}

impl Ahead for Searching<'_> {
    #[inline(always)]
    fn visit(&mut self, i: usize, end: usize, next: Range<usize>) {
        let Self { found, bodies, time, near } = self;
        found.tested += (end - i - 1 + next.len()) as u64;
        let pairs = PairsOf(i as u32, &mut found.close);
        near_in(bodies, i, i + 1..end, next, *time, *near, None, pairs);
    }
}

impl Found {
    /// All pairs of particles in the stored cells `range` and ahead of them whose straight paths
    /// come near. Special particles are left out.
    #[inline(always)]
    pub(crate) fn search(
        &mut self,
        bodies: &Bodies,
        cells: &Cells,
        range: Range<usize>,
        layout: &Layout,
    ) {
        self.close.clear();
        self.tested = 0;
        let (time, near) = (layout.span.forces(), layout.near());
        cells.for_each_ahead(range, &mut Searching { found: self, bodies, time, near });
        if layout.span.steps > 1 {
            let special = |i: u32| layout.is_special(bodies, i as usize);
            self.close.retain(|&[i, k]| !special(i) && !special(k));
        }
    }
}
