//! Whether anybody met somebody whom the search had not expected.

use common::soft::CUTOFF;
use solution10::kernels::{Kernel, Pair, Signs, dispatch};
use solution10::{Cells, Workers};

use super::band::Band;
use super::counts::Tallies;
use super::missed::Around;
use super::window::Window;
use crate::groups::{Batch, LANES, all_pairs};
use crate::path::too_far_off;
use crate::search::Layout;

/// Looks for pairs that touched and that nobody computed: those of a band, or of a later batch.
/// Brings back the pairs, and how many were looked at.
struct Watch<'a> {
    around: Around<'a>,
    batch: &'a Batch,
    /// The band, if it is one.
    band: Option<&'a Band>,
    /// Whether everybody else was asked before this batch was computed.
    last: bool,
    /// How far the most bent of all is off.
    most: f64,
}

impl Kernel for Watch<'_> {
    type Output = (Vec<Pair>, u64);

    #[inline(always)]
    fn run(self, signs: impl Signs) -> Self::Output {
        let mut seen = Seen::default();
        if let Some(band) = self.band {
            for &pair in &band.found.watched {
                if self.around.window.may_have_touched(pair, self.around.layout) {
                    seen.near.clear();
                    seen.near.push(pair[1]);
                    self.compare(pair[0], &mut seen);
                }
            }
            band.special.iter().for_each(|&i| self.ask_as_special(signs, i, &mut seen));
        }
        let groups = &self.batch.groups;
        let [triples, quads, crowds] = groups.begins();
        self.small(signs, &groups.couples, 0, &mut seen);
        self.small(signs, &groups.triples, triples, &mut seen);
        self.small(signs, &groups.quads, quads, &mut seen);
        for (place, &i) in groups.members.iter().enumerate() {
            self.ask(signs, i, crowds + place, &mut seen);
        }
        (seen.broken, seen.tests)
    }
}

/// What watching has seen.
#[derive(Default)]
struct Seen {
    broken: Vec<Pair>,
    tests: u64,
    /// Whoever may have touched the particle that asks.
    near: Vec<u32>,
}

impl Watch<'_> {
    /// Has the members of small groups ask, whose seats begin at `first`.
    #[inline(always)]
    fn small<const M: usize>(
        &self,
        signs: impl Signs,
        groups: &[[u32; M]],
        first: usize,
        seen: &mut Seen,
    ) {
        for (k, group) in groups.iter().enumerate() {
            let seat = first + k / LANES * LANES * M + k % LANES;
            for (m, &i) in group.iter().enumerate() {
                self.ask(signs, i, seat + m * LANES, seen);
            }
        }
    }

    /// Has particle `i` in `seat` look around, if it is off by more than was watched.
    #[inline(always)]
    fn ask(&self, signs: impl Signs, i: u32, seat: usize, seen: &mut Seen) {
        let Around { window, layout, .. } = self.around;
        let bent = self.batch.record.bent[seat];
        seen.near.clear();
        if self.last {
            // Who is bent more was asked before.
            let other = self.most.max(bent);
            if too_far_off(other, layout.margin) {
                self.around.everybody(signs, i, bent, other, &mut seen.near);
                self.compare(i, seen);
            }
        } else if too_far_off(bent, layout.margin) {
            let (vx, vy) = (window.bodies.vx[i as usize], window.bodies.vy[i as usize]);
            let half = (vx * vx + vy * vy).sqrt() * layout.halfway();
            let watched = layout.margin + layout.watched(half);
            if bent > CUTOFF {
                self.around.everybody(signs, i, bent, bent, &mut seen.near);
                self.compare(i, seen);
            } else if too_far_off(bent, watched) {
                self.around.plain(signs, i, bent, bent, &mut seen.near);
                self.compare(i, seen);
            }
        }
    }

    /// Has a special particle look around. Who is off by more than a cutoff asks for itself.
    fn ask_as_special(&self, signs: impl Signs, i: u32, seen: &mut Seen) {
        let bent = f64::from(self.around.window.bent[i as usize]);
        let other = self.most.min(CUTOFF).max(bent);
        if too_far_off(other, self.around.layout.margin) {
            seen.near.clear();
            self.around.everybody(signs, i, bent, other, &mut seen.near);
            self.compare(i, seen);
        }
    }

    /// Keeps those near `i` that touched it and that its group does not compute.
    fn compare(&self, i: u32, seen: &mut Seen) {
        let Around { window, layout, .. } = self.around;
        seen.tests += seen.near.len() as u64;
        let seat = window.seat(i).map(|(batch, p)| (batch, batch.groups.seat(p)));
        for &k in &seen.near {
            let computed = k == i
                || seat.as_ref().is_some_and(|(batch, seat)| batch.groups.compute(seat, i, k));
            if !computed && window.touched([i, k], layout) {
                seen.broken.push([i.min(k), i.max(k)]);
            }
        }
    }
}

impl Window {
    /// Pairs that nobody computed and that touched after all, because a push bent a path.
    ///
    /// A pair that is computed nowhere was further apart than cutoff + margin on its reference
    /// paths. If the search saw that it was not much further, it is watched; else it can have touched
    /// only if one of the two was off by much, and that one looks at everybody near it. Where that
    /// may have been near enough we compare where both really were, step by step. If all others were
    /// asked already, only those in the `last` batch are, and they ask for both.
    pub(crate) fn verify(
        &self,
        layout: &Layout,
        cells: &Cells,
        last: bool,
        workers: &Workers,
        tallies: &mut Tallies,
    ) -> Vec<Pair> {
        if layout.span.steps == 1 {
            return Vec::new();
        }
        let most = self.most_bent();
        let around = Around { window: self, layout, cells };
        let bands = if last { &[][..] } else { &self.bands[..] };
        let work = bands.iter().map(|band| (&band.batch, Some(band)));
        let work = work.chain(self.late.last().map(|batch| (batch, None))).collect();
        let results =
            workers.map(work, |(batch, band)| dispatch(Watch { around, batch, band, last, most }));
        let mut broken = Vec::new();
        for (pairs, tests) in results {
            broken.extend(pairs);
            tallies.tests += tests;
        }
        broken.sort_unstable();
        broken.dedup();
        broken
    }

    /// The pairs of all groups that `broken` pairs join, and these.
    pub(crate) fn with_their_groups(&self, broken: Vec<Pair>) -> Vec<Pair> {
        let mut people: Vec<u32> = broken.iter().flatten().copied().collect();
        people.sort_unstable();
        people.dedup();
        let mut pairs = broken;
        let mut known = std::collections::HashSet::new();
        for i in people {
            let Some((batch, p)) = self.seat(i) else { continue };
            let seat = batch.groups.seat(p);
            // A particle is in one group only: its first member names it.
            if !known.insert(seat.members[0]) {
                continue;
            }
            let all = all_pairs(seat.members.len());
            let own = seat.crowd.map_or(&all[..], |g| batch.groups.pairs_of(g));
            pairs.extend(own.iter().map(|pair| pair.map(|k| seat.members[k as usize])));
        }
        pairs
    }
}
