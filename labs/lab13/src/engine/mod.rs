//! The engine of a rank: its strip, lab 10's engine on the particles in it, and the border.

mod border;
mod renew;

use common::Config;
use common::soft::{
    CUTOFF, CounterParticles, DT, Observer, OfficialParticles, Particle, Scene, SceneError,
    Simulation, Statistics, official_size,
};
use common_mpi::{Traffic, Wire, report_memory};
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;
use solution2::Grid;
use solution5::{gather_at_root, reduce};
use solution6::{Cuts, Replay, keep_share, make_share};
use solution10::{Bodies, Verlet, Workers};

use crate::{Strips, exchange_places, must_renew};
use border::Border;

/// One rank of the job: lab 10's engine on the particles of a strip, and nothing else of the scene
/// but ghosts.
pub struct Distributed<O> {
    world: SimpleCommunicator,
    engine: Verlet<O>,
    rebalance: u64,
    /// Rows that strips are made of.
    grid: Grid,
    strips: Strips,
    border: Border,
    /// How far from a strip its ghosts come.
    width: f64,
    /// How far an own particle may have gone since ghosts were chosen.
    moved: f64,
    /// How far the fastest own particle goes in a step.
    fastest: f64,
    traffic: Traffic,
    counts: Counts,
}

/// What a rank counts since it was loaded.
#[derive(Default)]
struct Counts {
    steps: u64,
    lists: u64,
    /// Times that strips were cut anew.
    cuts: u64,
    /// Sum of the widths of ghosts over all lists.
    widths: f64,
    /// Sum of their numbers.
    ghosts: u64,
}

impl<O: Observer> Distributed<O> {
    /// An engine without particles.
    pub fn new(world: SimpleCommunicator, config: &Config) -> Self {
        Self {
            world,
            engine: Verlet::new(Workers::new(config.threads), config.parameter("skin"), 1),
            rebalance: config.parameter("rebalance") as u64,
            grid: Grid::with_bins_along(1.0, 1),
            strips: Strips { edges: Vec::new() },
            border: Border::default(),
            width: 0.0,
            moved: 0.0,
            fastest: 0.0,
            traffic: Traffic::default(),
            counts: Counts::default(),
        }
    }

    fn rank(&self) -> usize {
        self.world.rank() as usize
    }

    fn ranks(&self) -> usize {
        self.world.size() as usize
    }

    /// Starts over from a scene of `n` particles in a box of side `size`.
    fn start(&mut self, n: usize, size: f64, replay: Replay) {
        let grid = Grid::new(size, CUTOFF, n);
        let (cuts, share) = keep_share(&grid, self.ranks(), self.rank(), replay);
        self.begin(grid, &cuts, &share);
    }

    /// Starts over with this rank's share of a scene.
    fn begin(&mut self, grid: Grid, cuts: &Cuts, share: &[Particle]) {
        let mut bodies = Bodies::default();
        share.iter().for_each(|particle| bodies.push(*particle));
        self.fastest = bodies.fastest() * DT;
        self.engine.start(bodies, grid.size());
        (self.grid, self.strips) = (grid, Strips::of(&grid, cuts));
        self.border = Border::default();
        // There are no ghosts yet.
        (self.width, self.moved) = (0.0, f64::INFINITY);
        self.traffic = Traffic::default();
        self.counts = Counts::default();
    }

    fn count_reduction<T>(&mut self, items: &[T]) {
        if self.ranks() > 1 {
            self.traffic.sent(items);
        }
    }
}

impl<O: Observer> Simulation for Distributed<O> {
    fn load(&mut self, scene: &Scene) {
        let replay =
            |keep: &mut dyn FnMut(Particle)| scene.particles().iter().for_each(|p| keep(*p));
        self.start(scene.len(), scene.size(), &replay);
    }

    fn load_official(&mut self, n: u64, seed: u32) -> Result<(), SceneError> {
        let generator = OfficialParticles::new(n, seed)?;
        let n = n as usize;
        let replay = |keep: &mut dyn FnMut(Particle)| generator.clone().for_each(keep);
        self.start(n, official_size(n), &replay);
        Ok(())
    }

    fn load_counter(&mut self, n: u64, seed: u32) -> Result<(), SceneError> {
        let scene = CounterParticles::new(n, seed)?;
        let grid = Grid::new(scene.size(), CUTOFF, scene.count());
        let (cuts, share) = make_share(&grid, self.ranks(), self.rank(), &scene);
        self.begin(grid, &cuts, &share);
        Ok(())
    }

    fn step(&mut self) {
        self.traffic.begin_step();
        self.counts.steps += 1;
        *self.engine.observer_mut() = O::default();
        self.count_reduction(&[0_i32]);
        if must_renew(&self.world, self.engine.is_worn_out(), self.moved, self.width) {
            self.renew();
        }
        let Self { world, engine, border, traffic, .. } = self;
        border.pack(engine.bodies());
        border.sent.iter().for_each(|places| traffic.sent(places));
        let mut step = engine.begin(&border.pushed);
        let Border { partners, sent, received, .. } = border;
        exchange_places(world, partners, sent, received, || step.move_inner());
        let mut observer = O::default();
        step.move_outer(border.pushes(&mut observer));
        engine.observer_mut().merge(&observer);
        self.fastest = engine.end();
        // A place is rounded at each step.
        self.moved += self.fastest + f64::EPSILON * self.grid.size();
    }

    fn read(&self, first: usize, out: &mut [Particle]) {
        let wanted = first..first + out.len();
        let bodies = self.engine.bodies();
        let inside = (0..bodies.len()).filter(|&i| wanted.contains(&(bodies.id[i] as usize)));
        let own: Vec<Wire> = inside.map(|i| Wire::from(&bodies.get(i))).collect();
        for wire in gather_at_root(&self.world, &own).iter().flatten() {
            out[wire.id as usize - first] = wire.into();
        }
    }

    fn statistics(&self) -> Option<Statistics> {
        reduce(&self.world, &self.engine.statistics()?)
    }

    fn counters(&self) -> Vec<(&'static str, f64)> {
        let mut counters = self.traffic.report(&self.world);
        counters.extend(report_memory(&self.world));
        let Counts { steps, lists, cuts, widths, ghosts } = &self.counts;
        let lists = (*lists).max(1) as f64;
        counters.extend([
            ("steps per list", *steps as f64 / lists),
            ("mean width of ghosts [cutoffs]", widths / lists / CUTOFF),
            ("mean number of ghosts, rank 0", *ghosts as f64 / lists),
            ("times the strips were cut anew", *cuts as f64),
        ]);
        counters
    }
}
