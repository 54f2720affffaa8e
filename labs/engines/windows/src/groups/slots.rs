//! Groups of particles that touch no particle outside, and where running them takes them.

use std::ops::Range;

use neighbour_list::kernels::Pair;

/// Small groups computed side by side.
pub(crate) const LANES: usize = 16;

/// Sizes of small groups; any other group is a crowd.
pub(crate) const SMALL: [usize; 3] = [2, 3, 4];

/// Groups of particles that may touch each other in a window, and no other. Each can be computed on
/// its own from the window's start to its end, in any order, by any thread.
///
/// Every member has a slot. Slots of small groups stand in blocks of sixteen groups: the first
/// members of all, the second members of all, and so on; in the last block some may stay empty. Behind them are those
/// of crowds.
#[derive(Default)]
pub(crate) struct Groups {
    /// For each size the members of all small groups, one group after another, by id within each. They are indices in
    /// the sorted order.
    pub(crate) small: [Vec<u32>; SMALL.len()],
    /// The same of the crowds.
    pub(crate) members: Vec<u32>,
    /// Where each of these crowds ends in `members`.
    pub(crate) ends: Vec<u32>,
    /// Their pairs: numbers within the crowd, the lower id first, ascending.
    pub(crate) pairs: Vec<Pair>,
    /// Where the pairs of each crowd end in `pairs`.
    pub(crate) pair_ends: Vec<u32>,
    /// The crowd of each of `members`.
    pub(crate) crowd_of: Vec<u32>,
}

/// One of the groups.
pub(crate) struct Group<'a> {
    /// Its members.
    pub(crate) members: &'a [u32],
    /// Which pairs of them are computed, by their numbers among the members.
    pub(crate) pairs: &'a [Pair],
    /// The slots of its block, which is computed together: of sixteen small groups, or of one crowd.
    pub(crate) block: Range<usize>,
}

impl Groups {
    /// Forgets all groups.
    pub(crate) fn clear(&mut self) {
        self.small.iter_mut().for_each(Vec::clear);
        self.members.clear();
        self.ends.clear();
        self.pairs.clear();
        self.pair_ends.clear();
        self.crowd_of.clear();
    }

    /// Where the slots of small groups of each size begin, and at last those of crowds.
    pub(crate) fn begins(&self) -> [usize; SMALL.len() + 1] {
        let mut begins = [0; SMALL.len() + 1];
        for (k, (size, small)) in SMALL.iter().zip(&self.small).enumerate() {
            begins[k + 1] = begins[k] + (small.len() / size).div_ceil(LANES) * LANES * size;
        }
        begins
    }

    /// Where the slots of crowds begin.
    pub(crate) fn crowds_begin(&self) -> usize {
        self.begins()[SMALL.len()]
    }

    /// How many slots there are.
    pub(crate) fn slots(&self) -> usize {
        self.crowds_begin() + self.members.len()
    }

    /// How many members all groups have.
    pub(crate) fn member_count(&self) -> usize {
        self.small.iter().chain([&self.members]).map(Vec::len).sum()
    }

