//! The engine of a rank: a block of rows, and ghosts from the neighbours.
//!
//! `forces` exchanges ghosts and sums forces; `migrate` moves particles to other ranks and balances
//! the blocks.

use std::marker::PhantomData;
use std::ops::Range;

use common::soft::{
    CUTOFF, CounterParticles, Observer, OfficialParticles, Particle, Scene, SceneError, Simulation,
    Statistics, official_size,
};
use common::{Config, Event, Vec2};
use common_mpi::{Clock, Traffic, Wire, report_memory};
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;
use solution2::{BIN_SIZE, Grid, SortedBins};
use solution5::{read_at_root, reduce};
use workers::Workers;

use crate::{Blocks, Cuts, Messages, Replay, Route, make_share};

/// One rank of the job: the particles of its block of rows and nothing else of the scene.
// ANCHOR: engine
pub struct Halo<O, T> {
    pub(crate) world: SimpleCommunicator,
    bin_size: f64,
    pub(crate) workers: Workers,
    rebalance: u64,
    remainder_last: bool,
    pub(crate) route: Route,
    pub(crate) n: usize,
    pub(crate) cuts: Cuts,
    pub(crate) block: Range<usize>,
    /// The particles of the block.
    pub(crate) own: SortedBins,
    /// Copies of the particles in the row before the block and in the row after it.
    pub(crate) ghosts: [SortedBins; 2],
    /// Accelerations of `own`'s particles, in the same order.
    pub(crate) accelerations: Vec<Vec2>,
    pub(crate) observer: O,
    pub(crate) traffic: Traffic,
    pub(crate) clock: Clock,
    steps: u64,
    pub(crate) recuts: u64,
    asks: PhantomData<T>,
}
// ANCHOR_END: engine

impl<O: Observer, T: Blocks + Messages> Halo<O, T> {
    /// Makes an engine that sends its messages along `route` and divides its loops among `workers`.
    pub fn new(world: SimpleCommunicator, config: &Config, workers: Workers, route: Route) -> Self {
        let remainder_last = config.parameter("remainder-last") > 0.0;
        Self {
            world,
            bin_size: config.parameter(BIN_SIZE),
            workers,
            rebalance: if remainder_last { 0 } else { config.parameter("rebalance") as u64 },
            remainder_last,
            route,
            n: 0,
            cuts: Cuts { starts: Vec::new() },
            block: 0..0,
            own: SortedBins::default(),
            ghosts: Default::default(),
            accelerations: Vec::new(),
            observer: O::default(),
            traffic: Traffic::default(),
            clock: Clock::new(config.events),
            steps: 0,
            recuts: 0,
            asks: PhantomData,
        }
    }

    pub(crate) fn rank(&self) -> usize {
        self.world.rank() as usize
    }

    pub(crate) fn ranks(&self) -> usize {
        self.world.size() as usize
    }

    /// Starts from a scene of `n` particles in a box of side `size`.
    fn start(&mut self, n: usize, size: f64, replay: Replay<'_>) {
        let grid = Grid::new(size, self.bin_size * CUTOFF, n);
        let (cuts, share) = T::keep_share(&grid, self.ranks(), self.rank(), replay);
        self.begin(n, grid, cuts, share);
    }

    /// Starts from this rank's share of a scene of `n` particles.
    fn begin(&mut self, n: usize, grid: Grid, cuts: Cuts, share: Vec<Particle>) {
        self.n = n;
        self.settle(grid, cuts, share);
        if self.remainder_last {
            self.cut_again(Cuts::remainder_last(grid.rows(), self.ranks()));
        }
        self.observer = O::default();
        self.traffic = Traffic::default();
        self.clock.start(&self.world);
        self.steps = 0;
        self.recuts = 0;
    }

    /// Makes bins for this rank's block in `cuts`, and puts `particles` into them.
    pub(crate) fn settle(&mut self, grid: Grid, cuts: Cuts, particles: Vec<Particle>) {
        self.block = cuts.block(self.rank());
        self.cuts = cuts;
        self.own = SortedBins::new(grid, self.block.clone());
        self.own.refill(particles);
        let Range { start, end } = self.block;
        let after = if end < grid.rows() { end..end + 1 } else { end..end };
        self.ghosts = [start.saturating_sub(1)..start, after].map(|row| SortedBins::new(grid, row));
    }
}

impl<O: Observer, T: Blocks + Messages> Simulation for Halo<O, T> {
    fn load(&mut self, scene: &Scene) {
        self.start(scene.len(), scene.size(), &|keep| {
            scene.particles().iter().for_each(|particle| keep(*particle));
        });
    }

    fn load_official(&mut self, n: u64, seed: u32) -> Result<(), SceneError> {
        let generator = OfficialParticles::new(n, seed)?;
        let n = n as usize;
        self.start(n, official_size(n), &|keep| generator.clone().for_each(keep));
        Ok(())
    }

    fn load_counter(&mut self, n: u64, seed: u32) -> Result<(), SceneError> {
        let scene = CounterParticles::new(n, seed)?;
        let grid = Grid::new(scene.size(), self.bin_size * CUTOFF, scene.count());
        let (cuts, share) = make_share::<T>(&grid, self.ranks(), self.rank(), &scene);
        self.begin(scene.count(), grid, cuts, share);
        Ok(())
    }

    fn step(&mut self) {
        self.observer = O::default();
        self.traffic.begin_step();
        self.clock.begin_step();
        self.steps += 1;
        self.sum_forces();
        let leavers = self.move_particles();
        self.migrate(leavers);
        if self.rebalance > 0 && self.steps.is_multiple_of(self.rebalance) {
            self.keep_balance();
        }
        self.clock.end_step();
    }

    fn read(&self, first: usize, out: &mut [Particle]) {
        read_at_root(&self.world, self.own.particles().iter().map(Wire::from), first, out);
    }

    fn statistics(&self) -> Option<Statistics> {
        reduce(&self.world, &self.observer.statistics()?)
    }

    fn counters(&self) -> Vec<(&'static str, f64)> {
        let mut counters = self.traffic.report(&self.world);
        counters.extend(report_memory(&self.world));
        counters.push(("times the rows were cut again", self.recuts as f64));
        counters.push(("particles, fullest rank", self.fullest() as f64));
        counters.extend(self.clock.report(&self.world));
        counters
    }

    fn events(&self) -> Option<Vec<Event>> {
        self.clock.events(&self.world)
    }
}
