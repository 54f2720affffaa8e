//! The third step of grouping: puts members and pairs into the order in which groups are computed.
//!
//! The drawing in [`grouper`](super::grouper) shows this step as "lay out".

use neighbour_list::Bodies;
use neighbour_list::kernels::Pair;

use super::numbering::Numbering;
use super::slots::{Groups, SMALL};
use super::union::{NO_GROUP, Union};

/// Entry of `crowd_of` for a group that is not a crowd.
const NO_CROWD: u32 = u32::MAX;

/// The working memory of this step.
#[derive(Default)]
pub(super) struct Arrangement {
    /// The numbers of all members, group by group.
    members: Vec<u32>,
    /// For each particle number, the index of the particle among the members of its crowd.
    local: Vec<u32>,
    /// For each group, the crowd that it becomes, or [`NO_CROWD`].
    crowd_of: Vec<u32>,
}

impl Arrangement {
    /// Writes all groups to `groups`, each with its members in the order of their ids.
    pub(super) fn lay_out(
        &mut self,
        bodies: &Bodies,
        numbering: &Numbering,
        union: &Union,
        groups: &mut Groups,
    ) {
        let particle = |number: u32| numbering.particles[number as usize];
        let ends = self.bring_together(union, numbering.particles.len());
        self.local.resize(numbering.particles.len(), 0);
        self.crowd_of.clear();
        let mut start = 0;
        for (group, &end) in ends.iter().enumerate() {
            let members = &mut self.members[start..end as usize];
            start = end as usize;
            members.sort_unstable_by_key(|&number| bodies.id[particle(number) as usize]);
            // A group of two has numbers only if its pair was found twice. Otherwise the group is a
            // couple, which has been handled already.
            let small = SMALL[1..].iter().position(|size| *size == members.len());
            if let Some(k) = small.filter(|_| group >= union.crowds) {
                groups.small[k + 1].extend(members.iter().map(|&number| particle(number)));
                self.crowd_of.push(NO_CROWD);
                continue;
            }
            for (local, &number) in (0..).zip(&*members) {
                self.local[number as usize] = local;
            }
            let crowd = groups.ends.len() as u32;
            groups.members.extend(members.iter().map(|&number| particle(number)));
            groups.crowd_of.resize(groups.members.len(), crowd);
            groups.ends.push(groups.members.len() as u32);
            self.crowd_of.push(crowd);
        }
        self.lay_out_pairs(numbering, union, groups);
    }

    /// Sorts the members by group, and returns the end of each group.
    fn bring_together(&mut self, union: &Union, count: usize) -> Vec<u32> {
        let mut next = running_starts(&union.sizes);
        self.members.resize(count, 0);
        for number in 0..count as u32 {
            let group = union.group(number);
            if group != NO_GROUP {
                let next = &mut next[group as usize];
                self.members[*next as usize] = number;
                *next += 1;
            }
        }
        next
    }

    /// Writes the pairs of all crowds.
    fn lay_out_pairs(&self, numbering: &Numbering, union: &Union, groups: &mut Groups) {
        let mut counts = vec![0; groups.ends.len()];
        for crowd in numbering.pairs.iter().filter_map(|pair| self.crowd(union, pair)) {
            counts[crowd] += 1;
        }
        groups.pairs.resize(counts.iter().sum::<u32>() as usize, [0; 2]);
        let mut next = running_starts(&counts);
        for pair in &numbering.pairs {
            if let Some(crowd) = self.crowd(union, pair) {
                let [a, b] = pair.map(|number| self.local[number as usize]);
                groups.pairs[next[crowd] as usize] = [a.min(b), a.max(b)];
                next[crowd] += 1;
            }
        }
        sort_pairs(groups, &next);
    }

    /// Returns the crowd of a pair, or `None` if the pair is in no crowd.
    fn crowd(&self, union: &Union, pair: &Pair) -> Option<usize> {
        let group = union.group(pair[0]);
        let crowd = if group == NO_GROUP { NO_CROWD } else { self.crowd_of[group as usize] };
        (crowd != NO_CROWD).then_some(crowd as usize)
    }
}

/// Sorts the pairs of each crowd and removes duplicates.
///
/// `ends[i]` is the end of crowd i's pairs in `groups.pairs`, before duplicates are removed.
fn sort_pairs(groups: &mut Groups, ends: &[u32]) {
    let mut start = 0;
    let mut kept = 0;
    for &end in ends {
        groups.pairs[start..end as usize].sort_unstable();
        let first = kept;
        for k in start..end as usize {
            let pair = groups.pairs[k];
            if kept == first || groups.pairs[kept - 1] != pair {
                groups.pairs[kept] = pair;
                kept += 1;
            }
        }
        groups.pair_ends.push(kept as u32);
        start = end as usize;
    }
    groups.pairs.truncate(kept);
}

/// Returns the start of each run. The first run starts at 0, and each other run starts where the
/// previous run ends.
fn running_starts(lengths: &[u32]) -> Vec<u32> {
    let mut start = 0;
    let mut starts = Vec::with_capacity(lengths.len());
    for length in lengths {
        starts.push(start);
        start += length;
    }
    starts
}
