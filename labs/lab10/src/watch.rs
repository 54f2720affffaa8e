//! Whether anybody met somebody whom the search had not expected.

use common::soft::CUTOFF;

use crate::Cells;
use crate::band::{Band, FREE};
use crate::batch::{Batch, all_pairs};
use crate::search::{Layout, Pair};
use crate::window::{LATE, Tallies, Window};
use crate::workers::Workers;

/// Whether a particle `bent` off its reference path may have come near somebody whom the search
/// did not list for it. The search listed all pairs within cutoff + `margin`; the other particle
/// of an unlisted pair may be off its own path, too, and asks for itself if it is off by more.
///
/// Book: chapter 10, *A margin that is checked*.
pub fn too_far_off(bent: f64, margin: f64) -> bool {
    todo!("task 10.8: whether the margin held")
}

impl Window {
    /// Pairs that nobody computed and that touched after all, because a push bent a path.
    ///
    /// A pair that is computed nowhere was further apart than cutoff + tight on its reference
    /// paths. If it was within cutoff + margin it was watched: where both together were off by
    /// more than tight, we compare where they really were, step by step. A pair further apart can
    /// have touched only if one of the two was off by more than half the margin; then we look at
    /// everybody near it. If the others were listed already, only those in the `last` batch are
    /// asked.
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
        let newest = self.late.last().filter(|_| last).map_or(0, |batch| LATE | batch.first as u32);
        let is_new = |slot: u32| slot != FREE && slot >= newest;
        let work: Vec<&Band> = self.bands.iter().collect();
        let results = workers.map(work, |band| {
            let (mut broken, mut tests) = (Vec::new(), 0);
            for pair in &band.found.watched {
                let [a, b] = pair.map(|i| self.slot[i as usize]);
                if is_new(a) || is_new(b) {
                    let bent: f64 = pair.iter().map(|&i| self.bent(band, i)).sum();
                    if bent > layout.tight && self.touched(*pair, layout) {
                        broken.push(*pair);
                    }
                }
            }
            if !last {
                self.look_around(&band.batch, layout, cells, &mut broken, &mut tests);
            }
            (broken, tests)
        });
        let mut broken = Vec::new();
        for (pairs, tests) in results {
            broken.extend(pairs);
            tallies.tests += tests;
        }
        if let Some(batch) = self.late.last() {
            self.look_around(batch, layout, cells, &mut broken, &mut tallies.tests);
        }
        broken.sort_unstable();
        broken.dedup();
        broken
    }

    /// Looks at everybody near those of a batch that are too far off.
    fn look_around(
        &self,
        batch: &Batch,
        layout: &Layout,
        cells: &Cells,
        broken: &mut Vec<Pair>,
        tests: &mut u64,
    ) {
        let far = |bent: &f64| too_far_off(*bent, layout.margin);
        if !batch.record.bent.iter().any(far) {
            return;
        }
        batch.groups.for_each_member(|seat, i| {
            let bent = batch.record.bent[seat];
            if too_far_off(bent, layout.margin) {
                let visit = |k: u32| {
                    *tests += 1;
                    let pair = [i.min(k), i.max(k)];
                    if i != k && self.touched(pair, layout) {
                        broken.push(pair);
                    }
                };
                let bodies = &self.bodies;
                self.specials.everybody_near(bodies, cells, layout, i, 2.0 * bent, visit);
            }
        });
    }

    /// How far a particle was off its path; quick for those of `band`.
    #[inline]
    fn bent(&self, band: &Band, i: u32) -> f64 {
        let slot = self.slot[i as usize];
        if slot == FREE {
            return 0.0;
        }
        if slot & LATE == 0 && band.particles.contains(&(i as usize)) {
            return band.batch.record.bent[slot as usize];
        }
        self.seat(i).map_or(0.0, |(batch, p)| batch.record.bent[p])
    }

    /// Whether a pair that is computed nowhere was in contact at any step.
    fn touched(&self, pair: Pair, layout: &Layout) -> bool {
        let span = &layout.span;
        let seats = pair.map(|i| self.seat(i));
        let bent: f64 = seats.iter().flatten().map(|(batch, p)| batch.record.bent[*p]).sum();
        if bent <= layout.tight {
            return false;
        }
        let paths = pair.map(|i| span.path(&self.bodies.get(i as usize)));
        if !paths[0].may_touch(&paths[1], span.forces(), bent + span.rounding()) {
            return false;
        }
        let blocks = seats.map(|seat| {
            seat.map(|(batch, p)| {
                let block = batch.groups.block(p);
                let member = p - block.start;
                (batch, block, member)
            })
        });
        for step in 1..span.steps {
            let time = f64::from(step) * span.dt;
            let mut off = [(0.0, 0.0); 2];
            for (off, block) in off.iter_mut().zip(&blocks) {
                if let Some((batch, block, member)) = block {
                    *off = batch.record.off(block, *member, step as usize);
                }
            }
            let [(ax, ay), (bx, by)] = off;
            let dx = paths[1].x + paths[1].wx * time + bx - paths[0].x - paths[0].wx * time - ax;
            let dy = paths[1].y + paths[1].wy * time + by - paths[0].y - paths[0].wy * time - ay;
            // The distances off are rounded to single precision.
            let lost = 2.4e-7 * (ax.abs() + ay.abs() + bx.abs() + by.abs());
            let near = CUTOFF + lost + span.rounding();
            if dx * dx + dy * dy <= near * near {
                return !self.is_computed(pair);
            }
        }
        false
    }

    fn is_computed(&self, pair: Pair) -> bool {
        let [Some((batch, a)), Some((other, _))] = pair.map(|i| self.seat(i)) else {
            return false;
        };
        if !std::ptr::eq(batch, other) {
            return false;
        }
        let seat = batch.groups.seat(a);
        let places = pair.map(|i| seat.members.iter().position(|&member| member == i));
        let [Some(a), Some(b)] = places else { return false };
        let wanted = [a.min(b) as u32, a.max(b) as u32];
        seat.crowd.is_none_or(|g| batch.groups.pairs_of(g).binary_search(&wanted).is_ok())
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
