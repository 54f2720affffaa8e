//! Where a window takes its particles: at its end, or at any step for an observer.

use std::marker::PhantomData;

use common::soft::Observer;
use neighbour_list::threads::cut;
use neighbour_list::{Bodies, Workers};
use pulp::{Arch, NullaryFnOnce};

use super::band::Band;
use super::opening::Window;
use crate::groups::Batch;
use crate::rules::Rules;
use crate::span::Span;

/// The free flight of a piece.
struct Fly<'a, R> {
    x: &'a mut [f64],
    v: &'a [f64],
    span: &'a Span,
    rules: PhantomData<R>,
}

impl<R: Rules> NullaryFnOnce for Fly<'_, R> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        R::fly(self.x, self.v, self.span.steps, self.span.dt);
    }
}

impl Window {
    /// The particles after `steps` ≤ the window's steps; nothing is changed.
    pub(crate) fn after<R: Rules>(&self, span: &Span, steps: u32) -> Bodies {
        let mut bodies = self.bodies.clone();
        R::fly(&mut bodies.x, &bodies.vx, steps, span.dt);
        R::fly(&mut bodies.y, &bodies.vy, steps, span.dt);
        let batches = self.bands.iter().map(|band| &band.batch).chain(&self.late);
        for batch in batches {
            let mut now = Batch::default();
            batch.groups.run::<R>(&self.bodies, &Span { steps, ..*span }, &mut now.record);
            batch.groups.for_each_member(|slot, i| {
                // A group that was repaired lives on in a later batch.
                if self.slot(i).is_some_and(|(last, _)| std::ptr::eq(last, batch)) {
                    let i = i as usize;
                    bodies.set(i, now.end(slot, self.bodies.id[i]));
                }
            });
        }
        bodies
    }

    /// What an observer sees in each step of the window.
    pub(crate) fn observe<R: Rules, O: Observer>(&self, span: &Span) -> Vec<O> {
        let mut observers = vec![O::default(); span.steps as usize];
        for batch in self.bands.iter().map(|band| &band.batch).chain(&self.late) {
            batch.groups.observe::<R, O>(&self.bodies, span, &mut observers, |i| {
                self.slot(i).is_some_and(|(last, _)| std::ptr::eq(last, batch))
            });
        }
        observers
    }

    /// Ends the window: all particles are where its last step takes them.
    pub(crate) fn close<R: Rules>(&mut self, span: &Span, workers: &Workers) {
        if span.steps == 0 {
            return;
        }
        let arch = Arch::new();
        let ends: Vec<usize> = self.bands.iter().map(|band| band.particles.end).collect();
        let bounds = || ends.iter().copied();
        let Bodies { x, y, vx, vy, .. } = &mut self.bodies;
        let axes = cut(x, bounds()).into_iter().zip(cut(vx, bounds()));
        let axes = axes.zip(cut(y, bounds()).into_iter().zip(cut(vy, bounds())));
        let work = self.bands.iter().zip(axes).collect();
        workers.map(work, |(band, ((x, vx), (y, vy))): (&Band, ((&mut [f64], _), _))| {
            arch.dispatch(Fly::<R> { x, v: vx, span, rules: PhantomData });
            arch.dispatch(Fly::<R> { x: y, v: vy, span, rules: PhantomData });
            let (first, record) = (band.particles.start, &band.batch.record);
            band.batch.groups.for_each_member(|slot, i| {
                let i = i as usize - first;
                (x[i], y[i]) = (record.x[slot], record.y[slot]);
                (vx[i], vy[i]) = (record.vx[slot], record.vy[slot]);
            });
        });
        // A group that was repaired lives on in a later batch.
        let bodies = &mut self.bodies;
        for batch in &self.late {
            batch.groups.for_each_member(|slot, i| {
                bodies.set(i as usize, batch.end(slot, bodies.id[i as usize]));
            });
        }
    }
}
