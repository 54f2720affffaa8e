//! A window of several steps: the free fly, groups are computed on their own, margins are checked.

use common::soft::{CUTOFF, Observer, Particle, Silent};
use pulp::Arch;

use crate::flight::{After, LANES, Room, fly, run_couples, run_group};
use crate::groups::{Grouper, Groups};
use crate::path::Span;
use crate::search::{Found, Pair, meet, search};
use crate::{Bodies, Cells, Sorter, Workers};

/// Nobody runs the particle: it flies freely.
const FREE: u32 = u32::MAX;
/// Particles in a piece of work, roughly.
const PIECE: usize = 4096;
/// Couples, or crowds, in a piece of work.
const GROUPS: usize = 512;
/// Repairs of a window before it is redone with fewer steps.
pub(crate) const REPAIRS: usize = 12;

/// Groups computed together, and where their results begin in [`After`].
struct Batch {
    first: usize,
    groups: Groups,
}

/// How a window is laid out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Layout {
    pub(crate) span: Span,
    /// How much closer than seen two particles of a window may come, in length.
    pub(crate) margin: f64,
    /// Particles that go further than this in the window are looked after one by one.
    pub(crate) reach: f64,
}

/// What windows count.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Tallies {
    pub(crate) windows: u64,
    pub(crate) tests: u64,
    pub(crate) flown: u64,
    pub(crate) run: u64,
    pub(crate) verified: u64,
    pub(crate) repaired: u64,
    pub(crate) redone: u64,
    pub(crate) walls: u64,
}

/// The window that the engine is in.
#[derive(Default)]
pub(crate) struct Window {
    pub(crate) bodies: Bodies,
    spare: Bodies,
    sorter: Sorter,
    grouper: Grouper,
    slot: Vec<u32>,
    after: After,
    batches: Vec<Batch>,
    found: Vec<Found>,
}

impl Window {
    /// Before the first window.
    pub(crate) fn of(bodies: Bodies) -> Self {
        Self { bodies, ..Self::default() }
    }

    /// Sorts the particles and takes them through a window. False if margins kept breaking: then
    /// the particles are still where they were, and a shorter window should be tried.
    pub(crate) fn open(
        &mut self,
        layout: &Layout,
        grid: crate::Grid,
        dense: bool,
        workers: &Workers,
        tallies: &mut Tallies,
    ) -> bool {
        self.slot.clear();
        let cells = self.sorter.sort(&self.bodies, &mut self.spare, grid, dense, workers);
        std::mem::swap(&mut self.bodies, &mut self.spare);
        let (mut pairs, special, walls) = self.find(layout, &cells, workers, tallies);
        self.slot.resize(self.bodies.len(), FREE);
        self.after.resize(0);
        self.batches.clear();
        let alone: Vec<u32> = walls.clone();
        for repair in 0..=REPAIRS {
            let first = self.after.x.len();
            let slices: Vec<&[Pair]> = pairs.iter().map(Vec::as_slice).collect();
            let alone = if repair == 0 { &alone[..] } else { &self.walls_in(&slices, layout) };
            let groups = self.grouper.group(&self.bodies, &slices, alone);
            self.after.resize(first + groups.len());
            for p in 0..groups.len() {
                self.slot[groups.member(p) as usize] = (first + p) as u32;
            }
            run(
                &self.bodies,
                &groups,
                &layout.span,
                layout.span.steps,
                workers,
                first,
                &mut self.after,
            );
            tallies.run += groups.len() as u64;
            if repair > 0 {
                tallies.repaired += groups.len() as u64;
            }
            self.batches.push(Batch { first, groups });
            let broken = self.verify(layout, &cells, &special, &walls, workers, tallies);
            if broken.is_empty() {
                tallies.windows += 1;
                let members: u64 = self.slot.iter().map(|&slot| u64::from(slot != FREE)).sum();
                tallies.flown += self.bodies.len() as u64 - members;
                tallies.walls += walls.len() as u64;
                return true;
            }
            pairs = vec![self.with_their_groups(broken)];
        }
        tallies.redone += 1;
        false
    }

    /// The particles after `steps` ≤ the window's steps; nothing is changed.
    pub(crate) fn look(&self, span: &Span, steps: u32, workers: &Workers) -> Bodies {
        let mut bodies = self.bodies.clone();
        fly(&mut bodies.x, &bodies.vx, steps, span.dt);
        fly(&mut bodies.y, &bodies.vy, steps, span.dt);
        let mut after = self.after.clone();
        if steps < span.steps {
            for batch in &self.batches {
                run(&self.bodies, &batch.groups, span, steps, workers, batch.first, &mut after);
            }
        }
        take(&mut bodies, &self.slot, &after);
        bodies
    }

