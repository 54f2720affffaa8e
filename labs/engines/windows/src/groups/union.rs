//! The second step of grouping: union-find over the numbers of particles.
//!
//! The drawing in [`grouper`](super::grouper) shows this step as "unite".

use super::numbering::Numbering;
use crate::rules::Rules;

/// Entry of `group` for a number that is grouped elsewhere.
pub(super) const NO_GROUP: u32 = u32::MAX;

/// The groups into which pairs unite numbers.
#[derive(Default)]
pub(super) struct Union {
    /// For each number, its parent: a number of the same group that is not greater. The least
    /// number of a group is its own parent.
    parent: Vec<u32>,
    /// For each number, its group, or [`NO_GROUP`].
    group: Vec<u32>,
    /// The number of members of each group. Groups are in the order of their least numbers.
    pub(super) sizes: Vec<u32>,
    /// The number of groups that are crowds whatever their size. These groups come first.
    pub(super) crowds: usize,
}

impl Union {
    /// Unites the numbers of all pairs.
    pub(super) fn unite<R: Rules>(&mut self, numbering: &Numbering) {
        let count = numbering.particles.len() as u32;
        self.parent.clear();
        self.parent.extend(0..count);
        for &[a, b] in &numbering.pairs {
            R::join(&mut self.parent, a, b);
        }
        self.group.clear();
        self.sizes.clear();
        self.crowds = 0;
        for number in 0..count {
            let root = R::root(&mut self.parent, number);
            let group = if root < numbering.elsewhere {
                NO_GROUP
            } else if root == number {
                self.crowds += usize::from(number < numbering.alone);
                self.sizes.push(0);
                self.sizes.len() as u32 - 1
            } else {
                self.group[root as usize]
            };
            self.group.push(group);
            if group != NO_GROUP {
                self.sizes[group as usize] += 1;
            }
        }
    }

    /// Returns the group of a number, or [`NO_GROUP`].
    pub(super) fn group(&self, number: u32) -> u32 {
        self.group[number as usize]
    }
}
