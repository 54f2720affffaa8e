//! Running groups through a window.

use std::marker::PhantomData;

use common::soft::{CUTOFF, NoStatistics, Observer};
use neighbour_list::Bodies;
use neighbour_list::kernels::{Pair, coefficient};
use pulp::{Arch, NullaryFnOnce};
use solution1::bounce;

use super::slots::{Groups, LANES, Record, Slice};
use super::together::run_together;
use crate::path::Path;
use crate::{Rules, Span};

/// What running a group needs for itself.
#[derive(Default)]
pub(crate) struct Scratch {
    ax: Vec<f64>,
    ay: Vec<f64>,
    paths: Vec<Path>,
}

/// Runs one group of any size through `steps` steps, with its walls, and writes its members to
/// `out`. `members` are indices in the sorted order by ascending id, `pairs` are numbers in
/// `members`, ascending: then every particle sums its neighbours by ascending id, as all pairs do,
/// and the bits are theirs. `observers`, if any, see one step each.
#[expect(clippy::too_many_arguments, reason = "a window is wide")]
pub(crate) fn run_group<R: Rules, O: Observer>(
    start: &Bodies,
    members: &[u32],
    pairs: &[Pair],
    steps: u32,
    span: &Span,
    scratch: &mut Scratch,
    observers: &mut [O],
    out: &mut Slice<'_>,
) {
    let (n, dt) = (members.len(), span.dt);
    scratch.paths.clear();
    for (k, &i) in members.iter().enumerate() {
        let p = start.get(i as usize);
        (out.x[k], out.y[k], out.vx[k], out.vy[k]) = (p.x, p.y, p.vx, p.vy);
        out.deviation[k] = 0.0;
        scratch.paths.push(span.path::<R>(&p));
    }
    scratch.ax.resize(n.max(scratch.ax.len()), 0.0);
    scratch.ay.resize(n.max(scratch.ay.len()), 0.0);
    for step in 1..=steps {
        scratch.ax[..n].fill(0.0);
        scratch.ay[..n].fill(0.0);
        let mut observer = observers.get_mut(step as usize - 1);
        for &[a, b] in pairs {
            let [a, b] = [a as usize, b as usize];
            let (dx, dy) = (out.x[b] - out.x[a], out.y[b] - out.y[a]);
            let r2 = dx * dx + dy * dy;
            if r2 <= CUTOFF * CUTOFF {
                let coef = coefficient(r2);
                scratch.ax[a] += coef * dx;
                scratch.ay[a] += coef * dy;
                scratch.ax[b] -= coef * dx;
                scratch.ay[b] -= coef * dy;
                if let Some(observer) = &mut observer {
                    observer.seen(r2);
                    observer.seen(r2);
                }
            }
        }
        if let Some(observer) = &mut observer {
            observer.tested(pairs.len() as u64);
        }
        let time = f64::from(step) * dt;
        for (k, path) in scratch.paths.iter().enumerate() {
            out.vx[k] += scratch.ax[k] * dt;
            out.vy[k] += scratch.ay[k] * dt;
            (out.x[k], out.vx[k]) = bounce(out.x[k] + out.vx[k] * dt, out.vx[k], span.size);
            (out.y[k], out.vy[k]) = bounce(out.y[k] + out.vy[k] * dt, out.vy[k], span.size);
            if step < steps {
                let dx = out.x[k] - (path.x + path.wx * time);
                let dy = out.y[k] - (path.y + path.wy * time);
                let beyond = (dx * dx + dy * dy).sqrt() - path.spread;
                out.deviation[k] = out.deviation[k].max(beyond);
                let entry = (step as usize - 1) * n + k;
                (out.off_x[entry], out.off_y[entry]) = (dx as f32, dy as f32);
            }
        }
    }
}

