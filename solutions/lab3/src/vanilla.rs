//! Task 3.1: all pairs by several threads.

use common::Vec2;
use common::soft::{Observer, Particle, Scene, Simulation, Statistics};
use rayon::ThreadPool;
use rayon::prelude::*;
use solution1::{add_pair, advance};

use crate::team;

/// Lab 1's program with its two loops run in parallel, as the vanilla OpenMP program of CS267
/// does (report, figure 8). It scales, and it is still slower than one thread with bins.
pub struct Vanilla<O> {
    team: ThreadPool,
    size: f64,
    particles: Vec<Particle>,
    accelerations: Vec<Vec2>,
    observer: O,
}

impl<O: Observer> Vanilla<O> {
    /// An engine for `threads` threads.
    pub fn new(threads: usize) -> Self {
        Self {
            team: team(threads),
            size: 0.0,
            particles: Vec::new(),
            accelerations: Vec::new(),
            observer: O::default(),
        }
    }

    /// Sums into `accelerations[i]` what all particles do to particle i, in ascending order as in
    /// lab 1, the particles shared among the threads of the team.
    ///
    /// Each thread reads all particles and writes accelerations that nobody else touches: the
    /// borrow checker agrees at once (`par_iter_mut` on the accelerations, zipped with the
    /// particles). The observer is another matter. Give every particle one of its own, and merge
    /// them afterwards in the order of particles, so that the sum of distances is the same in
    /// every run: collect into a `Vec` first, since a parallel reduction adds in any order.
    ///
    /// Book: chapter 3, *The quick win*.
    fn sum_forces(&mut self) {
        let Self { team, particles, accelerations, observer, .. } = self;
        // task 3.1: all pairs by several threads
        let observers: Vec<O> = team.install(|| {
            particles
                .par_iter()
                .zip(accelerations)
                .map(|(particle, a)| {
                    let mut observer = O::default();
                    *a = Vec2::ZERO;
                    for neighbour in &*particles {
                        add_pair(a, particle.to(neighbour), &mut observer);
                    }
                    observer.tested(particles.len() as u64);
                    observer
                })
                .collect()
        });
        for seen in &observers {
            observer.merge(seen);
        }
        // end 3.1
    }
}

impl<O: Observer> Simulation for Vanilla<O> {
    fn load(&mut self, scene: &Scene) {
        self.size = scene.size();
        self.particles = scene.particles().to_vec();
        self.accelerations = vec![Vec2::ZERO; scene.len()];
        self.observer = O::default();
    }

    fn step(&mut self) {
        self.observer = O::default();
        self.sum_forces();
        let Self { team, particles, accelerations, size, .. } = self;
        team.install(|| {
            let moves = particles.par_iter_mut().zip(accelerations);
            moves.for_each(|(particle, a)| advance(particle, *a, *size));
        });
    }

    fn read(&self, first: usize, out: &mut [Particle]) {
        out.copy_from_slice(&self.particles[first..first + out.len()]);
    }

    fn statistics(&self) -> Option<Statistics> {
        self.observer.statistics()
    }
}
