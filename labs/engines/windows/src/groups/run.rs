//! Runs groups through a window.

use std::marker::PhantomData;
use std::ops::Range;

use common::soft::{CUTOFF, NoStatistics, Observer};
use neighbour_list::Bodies;
use neighbour_list::kernels::coefficient;
use pulp::{Arch, NullaryFnOnce};
use solution1::bounce;

use super::slots::{Group, Groups, LANES, Record, Slice};
use super::together::run_together;
use crate::path::Path;
use crate::rules::Rules;
use crate::span::Span;

/// The working memory for a group.
#[derive(Default)]
pub(crate) struct Scratch {
    ax: Vec<f64>,
    ay: Vec<f64>,
    paths: Vec<Path>,
}

impl Group<'_> {
    /// Runs a group of any size through the steps of `span`, with its walls. Writes its members to
    /// `out`.
    ///
    /// Members are in the order of their ids, and pairs are in ascending order. So every particle
    /// sums over its neighbours in ascending order of ids, as in all-pairs programs, and the bits
    /// are the same. `observers` is empty or has an observer for each step.
    fn run<R: Rules, O: Observer>(
        &self,
        start: &Bodies,
        span: &Span,
        scratch: &mut Scratch,
        observers: &mut [O],
        out: &mut Slice<'_>,
    ) {
        let n = self.members.len();
        let dt = span.dt;
        scratch.paths.clear();
        for (k, &i) in self.members.iter().enumerate() {
            let p = start.get(i as usize);
            out.x[k] = p.x;
            out.y[k] = p.y;
            out.vx[k] = p.vx;
            out.vy[k] = p.vy;
            out.deviation[k] = 0.0;
            scratch.paths.push(span.path::<R>(&p));
        }
        scratch.ax.resize(n.max(scratch.ax.len()), 0.0);
        scratch.ay.resize(n.max(scratch.ay.len()), 0.0);
        for step in 1..=span.steps {
            self.sum(scratch, observers.get_mut(step as usize - 1), out);
            let time = f64::from(step) * dt;
            for (k, path) in scratch.paths.iter().enumerate() {
                out.vx[k] += scratch.ax[k] * dt;
                out.vy[k] += scratch.ay[k] * dt;
                (out.x[k], out.vx[k]) = bounce(out.x[k] + out.vx[k] * dt, out.vx[k], span.size);
                (out.y[k], out.vy[k]) = bounce(out.y[k] + out.vy[k] * dt, out.vy[k], span.size);
                if step < span.steps {
                    let dx = out.x[k] - (path.x + path.wx * time);
                    let dy = out.y[k] - (path.y + path.wy * time);
                    let beyond = (dx * dx + dy * dy).sqrt() - path.spread;
                    out.deviation[k] = out.deviation[k].max(beyond);
                    out.off[(step as usize - 1) * n + k] = [dx as f32, dy as f32];
                }
            }
        }
    }

    /// Sums the accelerations at the positions in `at`.
    #[inline(always)]
    fn sum<O: Observer>(
        &self,
        scratch: &mut Scratch,
        mut observer: Option<&mut O>,
        at: &Slice<'_>,
    ) {
        let Scratch { ax, ay, .. } = scratch;
        ax[..self.members.len()].fill(0.0);
        ay[..self.members.len()].fill(0.0);
        for &[a, b] in self.pairs {
            let [a, b] = [a as usize, b as usize];
            let dx = at.x[b] - at.x[a];
            let dy = at.y[b] - at.y[a];
            let r2 = dx * dx + dy * dy;
            if r2 <= CUTOFF * CUTOFF {
                let coef = coefficient(r2);
                ax[a] += coef * dx;
                ay[a] += coef * dy;
                ax[b] -= coef * dx;
                ay[b] -= coef * dy;
                if let Some(observer) = &mut observer {
                    observer.seen(r2);
                    observer.seen(r2);
                }
            }
        }
        if let Some(observer) = &mut observer {
            observer.tested(self.pairs.len() as u64);
        }
    }

    /// Runs only this group, and writes its members to the first slots of `record`.
    pub(crate) fn run_alone<R: Rules, O: Observer>(
        &self,
        start: &Bodies,
        span: &Span,
        observers: &mut [O],
        record: &mut Record,
    ) {
        let n = self.members.len();
        record.resize(n, span.steps);
        let mut scratch = Scratch::default();
        self.run::<R, O>(start, span, &mut scratch, observers, &mut record.slice(0..n));
    }
}

