//! Pairs, and writing down some of eight of them without a branch.

use super::signs::EIGHT;

/// A pair of indices in the sorted order.
pub type Pair = [u32; 2];

/// For each set of lanes which they are, in order: the numbers of the later particles of pairs.
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

/// Writes a pair [i, start + l] for each of the lowest eight bits l of `set`, in ascending order,
/// behind the `len` pairs of `list`, and returns how many there are now. There must be room for eight.
///
/// All eight pairs are written, whatever the set: the next call overwrites what is too much.
#[inline(always)]
pub fn pack(list: &mut [Pair], len: usize, [i, start]: [usize; 2], set: u32) -> usize {
    // Both numbers of a pair in one word: then one addition makes eight pairs.
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

/// Lengthens `pairs` to at least `len`, if it is shorter, with pairs that mean nothing.
#[inline(always)]
pub fn make_room(pairs: &mut Vec<Pair>, len: usize) {
    if pairs.len() < len {
        pairs.resize(len + len / 8, [0; 2]);
    }
}

/// Pairs that are filtered together.
pub const ROOM: usize = 256;

/// The positions of consecutive particles of the sorted order.
#[derive(Clone, Copy)]
pub struct Positions<'a> {
    /// Their x.
    pub x: &'a [f64],
    /// Their y.
    pub y: &'a [f64],
    /// The index of the first of them in the sorted order.
    pub first: usize,
}

impl Positions<'_> {
    /// Eight particles from index `start` on: their x and their y. Where there are fewer, the rest is
    /// infinitely far away.
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

// Inlined, so that the eight stay in registers where there are eight.
#[cold]
#[inline(always)]
fn the_last(numbers: &[f64]) -> [f64; EIGHT] {
    let mut eight = [f64::INFINITY; EIGHT];
    eight.iter_mut().zip(numbers).for_each(|(to, number)| *to = *number);
    eight
}
