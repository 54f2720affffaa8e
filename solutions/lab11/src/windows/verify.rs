//! Whether particles met that the search had not expected to meet.

use common::soft::CUTOFF;
use solution10::kernels::{Kernel, Pair, Signs, dispatch};
use solution10::{Cells, Workers};

use super::WindowCounts;
use super::band::Band;
use super::missed::Around;
use super::window::Window;
use crate::flight::too_far_off;
use crate::groups::{Batch, LANES, all_pairs};
use crate::search::Layout;

/// Looks for pairs that touched and that no group computed, in a band or in a later batch.
/// Brings back the pairs, and how many were looked at.
struct Watch<'a> {
    around: Around<'a>,
    batch: &'a Batch,
    /// The band, if it is one.
    band: Option<&'a Band>,
    /// Whether all other particles were checked before this batch was computed.
    last: bool,
    /// The greatest deviation of all.
    most: f64,
}

impl Kernel for Watch<'_> {
    type Output = (Vec<Pair>, u64);

    #[inline(always)]
    fn run(self, signs: impl Signs) -> Self::Output {
        let mut seen = Seen::default();
        if let Some(band) = self.band {
            band.special.iter().for_each(|&i| self.check_special(signs, i, &mut seen));
        }
        let groups = &self.batch.groups;
        let [triples, quads, crowds] = groups.begins();
        self.small(signs, &groups.couples, 0, &mut seen);
        self.small(signs, &groups.triples, triples, &mut seen);
        self.small(signs, &groups.quads, quads, &mut seen);
        for (place, &i) in groups.members.iter().enumerate() {
            self.check(signs, i, crowds + place, &mut seen);
        }
        (seen.broken, seen.tests)
    }
}

/// What watching has seen.
#[derive(Default)]
struct Seen {
    broken: Vec<Pair>,
    tests: u64,
    /// The particles that may have touched the one that is checked.
    near: Vec<u32>,
}

impl Watch<'_> {
    /// Checks the members of small groups, whose slots begin at `first`.
    #[inline(always)]
    fn small<const M: usize>(
        &self,
        signs: impl Signs,
        groups: &[[u32; M]],
        first: usize,
        seen: &mut Seen,
    ) {
        for (k, group) in groups.iter().enumerate() {
            let slot = first + k / LANES * LANES * M + k % LANES;
            for (m, &i) in group.iter().enumerate() {
                self.check(signs, i, slot + m * LANES, seen);
            }
        }
    }

    /// Checks what is around particle `i` in `slot`, if it is off by more than the margin allows.
    #[inline(always)]
    fn check(&self, signs: impl Signs, i: u32, slot: usize, seen: &mut Seen) {
        let Around { layout, .. } = self.around;
        let deviation = self.batch.record.deviation[slot];
        seen.near.clear();
        if self.last {
            // A particle that is off by more was checked before.
            let other = self.most.max(deviation);
            if too_far_off(other, layout.margin) {
                self.around.all_near(signs, i, deviation, other, &mut seen.near);
                self.compare(i, seen);
            }
        } else if too_far_off(deviation, layout.margin) {
            if deviation > CUTOFF {
                self.around.all_near(signs, i, deviation, deviation, &mut seen.near);
            } else {
                self.around.plain(signs, i, deviation, deviation, &mut seen.near);
            }
            self.compare(i, seen);
        }
    }

    /// Checks what is around a special particle. Particles off by more than a cutoff are checked
    /// themselves.
    fn check_special(&self, signs: impl Signs, i: u32, seen: &mut Seen) {
        let deviation = f64::from(self.around.window.deviation[i as usize]);
        let other = self.most.min(CUTOFF).max(deviation);
        if too_far_off(other, self.around.layout.margin) {
            seen.near.clear();
            self.around.all_near(signs, i, deviation, other, &mut seen.near);
            self.compare(i, seen);
        }
    }

    /// Keeps the particles near `i` that touched it and that its group does not compute.
    fn compare(&self, i: u32, seen: &mut Seen) {
        let Around { window, layout, .. } = self.around;
        seen.tests += seen.near.len() as u64;
        let group = window.slot(i).map(|(batch, p)| (batch, batch.groups.group(p)));
        for &k in &seen.near {
            let computed = k == i
                || group.as_ref().is_some_and(|(batch, group)| batch.groups.computes(group, i, k));
            if !computed && window.touched([i, k], layout) {
                seen.broken.push([i.min(k), i.max(k)]);
            }
        }
    }
}

impl Window {
    /// Pairs that no group computed and that touched after all, because a push bent a path.
    ///
    /// A pair that is computed nowhere was further apart than cutoff + margin on its reference
    /// paths, so it can have touched only if one of the two was off by half the margin or more, and
    /// then all particles near that one are looked at.
    /// Where that may have been near enough we compare where both really were, step by step. If all
    /// other particles were checked already, only the members of the `last` batch are, each for
    /// both of its pair.
    pub(crate) fn verify(
        &self,
        layout: &Layout,
        cells: &Cells,
        last: bool,
        workers: &Workers,
        counts: &mut WindowCounts,
    ) -> Vec<Pair> {
        if layout.span.steps == 1 {
            return Vec::new();
        }
        let most = self.greatest_deviation();
        let around = Around { window: self, layout, cells };
        let bands = if last { &[][..] } else { &self.bands[..] };
        let work = bands.iter().map(|band| (&band.batch, Some(band)));
        let work = work.chain(self.late.last().map(|batch| (batch, None))).collect();
        let results =
            workers.map(work, |(batch, band)| dispatch(Watch { around, batch, band, last, most }));
        let mut broken = Vec::new();
        for (pairs, tests) in results {
            broken.extend(pairs);
            counts.tests += tests;
        }
        broken.sort_unstable();
        broken.dedup();
        broken
    }

    /// The same for a window from a list, whose pairs nearby were watched. None if a particle was pushed so far
    /// that a pair may have touched that was not watched.
    pub(crate) fn verify_listed(
        &self,
        layout: &Layout,
        workers: &Workers,
        counts: &mut WindowCounts,
    ) -> Option<Vec<Pair>> {
        let most = self.greatest_deviation();
        if !too_far_off(most, layout.margin) {
            return Some(Vec::new());
        }
        if too_far_off(most, layout.margin + layout.aside) {
            return None;
        }
        let broken = workers.map(self.bands.iter().collect(), |band: &Band| {
            let near =
                band.found.watched.iter().filter(|&&pair| self.may_have_touched(pair, layout));
            let near: Vec<Pair> = near.copied().filter(|&pair| !self.computes(pair)).collect();
            let tested = near.len() as u64;
            let touched = near.into_iter().filter(|&pair| self.touched(pair, layout));
            (touched.collect::<Vec<Pair>>(), tested)
        });
        counts.tests += broken.iter().map(|(_, tested)| tested).sum::<u64>();
        Some(broken.into_iter().flat_map(|(pairs, _)| pairs).collect())
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
            let all = all_pairs(group.members.len());
            let own = group.crowd.map_or(&all[..], |g| batch.groups.pairs_of(g));
            pairs.extend(own.iter().map(|pair| pair.map(|k| group.members[k as usize])));
        }
        pairs
    }
}
