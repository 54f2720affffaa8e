//! The tasks, in the form that the engines call.

use common::Vec2;
use integrators::{Method, Rules, State, System, Watched};

use crate::{Composition, Motion};

impl Motion for System {
    fn drift(&mut self, dt: f64) {
        System::drift(self, dt);
    }

    fn kick(&mut self, dt: f64) {
        System::kick(self, dt);
    }
}

impl Method for Composition {
    fn advance(&self, system: &mut System, dt: f64) {
        self.step(system, dt);
    }
}

/// Your functions, for the engines with Runge-Kutta and located events.
pub struct Tasks;

impl Rules for Tasks {
    fn slopes(start: &State, h: f64, accelerations: &mut dyn FnMut(&[Vec2], &mut [Vec2])) -> State {
        crate::slopes(start, h, accelerations)
    }

    fn first_fall(
        start: Watched,
        end: Watched,
        h: f64,
        at: &mut dyn FnMut(f64) -> Watched,
    ) -> Option<f64> {
        crate::first_fall(start, end, h, at)
    }
}
