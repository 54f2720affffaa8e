//! Task 1.3: one step of all pairs.

use common::Vec2;
use common::soft::{Observer, Particle, Scene, Simulation, Statistics};

use crate::{add_pair, advance};

/// The naive program: every particle looks at every other particle.
#[derive(Default)]
pub struct AllPairs<O> {
    size: f64,
    particles: Vec<Particle>,
    accelerations: Vec<Vec2>,
    observer: O,
}

impl<O: Observer> AllPairs<O> {
    /// Sets each `accelerations[i]` to the acceleration of particle i due to all particles.
    ///
    /// - Start the sum at zero, and add the neighbours' contributions in ascending order,
    ///   j = 0 … n−1. The sum may include j = i, because this pair adds zero.
    /// - [`Particle::to`] returns the vector from a particle to its neighbour. [`add_pair`] adds the
    ///   acceleration that this neighbour causes.
    /// - All forces come from the positions at the *start* of the step, so no particle moves before all
    ///   sums are complete.
    /// - At the end, report the number of ordered pairs tested to the observer
    ///   ([`tested`](Observer::tested)).
    ///
    /// A floating-point sum depends on its order. A different order gives a different last digit,
    /// and after a thousand steps the picture is different.
    ///
    /// Book: chapter 1, *A step*.
    fn sum_forces(&mut self) {
        todo!("task 1.3: one step of all pairs")
    }
}

impl<O: Observer> Simulation for AllPairs<O> {
    fn load(&mut self, scene: &Scene) {
        self.size = scene.size();
        self.particles = scene.particles().to_vec();
        self.accelerations = vec![Vec2::ZERO; scene.len()];
        self.observer = O::default();
    }

    fn step(&mut self) {
        self.observer = O::default();
        self.sum_forces();
        for (particle, a) in self.particles.iter_mut().zip(&self.accelerations) {
            advance(particle, *a, self.size);
        }
    }

    fn read(&self, first: usize, out: &mut [Particle]) {
        out.copy_from_slice(&self.particles[first..first + out.len()]);
    }

    fn statistics(&self) -> Option<Statistics> {
        self.observer.statistics()
    }
}
