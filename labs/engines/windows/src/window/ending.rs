//! The particles at the end of a window, or after any of its steps for an observer.

use std::marker::PhantomData;

use common::soft::Observer;
use neighbour_list::{Bodies, Moving, Workers};
use pulp::{Arch, NullaryFnOnce};

use super::band::Band;
use super::opening::Window;
use crate::groups::Batch;
use crate::rules::Rules;
use crate::span::Span;

/// A vector kernel that moves a band's particles in free flight along one axis.
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
    /// Returns the particles after `steps` of the window's steps, and changes nothing.
    pub(crate) fn after<R: Rules>(&self, span: &Span, steps: u32) -> Bodies {
        let mut bodies = self.bodies.clone();
        R::fly(&mut bodies.x, &bodies.vx, steps, span.dt);
        R::fly(&mut bodies.y, &bodies.vy, steps, span.dt);
        let batches = self.bands.iter().map(|band| &band.batch).chain(&self.late);
        for batch in batches {
            let mut now = Batch::default();
            batch.groups.run::<R>(&self.bodies, &Span { steps, ..*span }, &mut now.record);
            batch.groups.for_each_member(|slot, i| {
                // A group that was repaired is in a later batch.
                if self.slot(i).is_some_and(|(last, _)| std::ptr::eq(last, batch)) {
                    let i = i as usize;
                    bodies.set(i, now.end(slot, self.bodies.id[i]));
                }
            });
        }
        bodies
    }

    /// Returns the observations of each step of the window.
    pub(crate) fn observe<R: Rules, O: Observer>(&self, span: &Span) -> Vec<O> {
        let mut observers = vec![O::default(); span.steps as usize];
        for batch in self.bands.iter().map(|band| &band.batch).chain(&self.late) {
            batch.groups.observe::<R, O>(&self.bodies, span, &mut observers, |i| {
                self.slot(i).is_some_and(|(last, _)| std::ptr::eq(last, batch))
            });
        }
        observers
    }

    /// Ends the window: moves all particles to the end of its last step.
    pub(crate) fn close<R: Rules>(&mut self, span: &Span, workers: &Workers) {
        if span.steps == 0 {
            return;
        }
        let arch = Arch::new();
        let ends: Vec<usize> = self.bands.iter().map(|band| band.particles.end).collect();
        let work = self.bands.iter().zip(self.bodies.split(&ends)).collect();
        workers.map(work, |(band, moving): (&Band, Moving<'_>)| {
            let Moving { x, y, vx, vy, .. } = moving;
            arch.dispatch(Fly::<R> { x, v: vx, span, rules: PhantomData });
            arch.dispatch(Fly::<R> { x: y, v: vy, span, rules: PhantomData });
            let record = &band.batch.record;
            band.batch.groups.for_each_member(|slot, i| {
                let i = i as usize - band.particles.start;
                x[i] = record.x[slot];
                y[i] = record.y[slot];
                vx[i] = record.vx[slot];
                vy[i] = record.vy[slot];
            });
        });
        // A group that was repaired is in a later batch.
        let bodies = &mut self.bodies;
        for batch in &self.late {
            batch.groups.for_each_member(|slot, i| {
                bodies.set(i as usize, batch.end(slot, bodies.id[i as usize]));
            });
        }
    }
}
