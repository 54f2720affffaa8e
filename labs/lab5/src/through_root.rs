//! The engine: a block of rows, and messages through the root.

use std::ops::Range;

use common::soft::{Observer, Particle, Scene, SceneError, Simulation, Statistics};
use common::{Config, Event, Vec2};
use common_mpi::{Clock, Partners, Traffic, Wire, report_memory};
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;
use solution1::advance;
use solution2::{BIN_SIZE, Gather, Grid, VecBins, take_leavers};

use crate::border::own;
use crate::{
    Cut, Parcel, ROOT, border_copies, broadcast, gather_at_root, read_at_root, reduce,
    replace_ghosts, scatter_from_root, sort_by_receiver, take_leavers_of_block,
};

/// The engine on one rank of the job.
///
/// Its bins cover the whole box, like the bins of a serial program. Only the rows of its block, and
/// a row of ghosts on either side, contain particles.
pub struct ThroughRoot<O> {
    world: SimpleCommunicator,
    bin_size: f64,
    cut: Cut,
    block: Range<usize>,
    bins: VecBins,
    /// The accelerations of the rank's particles, in the order of the bins.
    accelerations: Vec<Vec2>,
    changed: Vec<Particle>,
    remote: Vec<Particle>,
    gather: Gather,
    observer: O,
    traffic: Traffic,
    clock: Clock,
}

impl<O: Observer> ThroughRoot<O> {
    /// Makes an engine on the ranks of `world`. `config` contains the least side of a bin, in cutoffs.
    pub fn new(world: SimpleCommunicator, config: &Config) -> Self {
        let cut = Cut { rows: 1, ranks: world.size() as usize };
        Self {
            world,
            bin_size: config.parameter(BIN_SIZE),
            cut,
            block: 0..0,
            bins: VecBins::default(),
            accelerations: Vec::new(),
            changed: Vec::new(),
            remote: Vec::new(),
            gather: Gather::default(),
            observer: O::default(),
            traffic: Traffic::default(),
            clock: Clock::new(config.events),
        }
    }

    /// Starts over with the root's scene.
    fn start(&mut self, scene: Option<&Scene>) {
        let (size, particles) = broadcast(&self.world, scene);
        let grid = Grid::new(size, self.bin_size * common::soft::CUTOFF, particles.len());
        self.cut = Cut { rows: grid.rows(), ranks: self.world.size() as usize };
        self.block = self.cut.block(self.world.rank() as usize);
        self.bins = VecBins::new(grid);
        let ghosts = self.block.start.saturating_sub(1)..(self.block.end + 1).min(grid.rows());
        let visible = if self.block.is_empty() { 0..0 } else { ghosts };
        for particle in particles {
            if visible.contains(&grid.row(particle.y)) {
                self.bins.put(particle);
            }
        }
        self.observer = O::default();
        self.traffic = Traffic::default();
        self.clock.start(&self.world);
    }

    /// Sums the forces on the rank's particles. Ghosts serve only as neighbours.
    fn sum_forces(&mut self) {
        self.accelerations.clear();
        for particle in own(&self.bins, &self.block) {
            let around = self.bins.around(particle);
            let a = self.gather.acceleration(particle, around, &mut self.observer);
            self.accelerations.push(a);
        }
    }

    /// Moves the rank's particles, and takes from each bin the particles that left it.
    fn move_particles(&mut self) {
        let grid = *self.bins.grid();
        let bins = self.block.start * grid.columns()..self.block.end * grid.columns();
        let mut accelerations = self.accelerations.iter();
        for (number, bin) in bins.clone().zip(&mut self.bins.bins_mut()[bins]) {
            for (particle, a) in bin.iter_mut().zip(&mut accelerations) {
                advance(particle, *a, grid.size());
            }
            take_leavers(&grid, number, bin, &mut self.changed);
        }
    }

    /// Puts every particle that changed its bin into the new bin, and renews all ghosts.
    ///
    /// The new bin may be on any rank. At first, `self.changed` contains the particles that changed
    /// their bin, which are no longer in their old bins, and `self.remote` is empty. Leave both
    /// lists empty for the next step. Proceed in this order:
    ///
    /// 1. Separate local and remote particles ([`take_leavers_of_block`]). Put the local particles
    ///    into their bins ([`VecBins::put`]).
    /// 2. Copy the border rows ([`border_copies`]), which now contain the local particles again.
    /// 3. Gather the remote particles and the copies, with one call of [`Self::gather`] each. The
    ///    order of the two calls must be the same on all ranks.
    /// 4. On the root, make a [`Parcel`] of the two lists of each rank, and sort the parcels
    ///    ([`sort_by_receiver`]).
    /// 5. Scatter the lists ([`Self::scatter`]), and put the particles that arrive into the bins
    ///    ([`replace_ghosts`]).
    ///
    /// All ranks call this together, even ranks with an empty block.
    ///
    /// Book: chapter 5, *A step*.
    fn exchange(&mut self) {
        let grid = *self.bins.grid();
        todo!("task 5.8b: a whole step")
    }

    /// Calls [`gather_at_root`], timed and counted.
    ///
    /// Each rank except the root sends a number and a list.
    fn gather(&mut self, items: &[Wire]) -> Vec<Vec<Wire>> {
        if self.world.rank() != ROOT {
            self.traffic.sent(&[0_i32]);
            self.traffic.sent(items);
        }
        self.clock.call(Partners::Through(ROOT), || gather_at_root(&self.world, items))
    }

    /// Calls [`scatter_from_root`], timed and counted.
    ///
    /// The root sends a number and a list to each other rank.
    fn scatter(&mut self, lists: &[Vec<Wire>]) -> Vec<Wire> {
        if self.world.rank() == ROOT {
            for list in &lists[1..] {
                self.traffic.sent(&[0_i32]);
                self.traffic.sent(list);
            }
        }
        self.clock.call(Partners::Through(ROOT), || scatter_from_root(&self.world, lists))
    }
}

impl<O: Observer> Simulation for ThroughRoot<O> {
    fn load(&mut self, scene: &Scene) {
        let root = self.world.rank() == ROOT;
        self.start(Some(scene).filter(|_| root));
    }

    fn load_official(&mut self, n: u64, seed: u32) -> Result<(), SceneError> {
        let root = self.world.rank() == ROOT;
        let scene = if root { Some(Scene::official(n, seed)?) } else { None };
        self.start(scene.as_ref());
        Ok(())
    }

    fn load_counter(&mut self, n: u64, seed: u32) -> Result<(), SceneError> {
        let root = self.world.rank() == ROOT;
        let scene = if root { Some(Scene::counter(n, seed)?) } else { None };
        self.start(scene.as_ref());
        Ok(())
    }

    fn step(&mut self) {
        self.observer = O::default();
        self.traffic.begin_step();
        self.clock.begin_step();
        self.sum_forces();
        self.move_particles();
        self.exchange();
        self.clock.end_step();
    }

    fn read(&self, first: usize, out: &mut [Particle]) {
        let own = own(&self.bins, &self.block).map(Wire::from);
        read_at_root(&self.world, own, first, out);
    }

    fn statistics(&self) -> Option<Statistics> {
        reduce(&self.world, &self.observer.statistics()?)
    }

    fn counters(&self) -> Vec<(&'static str, f64)> {
        let mut counters = self.traffic.report(&self.world);
        counters.extend(report_memory(&self.world));
        counters.extend(self.clock.report(&self.world));
        counters
    }

    fn events(&self) -> Option<Vec<Event>> {
        self.clock.events(&self.world)
    }
}
