//! An engine that has a part of the particles, while the rest are elsewhere: when it makes its list
//! and moves is for its owner to say.

use common::soft::Observer;

use super::engine::Verlet;
use super::step::Step;
use crate::list::{Limits, Neighbours};
use crate::particles::Bodies;

impl<O: Observer> Verlet<O> {
    /// The particles, to take some away and add some; then the list has to be made anew.
    pub fn bodies_mut(&mut self) -> &mut Bodies {
        &mut self.bodies
    }

    /// The list.
    pub fn list(&self) -> &Neighbours {
        &self.list
    }

    /// The speed that the list is made for.
    pub fn limits(&self) -> &Limits {
        &self.limits
    }

    /// What has been seen since it was last taken.
    pub fn observer_mut(&mut self) -> &mut O {
        &mut self.observer
    }

    /// Whether the list must be made anew before the next forces.
    pub fn is_worn_out(&self) -> bool {
        !self.bodies.is_empty() && self.is_spent()
    }

    /// Makes the list anew. There may be no particles.
    pub fn renew(&mut self) {
        if self.bodies.is_empty() {
            self.start(Bodies::default(), self.size);
            self.passes.clear();
        } else {
            self.rebuild(&self.workers.clone());
        }
    }

    /// As [`renew`](Self::renew); the particles as they were before, unsorted, are
    /// then in `kept`, whose memory the next list will use.
    pub fn renew_keeping(&mut self, kept: &mut Bodies) {
        self.renew();
        // Sorting has left them in the arrays that the next sort would write to.
        std::mem::swap(kept, &mut self.spare);
        kept.resize(self.bodies.len());
    }

    /// Begins a step in which particles elsewhere push those in the places `pushed`, ascending.
    pub fn begin(&mut self, pushed: &[u32]) -> Step<'_, O> {
        let workers = self.workers.clone();
        self.shorten_if_due(&workers);
        self.sweep(&workers, pushed)
    }

    /// Ends the step. Brings back how far it took the fastest particle at most.
    pub fn end(&mut self) -> f64 {
        self.age() * self.limits.outliers().fastest() * self.limits.displacement()
    }
}
