//! From pairs to groups that nobody else touches.

use crate::Bodies;
use crate::search::Pair;

/// Groups of particles that push each other in a window, and nobody else. Each can be computed on
/// its own from the window's start to its end, in any order, by anybody.
#[derive(Default)]
pub(crate) struct Groups {
    /// Groups of two, the most frequent by far.
    pub(crate) couples: Vec<Pair>,
    /// Members of all other groups, one group after another, by id within each: places in the
    /// sorted order.
    pub(crate) members: Vec<u32>,
    /// Where each of those groups ends in `members`.
    pub(crate) ends: Vec<u32>,
    /// Their pairs: numbers within the group, the lower id first, ascending.
    pub(crate) pairs: Vec<Pair>,
    /// Where the pairs of each group end in `pairs`.
    pub(crate) pair_ends: Vec<u32>,
    /// The group of each of `members`.
    pub(crate) group_of: Vec<u32>,
}

/// What grouping needs for itself.
#[derive(Default)]
pub(crate) struct Grouper {
    degree: Vec<u8>,
    /// For a particle in a group of more than two: its number among `found`.
    number: Vec<u32>,
    crowded: Vec<Pair>,
    found: Vec<u32>,
    parent: Vec<u32>,
    group: Vec<u32>,
    local: Vec<u32>,
}

const NOBODY: u32 = u32::MAX;

impl Groups {
    /// How many members all groups have.
    pub(crate) fn len(&self) -> usize {
        2 * self.couples.len() + self.members.len()
    }

    /// The members of group `g` of those with more than two.
    pub(crate) fn members_of(&self, g: usize) -> &[u32] {
        let start = g.checked_sub(1).map_or(0, |before| self.ends[before] as usize);
        &self.members[start..self.ends[g] as usize]
    }

    /// The pairs of group `g` of those with more than two.
    pub(crate) fn pairs_of(&self, g: usize) -> &[Pair] {
        let start = g.checked_sub(1).map_or(0, |before| self.pair_ends[before] as usize);
        &self.pairs[start..self.pair_ends[g] as usize]
    }

    /// The member at position `p` of all: couples first.
    pub(crate) fn member(&self, p: usize) -> u32 {
        match self.couples.get(p / 2) {
            Some(couple) => couple[p % 2],
            None => self.members[p - 2 * self.couples.len()],
        }
    }
}

impl Grouper {
    /// Groups the particles of `pairs`. Particles in `alone` are in a group that is no couple,
    /// even if they are in no pair or in one.
    pub(crate) fn group(&mut self, bodies: &Bodies, pairs: &[&[Pair]], alone: &[u32]) -> Groups {
        let n = bodies.len();
        let mut groups = Groups::default();
        self.degree.clear();
        self.degree.resize(n, 0);
        self.number.resize(n, NOBODY);
        self.crowded.clear();
        self.found.clear();
        for pair in pairs.iter().copied().flatten() {
            for &i in pair {
                let degree = &mut self.degree[i as usize];
                *degree = degree.saturating_add(1);
            }
        }
        for &i in alone {
            self.degree[i as usize] = u8::MAX;
            self.number[i as usize] = self.found.len() as u32;
            self.found.push(i);
        }
        for &pair in pairs.iter().copied().flatten() {
            let [i, j] = pair.map(|i| i as usize);
            if (self.degree[i] | self.degree[j]) == 1 {
                groups.couples.push(pair);
            } else {
                self.crowded.push(pair);
            }
        }
        for pair in &self.crowded {
            for &i in pair {
                let number = &mut self.number[i as usize];
                if *number == NOBODY {
                    *number = self.found.len() as u32;
                    self.found.push(i);
                }
            }
        }
        self.unite();
        self.lay_out(bodies, &mut groups);
        for &i in &self.found {
            self.number[i as usize] = NOBODY;
        }
        groups
    }

    /// Union-find over the crowded pairs; `parent` is always a lower number.
    fn unite(&mut self) {
        self.parent.clear();
        self.parent.extend(0..self.found.len() as u32);
        for pair in &self.crowded {
            let [a, b] = pair.map(|i| root(&mut self.parent, self.number[i as usize]));
            let (low, high) = (a.min(b), a.max(b));
            self.parent[high as usize] = low;
        }
    }

    fn lay_out(&mut self, bodies: &Bodies, groups: &mut Groups) {
        // Groups are numbered by their first member found.
        let count = self.found.len();
        self.group.clear();
        let mut sizes: Vec<u32> = Vec::new();
        for k in 0..count as u32 {
            let root = root(&mut self.parent, k);
            let group = if root == k {
                sizes.push(0);
                sizes.len() as u32 - 1
            } else {
                self.group[root as usize]
            };
            self.group.push(group);
            sizes[group as usize] += 1;
        }
        let mut next = running_starts(&sizes);
        groups.members.resize(count, 0);
        for (k, &i) in self.found.iter().enumerate() {
            let place = &mut next[self.group[k] as usize];
            groups.members[*place as usize] = i;
            *place += 1;
        }
        groups.ends = next;
        groups.group_of.resize(count, 0);
        self.local.resize(count.max(self.local.len()), 0);
        let mut start = 0;
        for (g, &end) in groups.ends.iter().enumerate() {
            let members = &mut groups.members[start..end as usize];
            members.sort_unstable_by_key(|&i| bodies.id[i as usize]);
            for (local, &i) in members.iter().enumerate() {
                self.local[self.number[i as usize] as usize] = local as u32;
            }
            groups.group_of[start..end as usize].fill(g as u32);
            start = end as usize;
        }

        let mut counts = vec![0; sizes.len()];
        for pair in &self.crowded {
            counts[self.group[self.number[pair[0] as usize] as usize] as usize] += 1;
        }
        let mut next = running_starts(&counts);
        groups.pairs.resize(self.crowded.len(), [0; 2]);
        for pair in &self.crowded {
            let numbers = pair.map(|i| self.number[i as usize] as usize);
            let [a, b] = numbers.map(|number| self.local[number]);
            let place = &mut next[self.group[numbers[0]] as usize];
            groups.pairs[*place as usize] = [a.min(b), a.max(b)];
            *place += 1;
        }
        self.sort_pairs(groups, &next);
    }

    /// Sorts the pairs of each group and drops those that were found twice.
    fn sort_pairs(&self, groups: &mut Groups, ends: &[u32]) {
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
}

fn root(parent: &mut [u32], mut k: u32) -> u32 {
    while parent[k as usize] != k {
        parent[k as usize] = parent[parent[k as usize] as usize];
        k = parent[k as usize];
    }
    k
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