impl Groups {
    /// Takes all groups through `steps` steps of a window.
    pub(crate) fn run<R: Rules>(
        &self,
        bodies: &Bodies,
        steps: u32,
        span: &Span,
        record: &mut Record,
    ) {
        record.resize(self.slots(), steps);
        Arch::new().dispatch(RunSmall::<R> {
            groups: self,
            bodies,
            steps,
            span,
            record,
            rules: PhantomData,
        });
        let crowds = self.begins()[2];
        let mut scratch = Scratch::default();
        for g in 0..self.ends.len() {
            let crowd = self.crowd(g);
            let (members, no): (_, &mut [NoStatistics]) = (&self.members[crowd.clone()], &mut []);
            let mut out = record.block(crowds + crowd.start, crowd.len());
            let pairs = self.pairs_of(g);
            run_group::<R, _>(bodies, members, pairs, steps, span, &mut scratch, no, &mut out);
        }
    }

    /// Runs all groups once more for observers; `is_theirs` says whether the group with a
    /// given slot is not computed elsewhere by now.
    pub(crate) fn observe<R: Rules, O: Observer>(
        &self,
        bodies: &Bodies,
        span: &Span,
        observers: &mut [O],
        mut is_theirs: impl FnMut(usize, u32) -> bool,
    ) {
        let (mut scratch, mut record) = (Scratch::default(), Record::default());
        let mut heads = Vec::new();
        self.for_each_member(|slot, i| {
            let members = self.group(slot).members;
            if members[0] == i && is_theirs(slot, i) {
                heads.push(slot);
            }
        });
        for slot in heads {
            let group = self.group(slot);
            let all = all_pairs(group.members.len());
            let pairs = group.crowd.map_or(&all[..], |g| self.pairs_of(g));
            record.resize(group.members.len(), span.steps);
            let mut out = record.block(0, group.members.len());
            let steps = span.steps;
            run_group::<R, _>(
                bodies,
                group.members,
                pairs,
                steps,
                span,
                &mut scratch,
                observers,
                &mut out,
            );
        }
    }
}

/// All pairs of a small group.
pub(crate) fn all_pairs(members: usize) -> Vec<Pair> {
    let members = if members > 4 { 0 } else { members as u32 };
    (0..members).flat_map(|a| (a + 1..members).map(move |b| [a, b])).collect()
}

/// Runs all groups of two, three and four.
struct RunSmall<'a, R> {
    groups: &'a Groups,
    bodies: &'a Bodies,
    steps: u32,
    span: &'a Span,
    record: &'a mut Record,
    rules: PhantomData<R>,
}

impl<R: Rules> NullaryFnOnce for RunSmall<'_, R> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        let Self { groups, bodies, steps, span, record, .. } = self;
        let [triples, quads, _] = groups.begins();
        run_small::<R, _>(bodies, &groups.couples, 0, steps, span, record);
        run_small::<R, _>(bodies, &groups.triples, triples, steps, span, record);
        run_small::<R, _>(bodies, &groups.quads, quads, steps, span, record);
    }
}

#[inline(always)]
fn run_small<R: Rules, const M: usize>(
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
            run_apart::<R, M>(bodies, block, steps, span, first + k * LANES * M, record);
        }
    }
}

/// Runs the groups of a block one after another, with walls.
#[inline(never)]
fn run_apart<R: Rules, const M: usize>(
    bodies: &Bodies,
    groups: &[[u32; M]],
    steps: u32,
    span: &Span,
    first: usize,
    record: &mut Record,
) {
    let (mut scratch, mut one, pairs) = (Scratch::default(), Record::default(), all_pairs(M));
    one.resize(M, steps);
    for (l, group) in groups.iter().enumerate() {
        let no: &mut [NoStatistics] = &mut [];
        run_group::<R, _>(
            bodies,
            group,
            &pairs,
            steps,
            span,
            &mut scratch,
            no,
            &mut one.block(0, M),
        );
        let (out, from) = (record.block(first, LANES * M), one.block(0, M));
        for m in 0..M {
            let slot = m * LANES + l;
            (out.x[slot], out.y[slot]) = (from.x[m], from.y[m]);
            (out.vx[slot], out.vy[slot]) = (from.vx[m], from.vy[m]);
            out.deviation[slot] = from.deviation[m];
            for step in 0..steps.saturating_sub(1) as usize {
                let entry = step * LANES * M + slot;
                out.off_x[entry] = from.off_x[step * M + m];
                out.off_y[entry] = from.off_y[step * M + m];
            }
        }
    }
}
