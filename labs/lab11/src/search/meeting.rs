//! How near eight pairs of free flights come, in single precision.

use std::ops::Range;

use solution10::kernels::{EIGHT, Signs};

use super::found::Found;

/// One less 32 roundings of single precision: twice what a comparison makes.
const LESS: f32 = 1.0 - 32.0 * 0.5 * f32::EPSILON;

/// Flights to look at.
#[derive(Clone, Copy)]
pub(crate) struct View<'a> {
    pub(crate) x: &'a [i32],
    pub(crate) y: &'a [i32],
    pub(crate) half_x: &'a [f32],
    pub(crate) half_y: &'a [f32],
    /// Units in a length of one.
    pub(crate) scale: f32,
}

/// Eight times two flights, how near they come.
///
/// Halfway the two are d apart, and they go on by w until the end and came by w since the
/// beginning. If |d·w| ≥ w·w they are nearest at one of the ends, where the squared distance is
/// d·d + w·w − 2 |d·w|; else in between, where it is d·d − (d·w)² / w·w.
struct Meeting {
    /// d·d, w·w and |d·w|.
    dd: [f32; EIGHT],
    ww: [f32; EIGHT],
    dw: [f32; EIGHT],
}

impl Meeting {
    /// Which of them may come within their limits: a bit for each.
    ///
    /// No division: what is compared with the limit may be multiplied by w·w first.
    #[inline(always)]
    fn within(&self, limits: &[f32; EIGHT], signs: impl Signs) -> u32 {
        let mut excess = [0.0; EIGHT];
        for l in 0..EIGHT {
            let (dd, ww, dw) = (self.dd[l], self.ww[l], self.dw[l]);
            let limit = limits[l] * limits[l];
            let at_an_end = (dd + ww) * LESS - (dw + dw) - limit;
            let between = (dd * LESS - limit) * ww - dw * dw;
            let between = if dw < ww { between } else { 1.0 };
            excess[l] = if at_an_end < between { at_an_end } else { between };
        }
        signs.negative(&excess)
    }
}

impl View<'_> {
    /// Particle `i` and the eight from `first` on.
    #[inline(always)]
    fn meeting(&self, i: usize, first: usize) -> Meeting {
        let lanes = first..first + EIGHT;
        let (xi, yi, ui, vi) = (self.x[i], self.y[i], self.half_x[i], self.half_y[i]);
        let (x, y) = (&self.x[lanes.clone()], &self.y[lanes.clone()]);
        let (u, v) = (&self.half_x[lanes.clone()], &self.half_y[lanes]);
        let [mut dd, mut ww, mut dw] = [[0.0; EIGHT]; 3];
        for l in 0..EIGHT {
            let (dx, dy) = (x[l].wrapping_sub(xi) as f32, y[l].wrapping_sub(yi) as f32);
            let (wx, wy) = (u[l] - ui, v[l] - vi);
            dd[l] = dx * dx + dy * dy;
            ww[l] = wx * wx + wy * wy;
            dw[l] = (dx * wx + dy * wy).abs();
        }
        Meeting { dd, ww, dw }
    }

    /// Writes down particle `i` with every particle of `one` and `two` whose free flight may come
    /// within `limit` of its own.
    ///
    /// Both ranges at once, since most are much shorter than eight.
    #[inline(always)]
    pub(crate) fn pairs(
        &self,
        signs: impl Signs,
        i: usize,
        mut one: Range<usize>,
        mut two: Range<usize>,
        limit: f32,
        found: &mut Found,
    ) {
        loop {
            let (a, b) = (self.meeting(i, one.start), self.meeting(i, two.start));
            let in_range = first(one.len()) | first(two.len()) << EIGHT;
            let limits = [limit; EIGHT];
            let near = (a.within(&limits, signs) | b.within(&limits, signs) << EIGHT) & in_range;
            found.add(i, [one.start, two.start], near);
            if (one.len() <= EIGHT) & (two.len() <= EIGHT) {
                return;
            }
            one.start = (one.start + EIGHT).min(one.end);
            two.start = (two.start + EIGHT).min(two.end);
        }
    }

    /// Appends to `list` every particle of `range` whose free flight may come within `limit` of that
    /// of particle `i`, and `deviation[k]` closer for particle `k`.
    #[inline(always)]
    pub(crate) fn near(
        &self,
        signs: impl Signs,
        i: usize,
        range: Range<usize>,
        limit: f32,
        deviation: &[f32],
        list: &mut Vec<u32>,
    ) {
        for start in range.clone().step_by(EIGHT) {
            let deviation = &deviation[start..start + EIGHT];
            let mut limits = [limit; EIGHT];
            for l in 0..EIGHT {
                limits[l] += deviation[l] * self.scale;
            }
            let meeting = self.meeting(i, start);
            let mut bits = meeting.within(&limits, signs) & first(range.end - start);
            while bits != 0 {
                list.push(start as u32 + bits.trailing_zeros());
                bits &= bits - 1;
            }
        }
    }
}

/// As many bits, at most eight.
#[inline(always)]
fn first(bits: usize) -> u32 {
    0xff >> EIGHT.saturating_sub(bits)
}
