//! Pairs, and a way to write any subset of eight pairs without a branch.

use super::signs::EIGHT;

/// A pair of indices in the sorted order.
pub type Pair = [u32; 2];

/// For each set of lanes, its lanes in ascending order, each in the upper half of a word.
static LANES: [[u64; EIGHT]; 256] = {
    let mut lanes = [[0; EIGHT]; 256];
    let mut set = 0;
    while set < lanes.len() {
        let mut len = 0;
        let mut lane = 0;
        while lane < EIGHT {
            if set >> lane & 1 == 1 {
                lanes[set][len] = (lane as u64) << 32;
                len += 1;
            }
            lane += 1;
        }
        set += 1;
    }
    lanes
};

/// Appends a pair [i, start + l] to `list` for each l among the lowest eight bits of `set`.
///
/// Before the call, `list` has `len` pairs.
///
/// The pairs are in ascending order. Returns the new number of pairs. There must be room for eight
/// pairs, because eight pairs are always written; the next call overwrites the pairs that do not
/// count.
#[inline(always)]
pub fn pack(list: &mut [Pair], len: usize, [i, start]: [usize; 2], set: u32) -> usize {
    // Both indices of a pair are in one word, so one addition computes the pair.
    let first = i as u64 | (start as u64) << 32;
    let set = set as usize % LANES.len();
    let lanes = &LANES[set];
    let pairs = &mut list[len..len + EIGHT];
    for l in 0..EIGHT {
        let both = first + lanes[l];
        pairs[l] = [both as u32, (both >> 32) as u32];
    }
    len + set.count_ones() as usize
}

/// Lengthens `pairs` to at least `len` pairs. The new pairs have no meaning.
#[inline(always)]
pub fn make_room(pairs: &mut Vec<Pair>, len: usize) {
    if pairs.len() < len {
        pairs.resize(len + len / 8, [0; 2]);
    }
}

/// Number of pairs that are filtered together.
pub const ROOM: usize = 256;

/// The positions of consecutive particles of the sorted order.
#[derive(Clone, Copy)]
pub struct Positions<'a> {
    /// Positions along x.
    pub x: &'a [f64],
    /// Positions along y.
    pub y: &'a [f64],
    /// The index of the first particle in the sorted order.
    pub first: usize,
}

impl Positions<'_> {
    /// Returns x and y of eight particles from index `start` on; x and y are infinite for particles
    /// that do not exist.
    #[inline(always)]
    pub fn eight(&self, start: usize) -> ([f64; EIGHT], [f64; EIGHT]) {
        let start = start - self.first;
        let eight = |numbers: &[f64]| match numbers[start..].first_chunk() {
            Some(eight) => *eight,
            None => the_last(&numbers[start..]),
        };
        (eight(self.x), eight(self.y))
    }
}

// Inlined, so that the eight numbers stay in registers in the usual case.
#[cold]
#[inline(always)]
fn the_last(numbers: &[f64]) -> [f64; EIGHT] {
    let mut eight = [f64::INFINITY; EIGHT];
    eight.iter_mut().zip(numbers).for_each(|(to, number)| *to = *number);
    eight
}
