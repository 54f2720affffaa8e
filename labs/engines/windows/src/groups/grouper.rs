//! Makes groups from pairs, in three steps.
//!
//! In this example particles 10 to 19 are in the pairs below, and particle 15 may reach a wall:
//!
//! ```text
//! pairs:    10─11    12─13─14    15─16    17─18─19─17
//!
//! number    10─11 touch no other particle: a couple, which is done.     particle  15  12  13  14  16  17  18  19
//!           All others get numbers; particle 15 gets the least.         number     0   1   2   3   4   5   6   7
//!
//! unite     Each number is in the group of the least number that it     number     0   1   2   3   4   5   6   7
//!           reaches by pairs. Groups count from 0 in this order.        group      0   1   1   1   0   2   2   2
//!
//! lay out   By id, group by group: groups of two, three and four        couples    10 11
//!           without a particle near a wall are computed side by side;   threes     12 13 14   17 18 19
//!           all other groups are crowds, stored with their pairs.       crowd      15 16, with the pair 0─1
//! ```

use neighbour_list::Bodies;
use neighbour_list::kernels::Pair;

use super::arrangement::Arrangement;
use super::numbering::Numbering;
use super::slots::Groups;
use super::task::Task;
use super::union::{NO_GROUP, Union};
use crate::rules::Rules;

/// The working memory of the three steps, and the pairs that are not grouped yet.
#[derive(Default)]
pub(crate) struct Grouper {
    numbering: Numbering,
    union: Union,
    arrangement: Arrangement,
    /// All pairs of groups with a particle in `elsewhere`. They are grouped later, across bands.
    pub(crate) deferred: Vec<Pair>,
}

impl Grouper {
    /// Groups the particles of a task and writes the groups to `groups`.
    pub(crate) fn group<R: Rules>(
        &mut self,
        bodies: &Bodies,
        task: &Task<'_>,
        groups: &mut Groups,
    ) {
        let Self { numbering, union, arrangement, deferred } = self;
        groups.clear();
        numbering.number(task, &mut groups.small[0]);
        union.unite::<R>(numbering);
        arrangement.lay_out(bodies, numbering, union, groups);
        deferred.clear();
        if numbering.elsewhere > 0 {
            let left = numbering.pairs.iter().filter(|pair| union.group(pair[0]) == NO_GROUP);
            deferred.extend(left.map(|pair| pair.map(|k| numbering.particles[k as usize])));
        }
    }
}
