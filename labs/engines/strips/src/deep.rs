//! Ghosts several cutoffs deep: a rank moves them itself, and is silent for an epoch of several
//! steps.

use std::marker::PhantomData;

use common::Config;
use common::soft::{NoStatistics, Particle, Scene, SceneError, Simulation};
use mpi::topology::SimpleCommunicator;
use neighbour_list::Bodies;

use crate::domain::Domain;
use crate::epoch::Epoch;
use crate::partition::Partition;

/// How deep ghosts are chosen, for how many steps without a message, and whether these steps were right.
pub trait DeepHalo: Partition {
    /// How far from a strip its ghosts come that are moved for `steps` steps without a message, if no particle goes
    /// further than `fastest` in one.
    fn deep_width(fastest: f64, steps: u32) -> f64;

    /// How many steps an epoch should have: from 1 to `outlook.most`.
    fn best_depth(outlook: Outlook) -> u32;

    /// How many of the `steps` steps that all ranks have taken with ghosts `width` deep are right, at least 1 and on
    /// all ranks the same. `said` begins with how far the furthest own particle went in each of them; afterwards each
    /// of its numbers is the greatest that any rank said.
    fn confirm(world: &SimpleCommunicator, said: &mut [f64], steps: usize, width: f64) -> usize;
}

/// The facts on which the cheapest length of an epoch depends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outlook {
    /// How far the fastest particle of all goes in a step.
    pub fastest: f64,
    /// Height of a strip.
    pub height: f64,
    /// Particles of a rank, at least 1.
    pub particles: f64,
    /// Steps that the lists of all ranks last, at least 1. No epoch is longer.
    pub most: u32,
}

/// One rank of the job: the engine of a neighbour list on the particles of a strip and on its ghosts, which are
/// particles like any other until the epoch is over.
///
/// Statistics would count a pair on each rank that knows it, so there are none.
// ANCHOR: deep
pub struct Deep<T> {
    pub(crate) domain: Domain<NoStatistics>,
    pub(crate) epoch: Epoch,
    /// Ids of the ghosts, ascending.
    pub(crate) ghosts: Vec<u32>,
    /// The checkpoint: own particles and ghosts as they were when the epoch began.
    pub(crate) kept: Bodies,
    /// How far any particle may have gone since then, in steps that all ranks confirmed.
    pub(crate) gone: f64,
    /// The facts by which all ranks plan the next epoch.
    pub(crate) outlook: Outlook,
    /// Epochs in which all ranks rolled back, since the scene was loaded.
    pub(crate) taken_again: u64,
    asks: PhantomData<T>,
}
// ANCHOR_END: deep

impl<T: DeepHalo> Deep<T> {
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
            asks: PhantomData,
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

impl<T: DeepHalo> Simulation for Deep<T> {
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

    // ANCHOR: run
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
    // ANCHOR_END: run

    fn read(&self, first: usize, out: &mut [Particle]) {
        let is_ghost = self.is_ghost();
        self.domain.read(first, out, |index| !is_ghost(&index));
    }

    fn counters(&self) -> Vec<(&'static str, f64)> {
        let mut counters = self.domain.counters("steps per epoch");
        counters.push(("epochs taken again", self.taken_again as f64));
        counters
    }
}
