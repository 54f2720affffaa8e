//! The parts of a rank that both engines share: its strip, and the neighbour-list engine on its
//! particles.

use common::Config;
use common::soft::{
    CUTOFF, CounterParticles, DT, Observer, OfficialParticles, Particle, Scene, SceneError,
    official_size,
};
use common_mpi::{Traffic, Wire, report_memory};
use halo::{Cuts, Replay, make_share};
use mpi::collective::SystemOperation;
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;
use neighbour_list::{Bodies, NeighbourList, Workers};
use solution2::Grid;
use solution5::read_at_root;
use solution6::{Lab6, keep_share};

use crate::partition::Strips;

/// Greatest number of steps that a list is expected to last.
const LONGEST: f64 = 200.0;

/// A rank's part of the job.
// ANCHOR: domain
pub(crate) struct Domain<O> {
    pub(crate) world: SimpleCommunicator,
    pub(crate) engine: NeighbourList<O>,
    pub(crate) rebalance: u64,
    /// The rows that strips are made of.
    pub(crate) grid: Grid,
    pub(crate) strips: Strips,
    pub(crate) traffic: Traffic,
    pub(crate) counts: Counts,
}
// ANCHOR_END: domain

/// A rank's counters since the scene was loaded.
#[derive(Default)]
pub(crate) struct Counts {
    pub(crate) steps: u64,
    /// Number of times that ghosts were chosen.
    pub(crate) choices: u64,
    /// Number of times that strips were cut again.
    pub(crate) cuts: u64,
    /// Sum of the widths of ghosts over all choices.
    pub(crate) widths: f64,
    /// Total number of ghosts over all choices.
    pub(crate) ghosts: u64,
}

/// Returns the number of steps that all lists should last.
///
/// `wear` is the greatest [`wear`](Domain::wear) among all ranks.
pub(crate) fn lists_last(wear: f64) -> u32 {
    (1.0 / wear).clamp(1.0, LONGEST).round() as u32
}

impl<O: Observer> Domain<O> {
    /// Makes a rank without particles.
    pub(crate) fn new(world: SimpleCommunicator, config: &Config) -> Self {
        Self {
            world,
            engine: NeighbourList::new(
                Workers::if_possible(config.threads),
                config.parameter("skin"),
                1,
            ),
            rebalance: config.parameter("rebalance") as u64,
            grid: Grid::default(),
            strips: Strips { edges: Vec::new() },
            traffic: Traffic::default(),
            counts: Counts::default(),
        }
    }

    pub(crate) fn rank(&self) -> usize {
        self.world.rank() as usize
    }

    pub(crate) fn ranks(&self) -> usize {
        self.world.size() as usize
    }

    /// Starts from a scene that every rank has.
    pub(crate) fn load(&mut self, scene: &Scene) {
        self.start(scene.len(), scene.size(), &|keep| {
            scene.particles().iter().for_each(|particle| keep(*particle));
        });
    }

    /// Starts from the official scene. No rank stores more than its share of the particles.
    pub(crate) fn load_official(&mut self, n: u64, seed: u32) -> Result<(), SceneError> {
        let generator = OfficialParticles::new(n, seed)?;
        let n = n as usize;
        self.start(n, official_size(n), &|keep| generator.clone().for_each(keep));
        Ok(())
    }

    /// Starts from the counter scene. No rank makes more than its share of the particles.
    pub(crate) fn load_counter(&mut self, n: u64, seed: u32) -> Result<(), SceneError> {
        let scene = CounterParticles::new(n, seed)?;
        let grid = Grid::new(scene.size(), CUTOFF, scene.count());
        let (cuts, share) = make_share::<Lab6>(&grid, self.ranks(), self.rank(), &scene);
        self.begin(grid, &cuts, &share);
        Ok(())
    }

    /// Starts from a scene of `n` particles in a box of side `size`.
    fn start(&mut self, n: usize, size: f64, replay: Replay<'_>) {
        let grid = Grid::new(size, CUTOFF, n);
        let (cuts, share) = keep_share(&grid, self.ranks(), self.rank(), replay);
        self.begin(grid, &cuts, &share);
    }

