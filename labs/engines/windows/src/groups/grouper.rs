//! From pairs to groups.

use std::ops::Range;

use neighbour_list::Bodies;
use neighbour_list::kernels::Pair;

use super::slots::{Groups, SMALL};
use crate::rules::Rules;

/// No number yet, or no group.
const NONE: u32 = u32::MAX;

/// What grouping needs for itself.
#[derive(Default)]
pub(crate) struct Grouper {
    degree: Vec<u8>,
    /// For a particle that is not simply in a couple: its number among `found`.
    number: Vec<u32>,
    crowded: Vec<Pair>,
    found: Vec<u32>,
    parent: Vec<u32>,
    group: Vec<u32>,
    local: Vec<u32>,
    /// All pairs of groups that a particle in `elsewhere` belongs to, to be grouped across bands.
    pub(crate) deferred: Vec<Pair>,
}

/// What is to be grouped.
pub(crate) struct Task<'a> {
    /// All particles are from here, as indices in the sorted order.
    pub(crate) range: Range<usize>,
    pub(crate) pairs: &'a [Pair],
    /// In a crowd even if they are in no pair or in one.
    pub(crate) alone: &'a [u32],
    /// In pairs that are grouped elsewhere.
    pub(crate) elsewhere: &'a [u32],
}

impl Grouper {
    /// Groups the particles of a task.
    pub(crate) fn group<R: Rules>(
        &mut self,
        bodies: &Bodies,
        task: &Task<'_>,
        groups: &mut Groups,
    ) {
        let first = task.range.start;
        let at = |i: u32| i as usize - first;
        groups.clear();
        self.degree.resize(task.range.len().max(self.degree.len()), 0);
        self.number.resize(task.range.len().max(self.number.len()), NONE);
        self.crowded.clear();
        self.found.clear();
        self.deferred.clear();
        for &i in task.pairs.iter().flatten() {
            let degree = &mut self.degree[at(i)];
            *degree = degree.saturating_add(1);
        }
        // Numbered first, so that the least number of a group tells whether it is deferred.
        for &i in task.elsewhere {
            self.degree[at(i)] = u8::MAX;
            self.count(i, first);
        }
        let deferred = self.found.len() as u32;
        for &i in task.alone {
            self.degree[at(i)] = u8::MAX;
            self.count(i, first);
        }
        let crowds = self.found.len() as u32;
        for &pair in task.pairs {
            if (self.degree[at(pair[0])] | self.degree[at(pair[1])]) == 1 {
                groups.small[0].extend(pair);
            } else {
                self.crowded.push(pair);
            }
        }
        for k in 0..self.crowded.len() {
            let [i, j] = self.crowded[k];
            self.count(i, first);
            self.count(j, first);
        }
        self.unite::<R>(first);
        self.defer::<R>(first, deferred);
        self.lay_out::<R>(bodies, first, deferred, crowds, groups);
        for &i in task.pairs.iter().flatten().chain(task.elsewhere).chain(task.alone) {
            self.degree[at(i)] = 0;
            self.number[at(i)] = NONE;
        }
    }

    /// Gives a particle a number if it has none.
    fn count(&mut self, i: u32, first: usize) {
        let number = &mut self.number[i as usize - first];
        if *number == NONE {
            *number = self.found.len() as u32;
            self.found.push(i);
        }
    }

    /// Groups of the crowded pairs.
    fn unite<R: Rules>(&mut self, first: usize) {
        self.parent.clear();
        self.parent.extend(0..self.found.len() as u32);
        for pair in &self.crowded {
            let [a, b] = pair.map(|i| self.number[i as usize - first]);
            R::join(&mut self.parent, a, b);
        }
    }

    /// Takes out the pairs of groups whose least number is below `deferred`.
    fn defer<R: Rules>(&mut self, first: usize, deferred: u32) {
        if deferred == 0 {
            return;
        }
        let Self { parent, number, crowded, deferred: out, .. } = self;
        crowded.retain(|pair| {
            let here = R::root(parent, number[pair[0] as usize - first]) >= deferred;
            if !here {
                out.push(*pair);
            }
            here
        });
    }

