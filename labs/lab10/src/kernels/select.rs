//! Pairs, and writing down some of eight of them without a branch.

use super::signs::EIGHT;

/// A pair of indices in the sorted order.
pub type Pair = [u32; 2];

/// For each set of lanes which they are, in order: the numbers of the later particles of pairs.
static LANES: [[u64; EIGHT]; 256] = {
    let mut lanes = [[0; EIGHT]; 256];
    let mut set = 0;
    while set < lanes.len() {
        let (mut len, mut lane) = (0, 0);
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
/// behind the `len` pairs of `list`, and brings back how many there are now. There must be room for
/// eight.
///
/// All eight places are written, whatever the set: the next call overwrites what is too much.
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

/// Pairs that are filtered together.
pub const ROOM: usize = 256;

/// Where consecutive particles are.
#[derive(Clone, Copy)]
pub struct Places<'a> {
    /// Their x.
    pub x: &'a [f64],
    /// Their y.
    pub y: &'a [f64],
    /// The place of the first of them in the sorted order.
    pub first: usize,
}
