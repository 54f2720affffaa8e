//! The engine's own primitives.

use std::f64::consts::PI;
use std::ops::Range;

use common::soft::CUTOFF;

use neighbour_list_core::kernels::{EIGHT, Pair, Positions, ROOM, Signs, pack};
use neighbour_list_core::{LISTED, Primitives, REBUILD, TESTED};

/// Fast [`Primitives`]: [`collect`], [`filter`] and three more.
#[derive(Clone, Copy, Debug, Default)]
pub struct Standard;

impl Primitives for Standard {
    #[inline(always)]
    fn drift(x: &mut [f64], v: &mut [f64], a: &[f64], dt: f64, size: f64) -> bool {
        let n = x.len();
        let (v, a) = (&mut v[..n], &a[..n]);
        let mut outside = false;
        for i in 0..n {
            v[i] += a[i] * dt;
            x[i] += v[i] * dt;
            outside |= (x[i] < 0.0) | (x[i] > size);
        }
        outside
    }

    #[inline(always)]
    fn collect(
        list: &mut [Pair],
        len: usize,
        positions: Positions<'_>,
        i: usize,
        range: Range<usize>,
        reach: f64,
        signs: impl Signs,
    ) -> usize {
        collect(list, len, positions, i, range, reach, signs)
    }

    #[inline(always)]
    fn filter(
        pairs: &[Pair],
        positions: Positions<'_>,
        squared: f64,
        near: &mut [Pair; ROOM],
    ) -> usize {
        filter(pairs, positions, squared, near)
    }

    fn expired(displacement: f64, skin: f64) -> bool {
        2.0 * displacement > skin
    }

    /// Of 0.05, 0.1, … 3 cutoffs, by the costs [`REBUILD`], [`TESTED`] and [`LISTED`].
    fn best_skin(density: f64, displacement: f64) -> f64 {
        let cost = |skin: f64| {
            let area = (CUTOFF + skin) * (CUTOFF + skin);
            let rebuilds = (2.0 * displacement / skin).min(1.0);
            rebuilds * (REBUILD + TESTED * 4.5 * area * density)
                + LISTED * 0.5 * PI * area * density
        };
        let mut best = 0.05 * CUTOFF;
        for twentieths in 2..=60 {
            let skin = f64::from(twentieths) * 0.05 * CUTOFF;
            if cost(skin) < cost(best) {
                best = skin;
            }
        }
        best
    }
}

/// [`Primitives::collect`], eight particles at a time and without a branch on a distance.
#[inline(always)]
pub fn collect(
    list: &mut [Pair],
    mut len: usize,
    positions: Positions<'_>,
    i: usize,
    range: Range<usize>,
    reach: f64,
    signs: impl Signs,
) -> usize {
    let (xi, yi) = (positions.x[i], positions.y[i]);
    let mut start = range.start;
    loop {
        let (x, y) = positions.eight(start);
        let mut spare = [0.0; EIGHT];
        for l in 0..EIGHT {
            let (dx, dy) = (x[l] - xi, y[l] - yi);
            spare[l] = (reach * reach - (dx * dx + dy * dy)) as f32;
        }
        let in_range = (1 << (range.end - start).min(EIGHT)) - 1;
        len = pack(list, len, [i, start], in_range & !signs.negative(&spare));
        start += EIGHT;
        if start >= range.end {
            return len;
        }
    }
}

/// [`Primitives::filter`]: every pair is written, and overwritten by the next one unless it is near.
#[inline(always)]
pub fn filter(
    pairs: &[Pair],
    positions: Positions<'_>,
    squared: f64,
    near: &mut [Pair; ROOM],
) -> usize {
    let Positions { x, y, first } = positions;
    let y = &y[..x.len()];
    let mut len = 0;
    for &pair in pairs {
        let [i, j] = pair.map(|i| i as usize - first);
        let (dx, dy) = (x[j] - x[i], y[j] - y[i]);
        // Never beyond the end, and this way the compiler knows.
        near[len & (ROOM - 1)] = pair;
        len += usize::from(dx * dx + dy * dy <= squared);
    }
    len
}