    /// What an observer sees in each step of the window.
    pub(crate) fn observe<O: Observer>(&self, span: &Span) -> Vec<O> {
        let mut observers = vec![O::default(); span.steps as usize];
        let (mut room, mut after) = (Room::default(), After::default());
        for batch in &self.batches {
            let groups = &batch.groups;
            let couples = groups.couples.iter().map(|couple| (&couple[..], &[[0, 1]][..]));
            let crowds = (0..groups.ends.len()).map(|g| (groups.members_of(g), groups.pairs_of(g)));
            let mut place = batch.first;
            for (members, pairs) in couples.chain(crowds) {
                // A group that was repaired lives on in a later batch.
                if self.slot[members[0] as usize] as usize == place {
                    after.resize(members.len());
                    let mut out = after.cut(0, &[members.len()]);
                    run_group(
                        &self.bodies,
                        members,
                        pairs,
                        span.steps,
                        span,
                        &mut room,
                        &mut observers,
                        &mut out[0],
                    );
                }
                place += members.len();
            }
        }
        observers
    }

    /// Ends the window: everybody is where its last step takes them.
    pub(crate) fn close(&mut self, span: &Span, workers: &Workers) {
        let n = self.bodies.len();
        let (slot, after, arch) = (&self.slot, &self.after, Arch::new());
        if n == 0 {
            return;
        }
        let work: Vec<_> = self
            .bodies
            .x
            .chunks_mut(PIECE)
            .zip(self.bodies.y.chunks_mut(PIECE))
            .zip(self.bodies.vx.chunks_mut(PIECE).zip(self.bodies.vy.chunks_mut(PIECE)))
            .zip(slot.chunks(PIECE))
            .collect();
        workers.map(work, |(((x, y), (vx, vy)), slot)| {
            arch.dispatch(|| {
                fly(x, vx, span.steps, span.dt);
                fly(y, vy, span.steps, span.dt);
            });
            for (i, &slot) in slot.iter().enumerate() {
                if slot != FREE {
                    let p = slot as usize;
                    (x[i], y[i], vx[i], vy[i]) = (after.x[p], after.y[p], after.vx[p], after.vy[p]);
                }
            }
        });
        self.slot.fill(FREE);
    }

    /// Pairs that could meet; particles that the grid's search may miss; those that may reach a
    /// wall.
    fn find(
        &mut self,
        layout: &Layout,
        cells: &Cells,
        workers: &Workers,
        tallies: &mut Tallies,
    ) -> (Vec<Vec<Pair>>, Vec<u32>, Vec<u32>) {
        let pieces = cells.pieces(PIECE);
        self.found.resize_with(pieces.len(), Found::default);
        let (bodies, arch) = (&self.bodies, Arch::new());
        let span = layout.span;
        let fast = layout.reach / span.whole();
        let work = pieces.into_iter().zip(self.found.drain(..)).collect();
        let results = workers.map(work, |(piece, found)| {
            let particles = cells.particles(&piece);
            let found = arch.dispatch(|| search(bodies, cells, piece, &span, layout.margin, found));
            let (mut special, mut walls) = (Vec::new(), Vec::new());
            arch.dispatch(|| {
                for i in particles {
                    let (x, y) = (bodies.x[i], bodies.y[i]);
                    let (vx, vy) = (bodies.vx[i], bodies.vy[i]);
                    let wall = span.meets_wall(x, y, vx, vy);
                    if wall | (vx * vx + vy * vy > fast * fast) {
                        special.push(i as u32);
                        if wall {
                            walls.push(i as u32);
                        }
                    }
                }
            });
            (found, special, walls)
        });
        let (mut special, mut walls, mut pairs) = (Vec::new(), Vec::new(), Vec::new());
        for (found, more_special, more_walls) in results {
            special.extend(more_special);
            walls.extend(more_walls);
            tallies.tests += found.tested;
            pairs.push(found.pairs);
        }
        if span.steps > 1 {
            let mut extra = Vec::new();
            let widest = self.widest(layout, &special);
            for &i in &special {
                self.around(layout, cells, i, widest, 0.0, layout.margin, &mut extra, tallies);
            }
            if !extra.is_empty() {
                // The grid's search may have found them, too.
                let known: std::collections::HashSet<Pair> = self.normal(&pairs, &special);
                extra.retain(|pair| !known.contains(pair));
                extra.sort_unstable();
                extra.dedup();
                pairs.push(extra);
            }
        }
        (pairs, special, walls)
    }

