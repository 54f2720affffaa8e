//! Task 3.1: all pairs by several threads.

use common::Vec2;
use common::soft::{Observer, Particle, Scene, Simulation, Statistics, merged};
use rayon::ThreadPool;
use rayon::prelude::*;
use solution1::{add_pair, advance};

use crate::pool;

/// Lab 1's program with two parallel loops, like the vanilla OpenMP program of CS267.
///
/// The program scales, but it is still slower than a program with bins on one thread (report,
/// figure 8).
pub struct Vanilla<O> {
    pool: ThreadPool,
    size: f64,
    particles: Vec<Particle>,
    /// The acceleration of each particle.
    accelerations: Vec<Vec2>,
    /// The observer of each particle, which has seen the particle's pairs.
    seen: Vec<O>,
}

impl<O: Observer> Vanilla<O> {
    /// Makes an engine for `threads` threads.
    pub fn new(threads: usize) -> Self {
        Self {
            pool: pool(threads),
            size: 0.0,
            particles: Vec::new(),
            accelerations: Vec::new(),
            seen: Vec::new(),
        }
    }

    /// Loads the scene.
    pub fn load(&mut self, scene: &Scene) {
        self.size = scene.size();
        self.particles = scene.particles().to_vec();
        self.accelerations = vec![Vec2::ZERO; scene.len()];
        self.seen = vec![O::default(); scene.len()];
    }

    /// Writes the acceleration of each particle i to `accelerations[i]`, in parallel.
    ///
    /// - The particles are divided among the threads of `pool`.
    /// - As in lab 1, the acceleration of particle i is the sum over all particles, in ascending
    ///   order.
    /// - `seen[i]` becomes a new observer in each step. Report the pairs of particle i to this
    ///   observer, and report all particles as tested.
    ///
    /// Book: chapter 3, *The quick win*.
    pub fn sum_forces(&mut self) {
        let Self { pool, particles, accelerations, seen, .. } = self;
        todo!("task 3.1: all pairs by several threads")
    }
}

impl<O: Observer> Simulation for Vanilla<O> {
    fn load(&mut self, scene: &Scene) {
        self.load(scene);
    }

    fn step(&mut self) {
        self.sum_forces();
        let Self { pool, particles, accelerations, size, .. } = self;
        pool.install(|| {
            let moves = particles.par_iter_mut().zip(accelerations);
            moves.for_each(|(particle, a)| advance(particle, *a, *size));
        });
    }

    fn read(&self, first: usize, out: &mut [Particle]) {
        out.copy_from_slice(&self.particles[first..first + out.len()]);
    }

    fn statistics(&self) -> Option<Statistics> {
        // Merge in the order of particles, so that the sum does not depend on the threads.
        merged(&self.seen)
    }
}