    /// Orders the members and pairs of all groups from number `deferred` on. Groups below number
    /// `crowds` are crowds whatever their size.
    fn lay_out<R: Rules>(
        &mut self,
        bodies: &Bodies,
        first: usize,
        deferred: u32,
        crowds: u32,
        groups: &mut Groups,
    ) {
        // Groups are numbered by their first member found.
        let count = self.found.len();
        self.group.clear();
        let mut sizes: Vec<u32> = Vec::new();
        let mut plain = 0;
        for k in 0..count as u32 {
            let root = R::root(&mut self.parent, k);
            let group = if root < deferred {
                NONE
            } else if root == k {
                plain += usize::from(k < crowds);
                sizes.push(0);
                sizes.len() as u32 - 1
            } else {
                self.group[root as usize]
            };
            self.group.push(group);
            if group != NONE {
                sizes[group as usize] += 1;
            }
        }
        let mut next = running_starts(&sizes);
        let mut members = vec![0; sizes.iter().sum::<u32>() as usize];
        for (&group, &i) in self.group.iter().zip(&self.found) {
            if group != NONE {
                let end = &mut next[group as usize];
                members[*end as usize] = i;
                *end += 1;
            }
        }
        self.local.resize(count.max(self.local.len()), 0);
        // What becomes of each group: the number of a crowd, or none.
        let mut crowd_of = vec![NONE; sizes.len()];
        let mut start = 0;
        for (g, &end) in next.iter().enumerate() {
            let members = &mut members[start..end as usize];
            start = end as usize;
            members.sort_unstable_by_key(|&i| bodies.id[i as usize]);
            // A couple here is one whose pair was found twice.
            let size = SMALL[1..].iter().position(|size| *size == members.len());
            if let Some(k) = size.filter(|_| g >= plain) {
                groups.small[k + 1].extend_from_slice(members);
                continue;
            }
            for (local, &i) in members.iter().enumerate() {
                self.local[self.number[i as usize - first] as usize] = local as u32;
            }
            crowd_of[g] = groups.ends.len() as u32;
            groups.members.extend_from_slice(members);
            groups.crowd_of.resize(groups.members.len(), crowd_of[g]);
            groups.ends.push(groups.members.len() as u32);
        }
        self.pairs_of_crowds(first, &crowd_of, groups);
    }

    fn pairs_of_crowds(&mut self, first: usize, crowd_of: &[u32], groups: &mut Groups) {
        let crowd = |pair: &Pair| {
            let number = self.number[pair[0] as usize - first];
            crowd_of[self.group[number as usize] as usize]
        };
        let mut counts = vec![0; groups.ends.len()];
        let mut total = 0;
        for pair in &self.crowded {
            let crowd = crowd(pair);
            if crowd != NONE {
                counts[crowd as usize] += 1;
                total += 1;
            }
        }
        let mut next = running_starts(&counts);
        groups.pairs.resize(total, [0; 2]);
        for pair in &self.crowded {
            let crowd = crowd(pair);
            if crowd != NONE {
                let [a, b] = pair.map(|i| self.local[self.number[i as usize - first] as usize]);
                let end = &mut next[crowd as usize];
                groups.pairs[*end as usize] = [a.min(b), a.max(b)];
                *end += 1;
            }
        }
        sort_pairs(groups, &next);
    }
}

/// Sorts the pairs of each group and drops duplicates.
fn sort_pairs(groups: &mut Groups, ends: &[u32]) {
    let (mut start, mut kept) = (0, 0);
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

/// Where each of several runs of the given lengths starts.
fn running_starts(lengths: &[u32]) -> Vec<u32> {
    lengths
        .iter()
        .scan(0, |start, &length| {
            *start += length;
            Some(*start - length)
        })
        .collect()
}