    fn normal(&self, pairs: &[Vec<Pair>], special: &[u32]) -> std::collections::HashSet<Pair> {
        let special: std::collections::HashSet<u32> = special.iter().copied().collect();
        let of_special =
            pairs.iter().flatten().filter(|p| special.contains(&p[0]) || special.contains(&p[1]));
        of_special.map(|&[i, j]| [i.min(j), i.max(j)]).collect()
    }

    /// The longest way that anybody goes in the window.
    fn widest(&self, layout: &Layout, special: &[u32]) -> f64 {
        let ways = special.iter().map(|&i| {
            let i = i as usize;
            self.bodies.vx[i].hypot(self.bodies.vy[i]) * layout.span.whole()
        });
        ways.fold(layout.reach, f64::max)
    }

    /// Everybody whose reference path may touch that of `i` if both leave theirs by `slack` in all.
    #[expect(clippy::too_many_arguments, reason = "a window is wide")]
    fn around(
        &self,
        layout: &Layout,
        cells: &Cells,
        i: u32,
        widest: f64,
        bent: f64,
        slack: f64,
        pairs: &mut Vec<Pair>,
        tallies: &mut Tallies,
    ) {
        let (span, p) = (layout.span, self.bodies.get(i as usize));
        let path = span.path(&p);
        let pad = CUTOFF + bent + slack + path.spread + widest + span.rounding();
        let (end_x, end_y) = (p.x + path.wx * span.whole(), p.y + path.wy * span.whole());
        let between = |a: f64, b: f64| (a.min(b) - pad, a.max(b) + pad);
        cells.in_rectangle(between(p.x, end_x), between(p.y, end_y), |range| {
            tallies.tests += range.len() as u64;
            for k in range {
                let other = self.bodies.get(k);
                let off = bent + self.bent(k) + slack + span.rounding();
                if k != i as usize && path.may_touch(&span.path(&other), span.forces(), off) {
                    pairs.push([i.min(k as u32), i.max(k as u32)]);
                }
            }
        });
    }

    fn bent(&self, i: usize) -> f64 {
        match self.slot.get(i) {
            Some(&slot) if slot != FREE => self.after.bent[slot as usize],
            _ => 0.0,
        }
    }

    /// Pairs that nobody computed and that may have touched after all, because one of them was
    /// pushed further off its path than the margin allows. Looks at the members of the last batch.
    ///
    /// A pair that is computed nowhere was further apart than cutoff + margin on its reference
    /// paths. It cannot have touched if both particles together are off theirs by no more than
    /// the margin. Where a particle is off by more than half of it, we look at everybody near,
    /// with the distances by which they *are* off. Of two such it suffices that the one looks that
    /// is further off.
    fn verify(
        &self,
        layout: &Layout,
        cells: &Cells,
        special: &[u32],
        walls: &[u32],
        workers: &Workers,
        tallies: &mut Tallies,
    ) -> Vec<Pair> {
        let span = layout.span;
        if span.steps == 1 {
            return Vec::new();
        }
        let batch = self.batches.last().expect("a batch was run");
        let most = self.after.bent.iter().copied().fold(0.0, f64::max);
        let pieces: Vec<usize> = (0..batch.groups.len()).step_by(PIECE).collect();
        let arch = Arch::new();
        let widest = self.widest(layout, special);
        // A few that are very fast are asked one by one, so that they do not widen every search.
        let few = special.len() <= 64;
        let results = workers.map(pieces, |from| {
            let (mut broken, mut tallies, mut near) =
                (Vec::<Pair>::new(), Tallies::default(), Vec::new());
            for p in from..(from + PIECE).min(batch.groups.len()) {
                let bent = self.after.bent[batch.first + p];
                if too_far_off(bent, layout.margin) {
                    tallies.verified += 1;
                    let i = batch.groups.member(p);
                    let reach = if few { layout.reach } else { widest };
                    near.clear();
                    arch.dispatch(|| {
                        self.near(layout, cells, i, reach, bent, &mut near, &mut tallies)
                    });
                    if few {
                        near.extend(special.iter().map(|&k| [i, k]));
                    }
                    broken.extend(near.iter().filter(|pair| self.may_have_touched(**pair, &span)));
                }
            }
            (broken, tallies)
        });
        let mut broken = Vec::new();
        for (pairs, counted) in results {
            broken.extend(pairs);
            tallies.verified += counted.verified;
            tallies.tests += counted.tests;
        }
        for &i in walls {
            let mut near = Vec::new();
            self.around(layout, cells, i, widest + most, 0.0, 0.0, &mut near, tallies);
            broken.extend(near.into_iter().filter(|pair| self.may_have_touched(*pair, &span)));
        }
        for pair in &mut broken {
            *pair = [pair[0].min(pair[1]), pair[0].max(pair[1])];
        }
        broken.sort_unstable();
        broken.dedup();
        broken
    }

