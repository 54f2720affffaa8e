//! Finds the pairs that met although the search did not expect them to meet.

use neighbour_list::Workers;
use neighbour_list::kernels::Pair;

use super::WindowCounts;
use super::band::Band;
use super::opening::Window;
use crate::groups::Batch;
use crate::rules::Rules;
use crate::search::{Layout, Search};

impl Window {
    /// Returns the pairs that touched although no group computed them, because a force had bent a
    /// path.
    ///
    /// The reference paths of such a pair were further apart than cutoff + margin. So the pair can
    /// have touched only if one of its particles deviated from its path by at least half the
    /// margin. All particles near that particle are tested. If the particles could have come close
    /// enough, their actual positions are compared, step by step.
    ///
    /// With `last`, only the members of the last batch have changed since the pairs were verified.
    /// So only these members are tested, and the other particle of a pair may deviate more from its
    /// path than the member.
    pub(crate) fn verify<R: Rules>(
        &self,
        search: &Search<'_>,
        last: bool,
        workers: &Workers,
        counts: &mut WindowCounts,
    ) -> Vec<Pair> {
        if search.layout.span.steps == 1 {
            return Vec::new();
        }
        let other = if last { self.greatest_deviation() } else { 0.0 };
        let bands = if last { &[][..] } else { &self.bands[..] };
        let batches = bands.iter().map(|band| &band.batch).chain(self.late.last()).collect();
        let results = workers.map(batches, |batch| self.broken::<R>(batch, other, search));
        let mut broken = self.broken_watched::<R>(search.layout, workers);
        for (pairs, tests) in results {
            broken.extend(pairs);
            counts.tests += tests;
        }
        broken.sort_unstable();
        broken.dedup();
        broken
    }

    /// Returns the watched pairs that touched.
    fn broken_watched<R: Rules>(&self, layout: &Layout, workers: &Workers) -> Vec<Pair> {
        let is_broken = |pair: &Pair| {
            let [a, b] = pair.map(|i| self.deviation[i as usize]);
            R::too_far_off(0.5 * (a + b), layout.margin)
                && !self.computes(*pair)
                && self.touched::<R>(*pair, &layout.span)
        };
        let broken = workers.map(self.bands.iter().collect(), |band: &Band| {
            band.found.watched.iter().copied().filter(is_broken).collect::<Vec<Pair>>()
        });
        broken.concat()
    }

    /// Returns the pairs of members of `batch` that touched, and the number of pairs that were
    /// tested.
    ///
    /// The deviation of the pair's other particle is at most the greater of `other` and the
    /// member's deviation.
    fn broken<R: Rules>(&self, batch: &Batch, other: f64, search: &Search<'_>) -> (Vec<Pair>, u64) {
        let Search { layout, .. } = search;
        let mut broken = Vec::new();
        let mut tests = 0;
        batch.groups.for_each_member(|_, i| {
            let own = self.deviation[i as usize];
            let other = own.max(other);
            if R::too_far_off(other, layout.slack()) {
                let both = |k| own + self.deviation[k];
                tests += search.around::<R>(i, own + other, both, |k| {
                    let pair = [i.min(k), i.max(k)];
                    if !self.computes(pair) && self.touched::<R>(pair, &layout.span) {
                        broken.push(pair);
                    }
                });
            }
        });
        (broken, tests)
    }

    /// Returns the `broken` pairs and the pairs of all groups that they unite.
    pub(crate) fn with_their_groups(&self, broken: Vec<Pair>) -> Vec<Pair> {
        let mut particles: Vec<u32> = broken.iter().flatten().copied().collect();
        particles.sort_unstable();
        particles.dedup();
        let mut pairs = broken;
        let mut known = std::collections::HashSet::new();
        for i in particles {
            let Some((batch, p)) = self.slot(i) else { continue };
            let group = batch.groups.group(p);
            // A particle is in one group only, so a group's first member identifies the group.
            if !known.insert(group.members[0]) {
                continue;
            }
            pairs.extend(group.pairs.iter().map(|pair| pair.map(|k| group.members[k as usize])));
        }
        pairs
    }
}
