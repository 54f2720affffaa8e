//! Task 2.5: only the particles that changed their bins are moved.

use common::Vec2;
use common::soft::{Observer, Particle, Scene, Simulation, Statistics, read_by_id};
use solution1::advance;

use crate::{Grid, VecBins};

/// Moves the particles that have left bin `bin` of `grid` from its list `inside` to `changed`.
///
/// The other particles stay in `inside`, in any order.
///
/// Closing the gap of a removed particle would move all particles after the gap.
/// [`Vec::swap_remove`] moves only the last particle, into the gap. Remember that the moved particle
/// has not been checked yet.
///
/// Book: chapter 2, *Incremental*.
#[inline]
pub fn take_leavers(
    grid: &Grid,
    bin: usize,
    inside: &mut Vec<Particle>,
    changed: &mut Vec<Particle>,
) {
    todo!("task 2.5: take out the leavers, by swap-remove")
}

/// The incremental engine: the bins own the particles, and a particle that has left its bin is moved
/// to its new bin (CSC581 report, section 3.3; CS267 report, section 3.1.2).
///
/// In a time step of the official scene, one particle in forty crosses an edge of these bins.
/// Neighbours in the box stay close in memory: they are in the list of one bin or of adjacent bins.
///
/// Results are repeatable, because neighbours are summed bin by bin. The order of the particles in a
/// bin depends on which particles came and went.
#[derive(Default)]
pub struct Incremental<O> {
    bin_size: f64,
    bins: VecBins,
    /// The accelerations, in the order of the particles in the bins.
    accelerations: Vec<Vec2>,
    changed: Vec<Particle>,
    observer: O,
}

impl<O: Observer> Incremental<O> {
    /// Makes an engine with bins at least `bin_size` cutoffs wide.
    pub fn new(bin_size: f64) -> Self {
        Self { bin_size, ..Self::default() }
    }

    fn sum_forces(&mut self) {
        self.accelerations.clear();
        for bin in &self.bins {
            for particle in bin {
                self.accelerations.push(self.bins.acceleration(particle, &mut self.observer));
            }
        }
    }

    fn move_particles(&mut self) {
        let size = self.bins.grid().size();
        let mut accelerations = self.accelerations.iter();
        for bin in self.bins.bins_mut() {
            for (particle, a) in bin.iter_mut().zip(&mut accelerations) {
                advance(particle, *a, size);
            }
        }
    }

    fn rebin(&mut self) {
        let grid = *self.bins.grid();
        for (bin, inside) in self.bins.bins_mut().iter_mut().enumerate() {
            take_leavers(&grid, bin, inside, &mut self.changed);
        }
        for particle in self.changed.drain(..) {
            self.bins.put(particle);
        }
    }
}

impl<O: Observer> Simulation for Incremental<O> {
    fn load(&mut self, scene: &Scene) {
        self.bins = VecBins::of_scene(scene, self.bin_size);
        self.bins.refill(scene.particles());
        self.observer = O::default();
    }

    fn step(&mut self) {
        self.observer = O::default();
        self.sum_forces();
        self.move_particles();
        self.rebin();
    }

    fn read(&self, first: usize, out: &mut [Particle]) {
        read_by_id(self.bins.particles(), first, out);
    }

    fn statistics(&self) -> Option<Statistics> {
        self.observer.statistics()
    }
}