    /// Everybody on a straight path that comes within cutoff + 2 `bent` of that of `i`.
    #[inline(always)]
    #[expect(clippy::too_many_arguments, reason = "a window is wide")]
    fn near(
        &self,
        layout: &Layout,
        cells: &Cells,
        i: u32,
        reach: f64,
        bent: f64,
        pairs: &mut Vec<Pair>,
        tallies: &mut Tallies,
    ) {
        let (span, p) = (layout.span, self.bodies.get(i as usize));
        let close = CUTOFF + 2.0 * bent + span.rounding();
        let pad = close + reach;
        let (end_x, end_y) = (p.x + p.vx * span.whole(), p.y + p.vy * span.whole());
        let between = |a: f64, b: f64| (a.min(b) - pad, a.max(b) + pad);
        cells.in_rectangle(between(p.x, end_x), between(p.y, end_y), |range| {
            tallies.tests += range.len() as u64;
            meet(&self.bodies, i as usize, range, span.forces(), close, pairs);
        });
    }

    /// Whether an uncomputed pair may have touched, given how far both were off.
    fn may_have_touched(&self, [i, k]: Pair, span: &Span) -> bool {
        if i == k || self.is_computed(i, k) {
            return false;
        }
        let [a, b] = [i, k].map(|i| {
            let mut path = span.path(&self.bodies.get(i as usize));
            // A path along a wall was given its spread for free flight; what it is now is known.
            let bent = self.bent(i as usize);
            if path.spread > 0.0 && self.slot[i as usize] != FREE {
                path.spread = 0.0;
            }
            path.spread += bent;
            path
        });
        a.may_touch(&b, span.forces(), span.rounding())
    }

    fn is_computed(&self, i: u32, k: u32) -> bool {
        let [a, b] = [i, k].map(|i| self.slot[i as usize]);
        if a == FREE || b == FREE {
            return false;
        }
        let batch = self.batch_of(a);
        let couples = 2 * batch.groups.couples.len();
        let [a, b] = [a, b].map(|slot| (slot as usize).wrapping_sub(batch.first));
        if a < couples {
            return a ^ 1 == b;
        }
        let Some(&group) = batch.groups.group_of.get(a - couples) else { return false };
        if b < couples || batch.groups.group_of.get(b - couples) != Some(&group) {
            return false;
        }
        let first = group.checked_sub(1).map_or(0, |g| batch.groups.ends[g as usize] as usize);
        let [a, b] = [a, b].map(|p| (p - couples - first) as u32);
        batch.groups.pairs_of(group as usize).binary_search(&[a.min(b), a.max(b)]).is_ok()
    }

    fn batch_of(&self, slot: u32) -> &Batch {
        let after = self.batches.partition_point(|batch| batch.first <= slot as usize);
        &self.batches[after - 1]
    }

    /// The pairs of all groups that `broken` pairs join, and these.
    fn with_their_groups(&self, broken: Vec<Pair>) -> Vec<Pair> {
        let mut slots: Vec<usize> = Vec::new();
        for &i in broken.iter().flatten() {
            if self.slot[i as usize] != FREE {
                let slot = self.slot[i as usize];
                let batch = self.batch_of(slot);
                let (p, couples) = (slot as usize - batch.first, 2 * batch.groups.couples.len());
                // Every group is named by its first slot.
                slots.push(
                    batch.first
                        + match p.checked_sub(couples) {
                            None => p & !1,
                            Some(member) => {
                                let group = batch.groups.group_of[member];
                                let before = group.checked_sub(1);
                                couples
                                    + before.map_or(0, |g| batch.groups.ends[g as usize] as usize)
                            }
                        },
                );
            }
        }
        slots.sort_unstable();
        slots.dedup();
        let mut pairs = broken;
        for slot in slots {
            let batch = self.batch_of(slot as u32);
            let (p, couples) = (slot - batch.first, 2 * batch.groups.couples.len());
            if p < couples {
                pairs.push(batch.groups.couples[p / 2]);
            } else {
                let group = batch.groups.group_of[p - couples] as usize;
                let members = batch.groups.members_of(group);
                let places = |pair: &Pair| pair.map(|k| members[k as usize]);
                pairs.extend(batch.groups.pairs_of(group).iter().map(places));
            }
        }
        pairs
    }