impl Groups {
    /// Runs all groups through the steps of `span`.
    pub(crate) fn run<R: Rules>(&self, bodies: &Bodies, span: &Span, record: &mut Record) {
        record.resize(self.slots(), span.steps);
        let rules = PhantomData::<R>;
        Arch::new().dispatch(RunSmall { groups: self, bodies, span, record, rules });
        let mut scratch = Scratch::default();
        let no_observers: &mut [NoStatistics] = &mut [];
        for g in 0..self.ends.len() {
            let crowd = self.crowd(g);
            let mut out = record.slice(crowd.block.clone());
            crowd.run::<R, _>(bodies, span, &mut scratch, no_observers, &mut out);
        }
    }

    /// Runs all groups again for observers.
    ///
    /// A group may have been computed again in a later batch. For a member of a group, `is_theirs`
    /// returns whether this batch was the last to compute the group.
    pub(crate) fn observe<R: Rules, O: Observer>(
        &self,
        bodies: &Bodies,
        span: &Span,
        observers: &mut [O],
        is_theirs: impl Fn(u32) -> bool,
    ) {
        let mut record = Record::default();
        self.for_each_member(|slot, i| {
            let group = self.group(slot);
            if group.members[0] == i && is_theirs(i) {
                group.run_alone::<R, O>(bodies, span, observers, &mut record);
            }
        });
    }
}

/// A vector kernel that runs all small groups.
struct RunSmall<'a, R> {
    groups: &'a Groups,
    bodies: &'a Bodies,
    span: &'a Span,
    record: &'a mut Record,
    rules: PhantomData<R>,
}

impl<R: Rules> NullaryFnOnce for RunSmall<'_, R> {
    type Output = ();

    #[inline(always)]
    fn call(mut self) {
        self.of_size::<2>(0);
        self.of_size::<3>(1);
        self.of_size::<4>(2);
    }
}

impl<R: Rules> RunSmall<'_, R> {
    /// Runs the groups of size `M`, which have index `k` among the sizes.
    #[inline(always)]
    fn of_size<const M: usize>(&mut self, k: usize) {
        let first = self.groups.begins()[k];
        let (all, _) = self.groups.small[k].as_chunks::<M>();
        for (slots, some) in (first..).step_by(LANES * M).zip(all.chunks(LANES)) {
            let mut out = self.record.slice(slots..slots + LANES * M);
            if !run_together(self.bodies, some, self.span, &mut out) {
                self.apart(slots..slots + some.len(), M);
            }
        }
    }

    /// Runs groups of `size` members with walls, one after another. `slots` are the slots of the
    /// groups' first members.
    #[inline(never)]
    fn apart(&mut self, slots: Range<usize>, size: usize) {
        let Self { groups, bodies, span, record, .. } = self;
        let mut one = Record::default();
        let no_observers: &mut [NoStatistics] = &mut [];
        for first in slots {
            let group = groups.group(first);
            group.run_alone::<R, _>(bodies, span, no_observers, &mut one);
            let block = group.block;
            for (m, slot) in (first..).step_by(LANES).take(size).enumerate() {
                record.x[slot] = one.x[m];
                record.y[slot] = one.y[m];
                record.vx[slot] = one.vx[m];
                record.vy[slot] = one.vy[m];
                record.deviation[slot] = one.deviation[m];
                for step in 0..span.steps.saturating_sub(1) as usize {
                    let off = &mut record.slice(block.clone()).off[step * block.len()..];
                    off[slot - block.start] =
                        one.off(&(0..size), m, step + 1).map(|off| off as f32);
                }
            }
        }
    }
}