    /// Starts from this rank's share of a scene.
    fn begin(&mut self, grid: Grid, cuts: &Cuts, share: &[Particle]) {
        let mut bodies = Bodies::default();
        share.iter().for_each(|particle| bodies.push(*particle));
        self.engine.start(bodies, grid.size());
        self.grid = grid;
        self.strips = Strips::of(&grid, cuts);
        self.traffic = Traffic::default();
        self.counts = Counts::default();
    }

    /// Returns the distance that the fastest particle moves in a step at its current speed.
    pub(crate) fn fastest(&self) -> f64 {
        self.engine.bodies().fastest() * DT
    }

    /// Returns the share of the list's life that a step uses up, at the speeds that the list was
    /// made for.
    ///
    /// The share is 0 on a rank without particles.
    pub(crate) fn wear(&self) -> f64 {
        if self.engine.bodies().is_empty() {
            return 0.0;
        }
        let skin = self.engine.list().budget.skin;
        1.0 / ((0.5 * skin / self.engine.limits().displacement()).floor() + 1.0)
    }

    /// Returns the greatest rounding error of a position in a step.
    pub(crate) fn rounding(&self) -> f64 {
        f64::EPSILON * self.grid.size()
    }

    /// Returns slightly more than `width`, because rounded positions must not hide a pair.
    pub(crate) fn reach(&self, width: f64) -> f64 {
        width * (1.0 + 1e-9) + 1e-15 * self.grid.size()
    }

    /// Returns the mean height of a strip.
    pub(crate) fn height(&self) -> f64 {
        self.grid.size() / self.ranks() as f64
    }

    /// Counts a choice of `ghosts` ghosts, up to the distance `width` from the strip.
    pub(crate) fn count_choice(&mut self, width: f64, ghosts: usize) {
        self.counts.choices += 1;
        self.counts.widths += width;
        self.counts.ghosts += ghosts as u64;
    }

    pub(crate) fn count_reduction<T>(&mut self, items: &[T]) {
        if self.ranks() > 1 {
            self.traffic.sent(items);
        }
    }

    /// Returns the greatest value of each number over all ranks.
    pub(crate) fn greatest<const N: usize>(&mut self, own: [f64; N]) -> [f64; N] {
        let mut all = own;
        self.count_reduction(&own);
        self.world.all_reduce_into(&own[..], &mut all[..], SystemOperation::max());
        all
    }

    /// Returns the sum of each number over all ranks.
    pub(crate) fn sum(&mut self, own: &[u64]) -> Vec<u64> {
        let mut all = vec![0; own.len()];
        self.count_reduction(own);
        self.world.all_reduce_into(own, &mut all[..], SystemOperation::sum());
        all
    }

    /// Collects the particles with ids `first .. first + out.len()` in the root's `out`.
    ///
    /// `is_own` returns whether the particle at an index of the engine is this rank's own.
    pub(crate) fn read(&self, first: usize, out: &mut [Particle], is_own: impl Fn(usize) -> bool) {
        let bodies = self.engine.bodies();
        let own = (0..bodies.len()).filter(|&i| is_own(i)).map(|i| Wire::from(&bodies.get(i)));
        read_at_root(&self.world, own, first, out);
    }

    /// Returns the counters with their names. `choice` is the name for the number of steps that
    /// ghosts last.
    pub(crate) fn counters(&self, choice: &'static str) -> Vec<(&'static str, f64)> {
        let mut counters = self.traffic.report(&self.world);
        counters.extend(report_memory(&self.world));
        let Counts { steps, choices, cuts, widths, ghosts } = &self.counts;
        let choices = (*choices).max(1) as f64;
        counters.extend([
            (choice, *steps as f64 / choices),
            ("mean width of ghosts [cutoffs]", widths / choices / CUTOFF),
            ("mean number of ghosts, rank 0", *ghosts as f64 / choices),
            ("times the strips were cut again", *cuts as f64),
        ]);
        counters
    }
}
