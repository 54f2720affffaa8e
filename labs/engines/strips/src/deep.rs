//! The engine with deep ghosts: a rank moves its ghosts itself, and sends nothing for several
//! steps.
//!
//! A drawing of epochs is in [`epoch`](crate::epoch).

use std::marker::PhantomData;

use common::Config;
use common::soft::{NoStatistics, Particle, Scene, SceneError, Simulation};
use mpi::topology::SimpleCommunicator;
use neighbour_list::Bodies;

use crate::deep_halo::{DeepHalo, Outlook};
use crate::domain::Domain;

/// One rank of the job: the engine of a neighbour list on the particles of a strip and on its
/// ghosts.
///
/// Until the epoch is over, the engine treats ghosts like all other particles. There are no
/// statistics, because a pair would be counted on every rank that has both particles.
// ANCHOR: deep
pub struct Deep<T> {
    pub(crate) domain: Domain<NoStatistics>,
    pub(crate) epoch: Epoch,
    /// Ids of the ghosts, ascending.
    pub(crate) ghosts: Vec<u32>,
    /// The checkpoint: own particles and ghosts at the beginning of the epoch.
    pub(crate) kept: Bodies,
    /// The greatest distance that a particle may have gone since the checkpoint, in confirmed
    /// steps.
    pub(crate) gone: f64,
    /// The facts that all ranks use to plan the next epoch.
    pub(crate) outlook: Outlook,
    /// Number of epochs that ended with a rollback, since the scene was loaded.
    pub(crate) taken_again: u64,
    asks: PhantomData<T>,
}
// ANCHOR_END: deep

/// An epoch: the steps that ghosts were chosen for.
#[derive(Default)]
pub(crate) struct Epoch {
    /// Number of steps of the epoch; 0 when the epoch is over.
    pub(crate) planned: usize,
    /// Depth of the ghosts; a length.
    pub(crate) width: f64,
    /// The greatest distance that a particle of this rank went, for each step that was taken.
    pub(crate) moves: Vec<f64>,
    /// The [`wear`](Domain::wear) of this rank's list in a step, and the number of its own
    /// particles.
    pub(crate) own: [f64; 2],
}

impl Epoch {
    fn is_over(&self) -> bool {
        self.planned == 0
    }

    /// Returns the number of steps that have not been taken yet.
    fn left(&self) -> u64 {
        (self.planned - self.moves.len()) as u64
    }
}

impl<T: DeepHalo> Deep<T> {
    /// Makes an engine without particles.
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

    /// Begins with the particles that the domain has loaded.
    fn begin(&mut self) {
        self.epoch = Epoch::default();
        self.ghosts.clear();
        self.gone = 0.0;
        // No rank has a list yet, so the life of a list is unknown. An epoch of one step is right
        // at any speed.
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
            // After a run only confirmed steps can be read, even if the epoch continues.
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
