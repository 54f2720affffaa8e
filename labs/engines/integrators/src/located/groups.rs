//! Groups of particles that could touch each other within a step.

use common::Vec2;
use common::soft::CUTOFF;
use neighbour_list::{Disc, overlapping};

/// Pairs that could come within the cutoff, and the groups into which they unite particles.
pub(super) struct Groups {
    /// All particles, group by group, in ascending order within each group.
    members: Vec<u32>,
    /// For each group, the end of its members and the end of its pairs. The first entry, (0, 0), is
    /// the beginning of the first group.
    ends: Vec<(u32, u32)>,
    /// All pairs, group by group, as indices among the group's members.
    pairs: Vec<(u32, u32)>,
}

impl Groups {
    /// Returns the groups of particles at positions `at` for the next `dt`.
    ///
    /// The entry of a particle in `fastest` is an upper bound of its speed. So the particle moves
    /// away from `at` by at most this bound times `dt`, even if a wall reflects the particle.
    pub(super) fn new(at: &[Vec2], fastest: &[f64], dt: f64) -> Self {
        let n = at.len();
        let discs = at.iter().zip(fastest).zip(0..).map(|((at, fastest), index)| Disc {
            x: at.x,
            y: at.y,
            radius: reach(*fastest, dt),
            index,
        });
        let (mut found, _) = overlapping(discs.collect());
        // The least member of a group identifies the group.
        let name = least_members(n, &found);
        let mut members: Vec<u32> = (0..n as u32).collect();
        members.sort_by_key(|&i| (name[i as usize], i));
        found.sort_by_key(|&[a, b]| (name[a as usize], a, b));
        let mut local = vec![0; n];
        let mut ends = vec![(0, 0)];
        let mut pairs = Vec::with_capacity(found.len());
        let mut k = 0;
        for group in members.chunk_by(|&a, &b| name[a as usize] == name[b as usize]) {
            for (at, &i) in group.iter().enumerate() {
                local[i as usize] = at as u32;
            }
            while k < found.len() && name[found[k][0] as usize] == group[0] {
                pairs.push((local[found[k][0] as usize], local[found[k][1] as usize]));
                k += 1;
            }
            let (members, _) = ends[ends.len() - 1];
            ends.push((members + group.len() as u32, k as u32));
        }
        Self { members, ends, pairs }
    }

    /// Returns the number of groups. A particle that can touch no other particle is a group of one.
    pub(super) fn len(&self) -> usize {
        self.ends.len() - 1
    }

    /// Returns the members of a group, and its pairs as indices among the members.
    pub(super) fn group(&self, k: usize) -> (&[u32], &[(u32, u32)]) {
        let from = self.ends[k];
        let to = self.ends[k + 1];
        (&self.members[from.0 as usize..to.0 as usize], &self.pairs[from.1 as usize..to.1 as usize])
    }
}

fn reach(fastest: f64, dt: f64) -> f64 {
    // The reach is slightly larger, because sums are rounded.
    (0.5 * CUTOFF + fastest * dt) * (1.0 + 1e-9)
}

/// Returns the least member of each particle's group, computed with union-find.
///
/// No parent is greater than its child.
fn least_members(n: usize, pairs: &[[u32; 2]]) -> Vec<u32> {
    let mut parent: Vec<usize> = (0..n).collect();
    for &[a, b] in pairs {
        let a = root(&mut parent, a as usize);
        let b = root(&mut parent, b as usize);
        parent[a.max(b)] = a.min(b);
    }
    (0..n).map(|k| root(&mut parent, k) as u32).collect()
}

fn root(parent: &mut [usize], mut k: usize) -> usize {
    while parent[k] != k {
        parent[k] = parent[parent[k]];
        k = parent[k];
    }
    k
}
