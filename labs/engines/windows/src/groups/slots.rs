//! Storage for groups, and for the results of their runs.

use std::ops::Range;

use neighbour_list::kernels::Pair;

/// Number of small groups that are computed side by side.
pub(crate) const LANES: usize = 16;

/// Sizes of small groups. Every other group is a crowd.
pub(crate) const SMALL: [usize; 3] = [2, 3, 4];

/// Groups of particles. In a window, a particle may touch only particles of its own group.
///
/// So each group can be computed alone from the start of the window to its end, in any order and by
/// any thread. Every member has a slot. The drawing shows one block of sixteen couples (a, b, …),
/// one block of sixteen threes, and the crowds:
///
/// ```text
/// slot    0           16          32          48          64          80
///         a₀ b₀ … p₀  a₁ b₁ … p₁  a₀ b₀ … p₀  a₁ b₁ … p₁  a₂ b₂ … p₂  crowd 0, crowd 1, …
///         couples                 threes
/// ```
///
/// In the last block of a size some slots may be empty.
#[derive(Default)]
pub(crate) struct Groups {
    /// For each size, the members of all small groups of this size, as indices in the sorted order.
    ///
    /// The groups follow one another; within a group members are in the order of their ids.
    pub(crate) small: [Vec<u32>; SMALL.len()],
    /// The members of all crowds, in the same form.
    pub(crate) members: Vec<u32>,
    /// The end of each crowd in `members`.
    pub(crate) ends: Vec<u32>,
    /// The pairs of all crowds, as indices among the members of the crowd, in ascending order, the
    /// lower id first.
    pub(crate) pairs: Vec<Pair>,
    /// The end of each crowd's pairs in `pairs`.
    pub(crate) pair_ends: Vec<u32>,
    /// The crowd of each member, in the order of `members`.
    pub(crate) crowd_of: Vec<u32>,
}

/// A group, borrowed from [`Groups`].
pub(crate) struct Group<'a> {
    /// The members, as indices in the sorted order.
    pub(crate) members: &'a [u32],
    /// The pairs that are computed, as indices among the members.
    pub(crate) pairs: &'a [Pair],
    /// The slots of the block that is computed together: sixteen small groups or one crowd.
    pub(crate) block: Range<usize>,
}

impl Groups {
    /// Removes all groups.
    pub(crate) fn clear(&mut self) {
        self.small.iter_mut().for_each(Vec::clear);
        self.members.clear();
        self.ends.clear();
        self.pairs.clear();
        self.pair_ends.clear();
        self.crowd_of.clear();
    }

    /// Returns the first slot of each size of small groups, and finally the first slot of crowds.
    pub(crate) fn begins(&self) -> [usize; SMALL.len() + 1] {
        let mut begins = [0; SMALL.len() + 1];
        for (k, (size, small)) in SMALL.iter().zip(&self.small).enumerate() {
            begins[k + 1] = begins[k] + (small.len() / size).div_ceil(LANES) * LANES * size;
        }
        begins
    }

    /// Returns the first slot of crowds.
    pub(crate) fn crowds_begin(&self) -> usize {
        self.begins()[SMALL.len()]
    }

    /// Returns the number of slots.
    pub(crate) fn slots(&self) -> usize {
        self.crowds_begin() + self.members.len()
    }

    /// Returns the number of members of all groups.
    pub(crate) fn member_count(&self) -> usize {
        self.small.iter().chain([&self.members]).map(Vec::len).sum()
    }

    /// Returns crowd `g`.
    pub(crate) fn crowd(&self, g: usize) -> Group<'_> {
        let range = part(&self.ends, g);
        let begin = self.crowds_begin();
        let block = begin + range.start..begin + range.end;
        Group { members: &self.members[range], pairs: &self.pairs[part(&self.pair_ends, g)], block }
    }

    /// Calls `visit` with the slot of every member and its index in the sorted order.
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

    /// Returns the group of slot `p`.
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
    /// Whether the group computes the pair of particles `i` and `k`.
    pub(crate) fn computes(&self, i: u32, k: u32) -> bool {
        let [Some(a), Some(b)] = [i, k].map(|index| self.members.iter().position(|&m| m == index))
        else {
            return false;
        };
        self.pairs.binary_search(&[a.min(b) as u32, a.max(b) as u32]).is_ok()
    }
}

/// Returns the range of part k, if parts follow one another from 0 on and end at `ends`.
fn part(ends: &[u32], k: usize) -> Range<usize> {
    let start = k.checked_sub(1).map_or(0, |before| ends[before] as usize);
    start..ends[k] as usize
}

/// The members of groups after the window, and their deviations from their reference paths.
#[derive(Clone, Default)]
pub(crate) struct Record {
    pub(crate) x: Vec<f64>,
    pub(crate) y: Vec<f64>,
    pub(crate) vx: Vec<f64>,
    pub(crate) vy: Vec<f64>,
    /// The greatest deviation from the reference path, beyond the path's spread; a length.
    pub(crate) deviation: Vec<f64>,
    /// Displacement from the path along x and y after each step but the last. The order is by
    /// block, then by step, then by slot.
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

    /// Returns the part of the record with the slots of a block.
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

    /// Returns the displacement of the member in slot `p` of a block from its reference path after
    /// `step` steps.
    ///
    /// `step` is at least 1 and less than the number of steps.
    #[inline]
    pub(crate) fn off(&self, block: &Range<usize>, p: usize, step: usize) -> [f64; 2] {
        let entry = block.start * self.steps + (step - 1) * block.len() + p - block.start;
        self.off[entry].map(f64::from)
    }
}
