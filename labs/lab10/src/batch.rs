//! Groups that are computed at the same time.

use common::soft::{NoStatistics, Observer, Particle};
use pulp::{Arch, NullaryFnOnce};

use crate::Bodies;
use crate::band::FREE;
use crate::flight::{Room, run_group};
use crate::groups::Groups;
use crate::lanes::larger;
use crate::pace::{Fast, Pace};
use crate::path::Span;
use crate::record::Record;
use crate::search::Pair;
use crate::together::{LANES, run_together};

/// Groups and what became of them.
#[derive(Default)]
pub(crate) struct Batch {
    pub(crate) groups: Groups,
    pub(crate) record: Record,
    /// The number of its first seat.
    pub(crate) first: usize,
    /// How many of its members are in no earlier batch.
    pub(crate) new: usize,
    /// How far the most bent of its members is off.
    pub(crate) most_bent: f64,
}

impl Groups {
    /// Takes all groups through `steps` steps of a window.
    pub(crate) fn run(&self, bodies: &Bodies, steps: u32, span: &Span, record: &mut Record) {
        record.resize(self.seats(), steps);
        Arch::new().dispatch(RunSmall { groups: self, bodies, steps, span, record });
        let crowds = self.begins()[2];
        let mut room = Room::default();
        for g in 0..self.ends.len() {
            let crowd = self.crowd(g);
            let (members, no): (_, &mut [NoStatistics]) = (&self.members[crowd.clone()], &mut []);
            let mut out = record.block(crowds + crowd.start, crowd.len());
            let pairs = self.pairs_of(g);
            run_group(bodies, members, pairs, steps, span, &mut room, no, &mut out);
        }
    }

    /// Runs all groups once more for those who watch; `is_theirs` says whether the group with a
    /// given seat is not computed elsewhere by now.
    pub(crate) fn observe<O: Observer>(
        &self,
        bodies: &Bodies,
        span: &Span,
        observers: &mut [O],
        mut is_theirs: impl FnMut(usize, u32) -> bool,
    ) {
        let (mut room, mut record) = (Room::default(), Record::default());
        let mut heads = Vec::new();
        self.for_each_member(|seat, i| {
            let members = self.seat(seat).members;
            if members[0] == i && is_theirs(seat, i) {
                heads.push(seat);
            }
        });
        for seat in heads {
            let seat = self.seat(seat);
            let all = all_pairs(seat.members.len());
            let pairs = seat.crowd.map_or(&all[..], |g| self.pairs_of(g));
            record.resize(seat.members.len(), span.steps);
            let mut out = record.block(0, seat.members.len());
            let steps = span.steps;
            run_group(bodies, seat.members, pairs, steps, span, &mut room, observers, &mut out);
        }
    }
}

/// All pairs of a small group.
pub(crate) fn all_pairs(members: usize) -> Vec<Pair> {
    let members = if members > 4 { 0 } else { members as u32 };
    (0..members).flat_map(|a| (a + 1..members).map(move |b| [a, b])).collect()
}

/// Runs all groups of two, three and four.
struct RunSmall<'a> {
    groups: &'a Groups,
    bodies: &'a Bodies,
    steps: u32,
    span: &'a Span,
    record: &'a mut Record,
}

impl NullaryFnOnce for RunSmall<'_> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        let Self { groups, bodies, steps, span, record } = self;
        let [triples, quads, _] = groups.begins();
        run_small(bodies, &groups.couples, 0, steps, span, record);
        run_small(bodies, &groups.triples, triples, steps, span, record);
        run_small(bodies, &groups.quads, quads, steps, span, record);
    }
}

#[inline(always)]
fn run_small<const M: usize>(
    bodies: &Bodies,
    groups: &[[u32; M]],
    first: usize,
    steps: u32,
    span: &Span,
    record: &mut Record,
) {
    for (k, block) in groups.chunks(LANES).enumerate() {
        let mut out = record.block(first + k * LANES * M, LANES * M);
        if !run_together(bodies, block, steps, span, &mut out) {
            run_apart(bodies, block, steps, span, first + k * LANES * M, record);
        }
    }
}

/// Runs the groups of a block one after another, with walls.
#[inline(never)]
fn run_apart<const M: usize>(
    bodies: &Bodies,
    groups: &[[u32; M]],
    steps: u32,
    span: &Span,
    first: usize,
    record: &mut Record,
) {
    let (mut room, mut one, pairs) = (Room::default(), Record::default(), all_pairs(M));
    one.resize(M, steps);
    for (l, group) in groups.iter().enumerate() {
        let no: &mut [NoStatistics] = &mut [];
        run_group(bodies, group, &pairs, steps, span, &mut room, no, &mut one.block(0, M));
        let (out, from) = (record.block(first, LANES * M), one.block(0, M));
        for m in 0..M {
            let seat = m * LANES + l;
            (out.x[seat], out.y[seat]) = (from.x[m], from.y[m]);
            (out.vx[seat], out.vy[seat]) = (from.vx[m], from.vy[m]);
            out.bent[seat] = from.bent[m];
            for step in 0..steps.saturating_sub(1) as usize {
                let place = step * LANES * M + seat;
                out.off_x[place] = from.off_x[step * M + m];
                out.off_y[place] = from.off_y[step * M + m];
            }
        }
    }
}

impl Batch {
    /// Where the member in seat `p` is at last, and with which id.
    pub(crate) fn end(&self, p: usize, id: u32) -> Particle {
        let Record { x, y, vx, vy, .. } = &self.record;
        Particle { x: x[p], y: y[p], vx: vx[p], vy: vy[p], id }
    }

    /// Notes the members that end faster than usual, or went further in `time` than they may.
    pub(crate) fn watch(&self, bodies: &Bodies, time: f64, pace: &Pace<'_>, fast: &mut Fast) {
        let Record { x, y, vx, vy, .. } = &self.record;
        self.groups.for_each_member(|p, i| {
            let (dx, dy) = (x[p] - bodies.x[i as usize], y[p] - bodies.y[i as usize]);
            let mean = (dx * dx + dy * dy) / (time * time);
            pace.judge(i, larger(vx[p] * vx[p] + vy[p] * vy[p], mean), fast);
        });
    }

    /// Writes down for each member where it sits and how far it was bent; both arrays are of all
    /// particles from number `first` on.
    pub(crate) fn note(&mut self, flag: u32, first: usize, slots: &mut [u32], bent: &mut [f32]) {
        let Self { groups, record, .. } = self;
        let (mut most, mut new) = (0.0, 0);
        groups.for_each_member(|seat, i| {
            let slot = &mut slots[i as usize - first];
            new += usize::from(*slot == FREE);
            *slot = flag + seat as u32;
            // Rounded up.
            bent[i as usize - first] = record.bent[seat] as f32 * (1.0 + 1e-6);
            most = record.bent[seat].max(most);
        });
        (self.most_bent, self.new) = (most, new);
    }
}
