//! Whether anybody met somebody whom the search had not expected.

use common::soft::CUTOFF;
use pulp::{Arch, NullaryFnOnce};

use crate::Cells;
use crate::batch::{Batch, all_pairs};
use crate::search::{Layout, Pair};
use crate::together::LANES;
use crate::window::{Tallies, Window};
use crate::workers::Workers;

/// Whether a particle `bent` off its reference path may have come near somebody whom the search
/// did not list for it. The search listed all pairs within cutoff + `margin`; the other particle
/// of an unlisted pair may be off its own path, too, and asks for itself if it is off by more.
///
/// Book: chapter 10, *A margin that is checked*.
#[inline(always)]
pub fn too_far_off(bent: f64, margin: f64) -> bool {
    todo!("task 10.8: whether the margin held")
}

/// Looks at everybody near those of a batch that are too far off. Brings back the pairs that
/// touched, and how many were looked at.
struct LookAround<'a> {
    window: &'a Window,
    batch: &'a Batch,
    layout: &'a Layout,
    cells: &'a Cells,
    /// Whether everybody else was asked before this batch was computed.
    last: bool,
    /// How far the most bent of all is off.
    most: f64,
}

impl NullaryFnOnce for LookAround<'_> {
    type Output = (Vec<Pair>, u64);

    #[inline(always)]
    fn call(self) -> Self::Output {
        let (groups, mut seen) = (&self.batch.groups, Seen::default());
        let [triples, quads, crowds] = groups.begins();
        self.small(&groups.couples, 0, &mut seen);
        self.small(&groups.triples, triples, &mut seen);
        self.small(&groups.quads, quads, &mut seen);
        for g in 0..groups.ends.len() {
            let crowd = groups.crowd(g);
            let members = &groups.members[crowd.clone()];
            for (&i, place) in members.iter().zip(crowd) {
                self.ask(i, crowds + place, &mut seen);
                seen.others(i, members, Some(groups.pairs_of(g)), &self);
            }
        }
        (seen.broken, seen.tests)
    }
}

/// What looking around has seen.
#[derive(Default)]
struct Seen {
    broken: Vec<Pair>,
    tests: u64,
    /// Whoever may have touched the particle that asks.
    near: Vec<u32>,
}

impl LookAround<'_> {
    /// Has the members of small groups ask, whose seats begin at `first`.
    #[inline(always)]
    fn small<const M: usize>(&self, groups: &[[u32; M]], first: usize, seen: &mut Seen) {
        for (k, group) in groups.iter().enumerate() {
            let seat = first + k / LANES * LANES * M + k % LANES;
            for (m, &i) in group.iter().enumerate() {
                self.ask(i, seat + m * LANES, seen);
                seen.others(i, group, None, self);
            }
        }
    }

    /// Writes down who may have touched particle `i` in `seat`.
    #[inline(always)]
    fn ask(&self, i: u32, seat: usize, seen: &mut Seen) {
        seen.near.clear();
        let bent = self.batch.record.bent[seat];
        // Who is bent more asks for itself, unless it was asked before.
        let other = if self.last { self.most.max(bent) } else { bent };
        if too_far_off(other, self.layout.margin) {
            let Window { bodies, specials, bent: all, .. } = self.window;
            let (cells, layout, list) = (self.cells, self.layout, &mut seen.near);
            specials.everybody_near(bodies, cells, layout, i, (bent, other), all, list);
            seen.tests += seen.near.len() as u64;
        }
    }
}

impl Seen {
    /// Keeps those near `i` that touched it and that its group does not compute: of `pairs` of its
    /// members, or of all.
    #[inline(always)]
    fn others(&mut self, i: u32, group: &[u32], pairs: Option<&[Pair]>, asked: &LookAround<'_>) {
        for &k in &self.near {
            let computed = k == i
                || group.contains(&k) && pairs.is_none_or(|pairs| is_listed(pairs, group, i, k));
            if !computed && asked.window.touched([i, k], asked.layout) {
                self.broken.push([i.min(k), i.max(k)]);
            }
        }
    }
}

/// Whether the pair of two members is among the sorted pairs of their group.
fn is_listed(pairs: &[Pair], group: &[u32], i: u32, k: u32) -> bool {
    let place = |who| group.iter().position(|&member| member == who).unwrap_or(0) as u32;
    let (a, b) = (place(i), place(k));
    pairs.binary_search(&[a.min(b), a.max(b)]).is_ok()
}

impl Window {
    /// Pairs that nobody computed and that touched after all, because a push bent a path.
    ///
    /// A pair that is computed nowhere was further apart than cutoff + margin on its reference
    /// paths. It can have touched only if one of the two was off by more than half the margin;
    /// then we look at everybody near it, and where that may have been near enough we compare
    /// where both really were, step by step. If the others were asked already, only those in the
    /// `last` batch are, and they ask for both.
    pub(crate) fn verify(
        &mut self,
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
        self.specials.mark(layout, self.bodies.len());
        let bands = if last { &[][..] } else { &self.bands[..] };
        let batches = bands.iter().map(|band| &band.batch).chain(self.late.last()).collect();
        let (arch, window) = (Arch::new(), &*self);
        let results = workers.map(batches, |batch: &Batch| {
            arch.dispatch(LookAround { window, batch, layout, cells, last, most })
        });
        let mut broken = Vec::new();
        for (pairs, tests) in results {
            broken.extend(pairs);
            tallies.tests += tests;
        }
        broken.sort_unstable();
        broken.dedup();
        broken
    }

    /// Whether a pair that is computed nowhere was in contact at any step.
    fn touched(&self, pair: Pair, layout: &Layout) -> bool {
        let span = &layout.span;
        let seats = pair.map(|i| self.seat(i));
        let paths = pair.map(|i| span.path(&self.bodies.get(i as usize)));
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
                return true;
            }
        }
        false
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