    /// Those among `pairs` that may reach a wall.
    fn walls_in(&self, pairs: &[&[Pair]], layout: &Layout) -> Vec<u32> {
        let mut walls: Vec<u32> = pairs
            .iter()
            .copied()
            .flatten()
            .flatten()
            .copied()
            .filter(|&i| {
                let Particle { x, y, vx, vy, .. } = self.bodies.get(i as usize);
                layout.span.meets_wall(x, y, vx, vy)
            })
            .collect();
        walls.sort_unstable();
        walls.dedup();
        walls
    }
}

/// Whether a particle `bent` off its reference path may have come near somebody whom the search
/// did not list for it. The search listed all pairs within cutoff + `margin`; the other particle
/// of an unlisted pair may be off its own path, too, and asks for itself if it is off by more.
///
/// Book: chapter 10, *A margin that is checked*.
pub fn too_far_off(bent: f64, margin: f64) -> bool {
    todo!("task 10.8: whether the margin held")
}

/// Puts the members of groups where they are after the steps that were run.
fn take(bodies: &mut Bodies, slot: &[u32], after: &After) {
    for (i, &slot) in slot.iter().enumerate() {
        if slot != FREE {
            let p = slot as usize;
            (bodies.x[i], bodies.y[i]) = (after.x[p], after.y[p]);
            (bodies.vx[i], bodies.vy[i]) = (after.vx[p], after.vy[p]);
        }
    }
}

/// Runs all groups for `steps` steps, results from `first` on.
fn run(
    bodies: &Bodies,
    groups: &Groups,
    span: &Span,
    steps: u32,
    workers: &Workers,
    first: usize,
    after: &mut After,
) {
    let couples = groups.couples.len();
    let couple_pieces = couples.div_ceil(GROUPS);
    let crowd_pieces = groups.ends.len().div_ceil(GROUPS);
    let mut ends: Vec<usize> = (1..=couple_pieces).map(|k| 2 * (k * GROUPS).min(couples)).collect();
    ends.extend(
        (1..=crowd_pieces)
            .map(|k| 2 * couples + groups.ends[(k * GROUPS).min(groups.ends.len()) - 1] as usize),
    );
    let arch = Arch::new();
    let work = after.cut(first, &ends).into_iter().enumerate().collect();
    workers.map(work, |(piece, mut out): (usize, crate::flight::Slice<'_>)| {
        let mut room = Room::default();
        let no: &mut [Silent] = &mut [];
        if piece < couple_pieces {
            let mine = &groups.couples[piece * GROUPS..((piece + 1) * GROUPS).min(couples)];
            for (k, some) in mine.chunks(LANES).enumerate() {
                let from = 2 * k * LANES;
                let done = match some.try_into() {
                    Ok(eight) => {
                        let mut out = out.part(from..from + 2 * LANES);
                        arch.dispatch(|| run_couples(bodies, eight, steps, span, &mut out))
                    }
                    Err(_) => false,
                };
                if !done {
                    for (l, couple) in some.iter().enumerate() {
                        let mut out = out.part(from + 2 * l..from + 2 * l + 2);
                        run_group(bodies, couple, &[[0, 1]], steps, span, &mut room, no, &mut out);
                    }
                }
            }
        } else {
            let from = (piece - couple_pieces) * GROUPS;
            let mut place = 0;
            for g in from..(from + GROUPS).min(groups.ends.len()) {
                let members = groups.members_of(g);
                let mut out = out.part(place..place + members.len());
                run_group(
                    bodies,
                    members,
                    groups.pairs_of(g),
                    steps,
                    span,
                    &mut room,
                    no,
                    &mut out,
                );
                place += members.len();
            }
        }
    });
}
