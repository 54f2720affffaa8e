//! Bins that are cleared and filled again in every step.

use common::Vec2;
use common::soft::{Observer, Particle, Scene, Simulation, Statistics};
use solution1::advance;

use crate::VecBins;

/// The rebuilding engine, the first version that works (CS267 report, section 3.1.1).
///
/// The particles stay in id order, and the bins contain copies that live for one step. Therefore two
/// particles that are close in the box are far apart in memory.
///
/// Results are repeatable, because neighbours are summed bin by bin.
#[derive(Default)]
pub struct Rebuild<O> {
    bin_size: f64,
    particles: Vec<Particle>,
    accelerations: Vec<Vec2>,
    bins: VecBins,
    observer: O,
}

impl<O: Observer> Rebuild<O> {
    /// Makes an engine with bins at least `bin_size` cutoffs wide.
    pub fn new(bin_size: f64) -> Self {
        Self { bin_size, ..Self::default() }
    }
}

impl<O: Observer> Simulation for Rebuild<O> {
    fn load(&mut self, scene: &Scene) {
        self.particles = scene.particles().to_vec();
        self.accelerations = vec![Vec2::ZERO; scene.len()];
        self.bins = VecBins::of_scene(scene, self.bin_size);
        self.observer = O::default();
    }

    fn step(&mut self) {
        self.observer = O::default();
        self.bins.refill(&self.particles);
        for (particle, a) in self.particles.iter().zip(&mut self.accelerations) {
            *a = self.bins.acceleration(particle, &mut self.observer);
        }
        for (particle, a) in self.particles.iter_mut().zip(&self.accelerations) {
            advance(particle, *a, self.bins.grid().size());
        }
    }

    fn read(&self, first: usize, out: &mut [Particle]) {
        out.copy_from_slice(&self.particles[first..first + out.len()]);
    }

    fn statistics(&self) -> Option<Statistics> {
        self.observer.statistics()
    }
}
