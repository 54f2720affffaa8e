//! Groups of particles that touch no particle outside, and where running them takes them.

use std::ops::Range;

use neighbour_list::kernels::Pair;

/// Groups computed side by side.
pub(crate) const LANES: usize = 16;

/// Groups of particles that may touch each other in a window, and no other. Each can be computed on
/// its own from the window's start to its end, in any order, by any thread.
///
/// Every member has a slot. Slots of small groups stand in blocks of sixteen groups: the first
/// members of all, the second members of all, and so on; in the last block some may stay empty.
#[derive(Default)]
pub(crate) struct Groups {
    /// Groups of two, the most frequent by far, then three and four, by id within each. They hold
    /// indices in the sorted order.
    pub(crate) couples: Vec<Pair>,
    pub(crate) triples: Vec<[u32; 3]>,
    pub(crate) quads: Vec<[u32; 4]>,
    /// Members of all other groups, one group after another, by id within each.
    pub(crate) members: Vec<u32>,
    /// Where each of these groups ends in `members`.
    pub(crate) ends: Vec<u32>,
    /// Their pairs: numbers within the group, the lower id first, ascending.
    pub(crate) pairs: Vec<Pair>,
    /// Where the pairs of each group end in `pairs`.
    pub(crate) pair_ends: Vec<u32>,
    /// The group of each of `members`.
    pub(crate) group_of: Vec<u32>,
}

/// One of the groups.
pub(crate) struct Group<'a> {
    /// The members of the group.
    pub(crate) members: &'a [u32],
    /// Which pairs of them are computed: the ones of this crowd, or all.
    pub(crate) crowd: Option<usize>,
}

fn blocks(groups: usize, size: usize) -> usize {
    groups.div_ceil(LANES) * LANES * size
}

impl Groups {
    /// Forgets all groups.
    pub(crate) fn clear(&mut self) {
        self.couples.clear();
        self.triples.clear();
        self.quads.clear();
        self.members.clear();
        self.ends.clear();
        self.pairs.clear();
        self.pair_ends.clear();
        self.group_of.clear();
    }

    /// Where the slots of triples, quadruples and crowds begin.
    pub(crate) fn begins(&self) -> [usize; 3] {
        let triples = blocks(self.couples.len(), 2);
        let quads = triples + blocks(self.triples.len(), 3);
        [triples, quads, quads + blocks(self.quads.len(), 4)]
    }

    /// How many slots there are.
    pub(crate) fn slots(&self) -> usize {
        self.begins()[2] + self.members.len()
    }

    /// How many members all groups have.
    pub(crate) fn member_count(&self) -> usize {
        2 * self.couples.len() + 3 * self.triples.len() + 4 * self.quads.len() + self.members.len()
    }

    /// The range of `members` that is crowd `g`.
    pub(crate) fn crowd(&self, g: usize) -> Range<usize> {
        let start = g.checked_sub(1).map_or(0, |before| self.ends[before] as usize);
        start..self.ends[g] as usize
    }

    /// The pairs of crowd `g`.
    pub(crate) fn pairs_of(&self, g: usize) -> &[Pair] {
        let start = g.checked_sub(1).map_or(0, |before| self.pair_ends[before] as usize);
        &self.pairs[start..self.pair_ends[g] as usize]
    }

    /// Whether the pair of particles `i`, a member of `group`, and `k` is computed.
    pub(crate) fn computes(&self, group: &Group<'_>, i: u32, k: u32) -> bool {
        let local = |index| group.members.iter().position(|&member| member == index);
        let (Some(a), Some(b)) = (local(i), local(k)) else { return false };
        let pair = [a.min(b) as u32, a.max(b) as u32];
        group.crowd.is_none_or(|g| self.pairs_of(g).binary_search(&pair).is_ok())
    }

    /// Visits every member: its slot, its index in the sorted order.
    pub(crate) fn for_each_member(&self, mut visit: impl FnMut(usize, u32)) {
        fn small<const M: usize>(
            groups: &[[u32; M]],
            first: usize,
            visit: &mut impl FnMut(usize, u32),
        ) {
            for (k, group) in groups.iter().enumerate() {
                let slot = first + k / LANES * LANES * M + k % LANES;
                for (m, &i) in group.iter().enumerate() {
                    visit(slot + m * LANES, i);
                }
            }
        }
        let [triples, quads, crowds] = self.begins();
        small(&self.couples, 0, &mut visit);
        small(&self.triples, triples, &mut visit);
        small(&self.quads, quads, &mut visit);
        for (k, &i) in self.members.iter().enumerate() {
            visit(crowds + k, i);
        }
    }

