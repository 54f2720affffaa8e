//! The engine of the integrator variants: all particles take the same step at the same time.

mod field;
mod system;

use common::soft::{DT, Particle, Scene, Simulation};

use crate::{Composition, State};
use system::System;

/// How a step is taken.
pub(crate) enum Method {
    /// Drifts and kicks by turns.
    Composition(Composition),
    /// The classical fourth-order method of Runge and Kutta.
    RungeKutta,
}

/// Particles and a method that moves them.
pub(crate) struct Integrated {
    method: Method,
    divide: u32,
    stretch: f64,
    system: System,
}

impl Integrated {
    /// An engine for `threads` threads whose step is `stretch` official ones, done in `divide`.
    pub(crate) fn new(threads: usize, method: Method, divide: u32, stretch: f64) -> Self {
        Self { method, divide, stretch, system: System::new(threads) }
    }
}

impl Simulation for Integrated {
    fn load(&mut self, scene: &Scene) {
        self.system.start(State::of(scene), scene.size());
    }

    fn step(&mut self) {
        let dt = self.stretch * DT / f64::from(self.divide);
        for _ in 0..self.divide {
            match &self.method {
                Method::Composition(composition) => composition.step(&mut self.system, dt),
                Method::RungeKutta => self.system.runge_kutta(dt),
            }
        }
    }

    fn read(&self, first: usize, out: &mut [Particle]) {
        self.system.state.read(first, out);
    }

    fn counters(&self) -> Vec<(&'static str, f64)> {
        vec![("force evaluations", self.system.evaluations as f64)]
    }
}
