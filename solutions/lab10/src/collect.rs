//! The neighbours of one particle, without a branch.

use std::ops::Range;

use neighbour_list_core::kernels::{EIGHT, Pair, Positions, Signs, pack};

/// For every particle j of `range` that is within `reach` of particle `i`, writes [i, j] into `list`.
///
/// Returns the index in `list` at which the pairs now end. The new pairs are in ascending order. A
/// particle exactly at `reach` is within reach.
///
/// - `list`: `list[..len]` contains the pairs found before. After them, there is room for all of `range`
///   and eight more pairs.
/// - `positions`: the positions of all particles, in units of length.
/// - `i` and `range`: indices in the sorted order; `i` is not in `range`. The range may be empty, and it
///   is usually shorter than eight.
/// - `signs`: computes which of eight numbers have a minus sign, as one bit for each number.
///
/// The processor would often mispredict a branch on the distance. It would also mispredict the end of a
/// loop over a short `range`. So always compare eight particles at a time, even if the range has fewer.
/// Take a longer range in pieces of eight. Keep only the particles in the range and within reach.
/// [`Positions::eight`] fetches eight positions. Of eight pairs, [`pack`] writes the pairs that you
/// select.
///
/// [`Signs::negative`] takes eight `f32`. Compute the differences whose signs you need in `f64`,
/// and convert only these differences. The conversion keeps the sign of even the smallest
/// difference, and a difference of 0 becomes +0.
///
/// Book: chapter 10, *The neighbours of a particle*.
#[inline(always)]
pub fn collect(
    list: &mut [Pair],
    len: usize,
    positions: Positions<'_>,
    i: usize,
    range: Range<usize>,
    reach: f64,
    signs: impl Signs,
) -> usize {
    // task 10.2: the neighbours of one particle
    let (xi, yi) = (positions.x[i], positions.y[i]);
    let (mut len, mut start) = (len, range.start);
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
    // end 10.2
}