    /// The block that slot `p` is in.
    #[inline]
    pub(crate) fn block(&self, p: usize) -> Range<usize> {
        let [triples, quads, crowds] = self.begins();
        let small = |first: usize, size: usize| {
            let start = first + (p - first) / (LANES * size) * (LANES * size);
            start..start + LANES * size
        };
        match p {
            p if p < triples => small(0, 2),
            p if p < quads => small(triples, 3),
            p if p < crowds => small(quads, 4),
            p => {
                let crowd = self.crowd(self.group_of[p - crowds] as usize);
                crowds + crowd.start..crowds + crowd.end
            }
        }
    }

    /// The group that slot `p` belongs to.
    pub(crate) fn group(&self, p: usize) -> Group<'_> {
        let [triples, quads, crowds] = self.begins();
        let block = self.block(p);
        let number =
            |first: usize, size: usize| (block.start - first) / size + (p - block.start) % LANES;
        let (members, crowd): (&[u32], _) = match p {
            p if p < triples => (&self.couples[number(0, 2)], None),
            p if p < quads => (&self.triples[number(triples, 3)], None),
            p if p < crowds => (&self.quads[number(quads, 4)], None),
            p => {
                let g = self.group_of[p - crowds] as usize;
                (&self.members[self.crowd(g)], Some(g))
            }
        };
        Group { members, crowd }
    }
}

/// Where the members of groups are after some steps, and how far they were off their reference
/// paths meanwhile.
///
/// Members stand in blocks; a block is what runs together: sixteen couples, triples or quadruples,
/// or one larger group.
#[derive(Clone, Default)]
pub(crate) struct Record {
    pub(crate) x: Vec<f64>,
    pub(crate) y: Vec<f64>,
    pub(crate) vx: Vec<f64>,
    pub(crate) vy: Vec<f64>,
    /// The greatest deviation, beyond the path's own spread.
    pub(crate) deviation: Vec<f64>,
    /// How far off after each step but the last: block by block, in it step by step, in it member
    /// by member.
    off_x: Vec<f32>,
    off_y: Vec<f32>,
    steps: usize,
}

/// The part of a [`Record`] that one block writes.
pub(crate) struct Slice<'a> {
    pub(crate) x: &'a mut [f64],
    pub(crate) y: &'a mut [f64],
    pub(crate) vx: &'a mut [f64],
    pub(crate) vy: &'a mut [f64],
    pub(crate) deviation: &'a mut [f64],
    pub(crate) off_x: &'a mut [f32],
    pub(crate) off_y: &'a mut [f32],
}

impl Record {
    /// Makes room for `n` members and `steps` steps.
    pub(crate) fn resize(&mut self, n: usize, steps: u32) {
        for array in [&mut self.x, &mut self.y, &mut self.vx, &mut self.vy, &mut self.deviation] {
            array.resize(n, 0.0);
        }
        self.steps = steps.saturating_sub(1) as usize;
        for array in [&mut self.off_x, &mut self.off_y] {
            array.resize(n * self.steps, 0.0);
        }
    }

    /// The block of `width` members from `first` on.
    pub(crate) fn block(&mut self, first: usize, width: usize) -> Slice<'_> {
        let own = first..first + width;
        let offs = first * self.steps..(first + width) * self.steps;
        Slice {
            x: &mut self.x[own.clone()],
            y: &mut self.y[own.clone()],
            vx: &mut self.vx[own.clone()],
            vy: &mut self.vy[own.clone()],
            deviation: &mut self.deviation[own],
            off_x: &mut self.off_x[offs.clone()],
            off_y: &mut self.off_y[offs],
        }
    }

    /// How far the `member`-th of a block was off its reference path after `step` steps, at least
    /// one and not all of them.
    #[inline]
    pub(crate) fn off(
        &self,
        block: &std::ops::Range<usize>,
        member: usize,
        step: usize,
    ) -> (f64, f64) {
        let entry = block.start * self.steps + (step - 1) * block.len() + member;
        (f64::from(self.off_x[entry]), f64::from(self.off_y[entry]))
    }
}
