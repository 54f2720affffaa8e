//! The reference engine for the later labs.

use common::Vec2;
use common::soft::{Observer, Particle, Scene, Simulation, Statistics, read_by_id};
use solution1::advance;

use crate::{Gather, Grid, SortedBins};

/// The sorting engine: the particles are in memory in the order of their bins, and are sorted again after
/// each step.
///
/// It gives the bits of all-pairs on any scene, because [`Gather`] sums in ascending order of ids.
#[derive(Default)]
pub struct Sorted<O> {
    bin_size: f64,
    bins: SortedBins,
    /// The accelerations, in the order of the particles in the bins.
    accelerations: Vec<Vec2>,
    gather: Gather,
    observer: O,
}

impl<O: Observer> Sorted<O> {
    /// Makes an engine with bins at least `bin_size` cutoffs wide.
    pub fn new(bin_size: f64) -> Self {
        Self { bin_size, ..Self::default() }
    }
}

impl<O: Observer> Simulation for Sorted<O> {
    fn load(&mut self, scene: &Scene) {
        let grid = Grid::of_scene(scene, self.bin_size);
        self.bins = SortedBins::new(grid, 0..grid.rows());
        self.bins.refill(scene.particles().iter().copied());
        self.accelerations = vec![Vec2::ZERO; scene.len()];
        self.observer = O::default();
    }

    fn step(&mut self) {
        self.observer = O::default();
        let rows = self.bins.rows();
        self.bins.gather_rows(rows, &mut self.accelerations, &mut self.gather, &mut self.observer);
        let size = self.bins.grid().size();
        for (particle, a) in self.bins.particles_mut().iter_mut().zip(&self.accelerations) {
            advance(particle, *a, size);
        }
        self.bins.sort();
    }

    fn read(&self, first: usize, out: &mut [Particle]) {
        read_by_id(self.bins.particles(), first, out);
    }

    fn statistics(&self) -> Option<Statistics> {
        self.observer.statistics()
    }
}