    /// Crowd `g`.
    pub(crate) fn crowd(&self, g: usize) -> Group<'_> {
        let range = part(&self.ends, g);
        let begin = self.crowds_begin();
        let block = begin + range.start..begin + range.end;
        Group { members: &self.members[range], pairs: &self.pairs[part(&self.pair_ends, g)], block }
    }

    /// Visits every member: its slot, its index in the sorted order.
    pub(crate) fn for_each_member(&self, mut visit: impl FnMut(usize, u32)) {
        let begins = self.begins();
        for (s, size) in SMALL.into_iter().enumerate() {
            for (k, group) in self.small[s].chunks_exact(size).enumerate() {
                let slot = begins[s] + k / LANES * LANES * size + k % LANES;
                for (m, &i) in group.iter().enumerate() {
                    visit(slot + m * LANES, i);
                }
            }
        }
        for (slot, &i) in (begins[SMALL.len()]..).zip(&self.members) {
            visit(slot, i);
        }
    }

    /// The group that slot `p` belongs to.
    pub(crate) fn group(&self, p: usize) -> Group<'_> {
        const PAIRS: [&[Pair]; SMALL.len()] = [
            &[[0, 1]],
            &[[0, 1], [0, 2], [1, 2]],
            &[[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]],
        ];
        let begins = self.begins();
        if let Some(member) = p.checked_sub(begins[SMALL.len()]) {
            return self.crowd(self.crowd_of[member] as usize);
        }
        let k = begins[1..].partition_point(|end| *end <= p);
        let p = p - begins[k];
        let size = SMALL[k];
        let width = size * LANES;
        let before = p / width * width;
        let first = before + p % LANES * size;
        let block = begins[k] + before..begins[k] + before + width;
        Group { members: &self.small[k][first..first + size], pairs: PAIRS[k], block }
    }
}

impl Group<'_> {
    /// Whether the pair of particles `i` and `k` is computed.
    pub(crate) fn computes(&self, i: u32, k: u32) -> bool {
        let [Some(a), Some(b)] = [i, k].map(|index| self.members.iter().position(|&m| m == index))
        else {
            return false;
        };
        self.pairs.binary_search(&[a.min(b) as u32, a.max(b) as u32]).is_ok()
    }
}

/// The part of several, one after another, that is number `k`; `ends` says where each ends.
fn part(ends: &[u32], k: usize) -> Range<usize> {
    let start = k.checked_sub(1).map_or(0, |before| ends[before] as usize);
    start..ends[k] as usize
}

/// Where the members of groups are after some steps, and how far they were off their reference
/// paths meanwhile.
#[derive(Clone, Default)]
pub(crate) struct Record {
    pub(crate) x: Vec<f64>,
    pub(crate) y: Vec<f64>,
    pub(crate) vx: Vec<f64>,
    pub(crate) vy: Vec<f64>,
    /// The greatest deviation, beyond the path's own spread.
    pub(crate) deviation: Vec<f64>,
    /// How far off along x and y after each step but the last: block by block, in it step by step, in it slot by slot.
    off: Vec<[f32; 2]>,
    steps: usize,
}

/// The part of a [`Record`] that one block writes.
pub(crate) struct Slice<'a> {
    pub(crate) x: &'a mut [f64],
    pub(crate) y: &'a mut [f64],
    pub(crate) vx: &'a mut [f64],
    pub(crate) vy: &'a mut [f64],
    pub(crate) deviation: &'a mut [f64],
    pub(crate) off: &'a mut [[f32; 2]],
}

impl Record {
    /// Makes room for `n` members and `steps` steps.
    pub(crate) fn resize(&mut self, n: usize, steps: u32) {
        for array in [&mut self.x, &mut self.y, &mut self.vx, &mut self.vy, &mut self.deviation] {
            array.resize(n, 0.0);
        }
        self.steps = steps.saturating_sub(1) as usize;
        self.off.resize(n * self.steps, [0.0; 2]);
    }

    /// The slots of a block.
    pub(crate) fn slice(&mut self, block: Range<usize>) -> Slice<'_> {
        Slice {
            x: &mut self.x[block.clone()],
            y: &mut self.y[block.clone()],
            vx: &mut self.vx[block.clone()],
            vy: &mut self.vy[block.clone()],
            deviation: &mut self.deviation[block.clone()],
            off: &mut self.off[block.start * self.steps..block.end * self.steps],
        }
    }

    /// How far the member in slot `p` of a block was off its reference path after `step` steps, at least
    /// one and not all of them.
    #[inline]
    pub(crate) fn off(&self, block: &Range<usize>, p: usize, step: usize) -> [f64; 2] {
        let entry = block.start * self.steps + (step - 1) * block.len() + p - block.start;
        self.off[entry].map(f64::from)
    }
}
