//! Ghosts several cutoffs deep: a rank moves them itself, and is silent for an epoch of several
//! steps.

mod epoch;
mod ghosts;

use common::Config;
use common::soft::{NoStatistics, Particle, Scene, SceneError, Simulation};
use mpi::topology::SimpleCommunicator;
use neighbour_list::Bodies;

use super::domain::{Domain, lists_last};
use crate::Outlook;
use epoch::Epoch;

/// One rank of the job: lab 10's engine on the particles of a strip and on its ghosts, which are
/// particles like any other until the epoch is over.
///
/// Statistics would count a pair on each rank that knows it, so there are none.
pub struct Deep {
    domain: Domain<NoStatistics>,
    epoch: Epoch,
    /// Ids of the ghosts, ascending.
    ghosts: Vec<u32>,
    /// The checkpoint: own particles and ghosts as they were when the epoch began.
    kept: Bodies,
    /// How far any particle may have gone since then, in steps that all ranks confirmed.
    gone: f64,
    /// The facts by which all ranks plan the next epoch.
    outlook: Outlook,
    /// Epochs in which all ranks rolled back, since the scene was loaded.
    taken_again: u64,
}

impl Deep {
    /// An engine without particles.
    pub fn new(world: SimpleCommunicator, config: &Config) -> Self {
        Self {
            domain: Domain::new(world, config),
            epoch: Epoch::default(),
            ghosts: Vec::new(),
            kept: Bodies::default(),
            gone: 0.0,
            outlook: Outlook { fastest: 0.0, height: 1.0, particles: 1.0, most: 1 },
            taken_again: 0,
        }
    }

    /// Begins with the particles that the domain was loaded with.
    fn begin(&mut self) {
        self.epoch = Epoch::default();
        self.ghosts.clear();
        self.gone = 0.0;
        // No rank has a list yet that tells how long it lasts. For one step no speed matters.
        let height = self.domain.height();
        self.outlook = Outlook { fastest: 0.0, height, particles: 1.0, most: 1 };
        self.taken_again = 0;
    }
}

impl Simulation for Deep {
    fn load(&mut self, scene: &Scene) {
        self.domain.load(scene);
        self.begin();
    }

    fn load_official(&mut self, n: u64, seed: u32) -> Result<(), SceneError> {
        self.domain.load_official(n, seed)?;
        self.begin();
        Ok(())
    }

    fn load_counter(&mut self, n: u64, seed: u32) -> Result<(), SceneError> {
        self.domain.load_counter(n, seed)?;
        self.begin();
        Ok(())
    }

    fn step(&mut self) {
        self.run(1);
    }

    fn run(&mut self, steps: u64) {
        (0..steps).for_each(|_| self.domain.traffic.begin_step());
        self.domain.counts.steps += steps;
        let mut left = steps;
        while left > 0 {
            if self.epoch.is_over() {
                self.begin_epoch();
            }
            let some = left.min(self.epoch.left());
            self.advance(some);
            left -= some;
            // A reader of a run sees confirmed steps only, though the epoch may go on.
            left += self.confirm();
        }
    }

    fn read(&self, first: usize, out: &mut [Particle]) {
        let is_ghost = self.is_ghost();
        self.domain.read(first, out, |place| !is_ghost(&place));
    }

    fn counters(&self) -> Vec<(&'static str, f64)> {
        let mut counters = self.domain.counters("steps per epoch");
        counters.push(("epochs taken again", self.taken_again as f64));
        counters
    }
}
