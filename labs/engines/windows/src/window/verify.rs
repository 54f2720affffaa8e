//! Whether particles met that the search had not expected to meet.

use neighbour_list::Workers;
use neighbour_list::kernels::Pair;

use super::WindowCounts;
use super::band::Band;
use super::opening::Window;
use crate::groups::Batch;
use crate::rules::Rules;
use crate::search::{Layout, Search};

impl Window {
    /// Pairs that no group computed and that touched after all, because a force bent a path.
    ///
    /// A pair that is computed nowhere was further apart than cutoff + margin on its reference
    /// paths, so it can have touched only if one of the two was off by half the margin or more, and
    /// then all particles near that one are looked at.
    /// Where that may have been near enough we compare where both really were, step by step. If all
    /// other particles were checked already, only the members of the `last` batch are, each for
    /// both of its pair.
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

    /// The watched pairs that touched.
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

    /// The pairs of members of `batch` with particles that are off their paths by no more than the
    /// member, or by no more than `other`. Returns how many were looked at, too.
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

    /// The pairs of all groups that `broken` pairs join, and these.
    pub(crate) fn with_their_groups(&self, broken: Vec<Pair>) -> Vec<Pair> {
        let mut particles: Vec<u32> = broken.iter().flatten().copied().collect();
        particles.sort_unstable();
        particles.dedup();
        let mut pairs = broken;
        let mut known = std::collections::HashSet::new();
        for i in particles {
            let Some((batch, p)) = self.slot(i) else { continue };
            let group = batch.groups.group(p);
            // A particle is in one group only: its first member names it.
            if !known.insert(group.members[0]) {
                continue;
            }
            pairs.extend(group.pairs.iter().map(|pair| pair.map(|k| group.members[k as usize])));
        }
        pairs
    }
}
