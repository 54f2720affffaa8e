//! The engine in which all particles take the same step at the same time.

mod field;
mod system;

use common::soft::{DT, Particle, Scene, Simulation};

use crate::state::State;
pub use system::{Method, RungeKutta, System};

/// The engine that moves particles with the method `M`.
pub struct Integrated<M> {
    method: M,
    divide: u32,
    stretch: f64,
    system: System,
}

impl<M: Method> Integrated<M> {
    /// Makes an engine for `threads` threads. A step is `stretch` official steps long, and is
    /// divided into `divide` small steps.
    pub fn new(threads: usize, method: M, divide: u32, stretch: f64) -> Self {
        Self { method, divide, stretch, system: System::new(threads) }
    }
}

impl<M: Method> Simulation for Integrated<M> {
    fn load(&mut self, scene: &Scene) {
        self.system.start(State::of(scene), scene.size());
    }

    fn step(&mut self) {
        let dt = self.stretch * DT / f64::from(self.divide);
        for _ in 0..self.divide {
            self.method.advance(&mut self.system, dt);
        }
    }

    fn read(&self, first: usize, out: &mut [Particle]) {
        self.system.state.read(first, out);
    }

    fn counters(&self) -> Vec<(&'static str, f64)> {
        vec![("force evaluations", self.system.evaluations as f64)]
    }
}
