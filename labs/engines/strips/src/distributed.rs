//! Ghosts whose positions are sent in each step.

use std::marker::PhantomData;
use std::ops::Range;

use common::Config;
use common::soft::{Observer, Particle, Scene, SceneError, Simulation, Statistics};
use mpi::Rank;
use mpi::topology::SimpleCommunicator;
use neighbour_list::kernels::{Pair, Positions};
use solution5::reduce;

use crate::border::Border;
use crate::domain::Domain;
use crate::partition::Partition;

/// How ghosts are chosen for several steps, and how their positions are sent in each of them.
pub trait Halo: Partition {
    /// How far from a strip its ghosts come that last `steps` steps, if no particle goes further than `fastest` in one.
    fn ghost_width(fastest: f64, steps: u32) -> f64;

    /// For how many steps ghosts should be chosen: from 1 to `scenery.most`.
    fn best_steps(scenery: Scenery) -> u32;

    /// The particles that a partner needs: the indices in `y`, ascending, of all no further than `width` from its
    /// `strip`.
    fn choose(y: &[f64], strip: &Range<f64>, width: f64) -> Vec<u32>;

    /// The pairs within `reach` of an own particle and a ghost, ascending in the own particle.
    fn pairs_across(own: Positions<'_>, ghosts: Positions<'_>, reach: f64) -> Vec<Pair>;

    /// Sends `sent[k]` to rank `partners[k]`, fills `received[k]` with what that rank sends, and calls `meanwhile` once.
    fn exchange_positions(
        world: &SimpleCommunicator,
        partners: &[Rank],
        sent: &[Vec<f64>],
        received: &mut [Vec<f64>],
        meanwhile: impl FnOnce(),
    );

    /// Whether all ranks rebuild their lists before the next forces, on all ranks the same: if on any of them its own
    /// `list_has_expired`, or its ghosts have, which were chosen `width` wide, since when an own particle may have
    /// `moved` so far.
    fn must_renew(
        world: &SimpleCommunicator,
        list_has_expired: bool,
        moved: f64,
        width: f64,
    ) -> bool;
}

/// The facts on which the cheapest number of steps depends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scenery {
    /// How far the fastest particle of all goes in a step.
    pub fastest: f64,
    /// Particles per area, where they stand closest.
    pub density: f64,
    /// Height of a strip; its length along x does not matter.
    pub height: f64,
    /// Steps that the lists of all ranks last, at least 1. Then ghosts are chosen again anyway.
    pub most: u32,
}

/// One rank of the job: the engine of a neighbour list on the particles of a strip, and nothing else of the scene
/// but the positions of ghosts.
// ANCHOR: engine
pub struct Distributed<O, T> {
    pub(crate) domain: Domain<O>,
    pub(crate) border: Border,
    /// How far from a strip its ghosts come.
    pub(crate) width: f64,
    /// How far an own particle may have gone since ghosts were chosen.
    pub(crate) moved: f64,
    /// How far the fastest own particle goes in a step.
    pub(crate) fastest: f64,
    asks: PhantomData<T>,
}
// ANCHOR_END: engine

impl<O: Observer, T: Halo> Distributed<O, T> {
    /// An engine without particles.
    pub fn new(world: SimpleCommunicator, config: &Config) -> Self {
        let domain = Domain::new(world, config);
        let border = Border::default();
        Self { domain, border, width: 0.0, moved: 0.0, fastest: 0.0, asks: PhantomData }
    }

    /// Begins with the particles that the domain was loaded with.
    fn begin(&mut self) {
        self.fastest = self.domain.fastest();
        self.border = Border::default();
        // There are no ghosts yet.
        (self.width, self.moved) = (0.0, f64::INFINITY);
    }
}

impl<O: Observer, T: Halo> Simulation for Distributed<O, T> {
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

    // ANCHOR: step
    fn step(&mut self) {
        self.domain.traffic.begin_step();
        self.domain.counts.steps += 1;
        *self.domain.engine.observer_mut() = O::default();
        self.domain.count_reduction(&[0_i32]);
        let has_expired = self.domain.engine.has_expired();
        if T::must_renew(&self.domain.world, has_expired, self.moved, self.width) {
            self.renew();
        }
        let Self { domain: Domain { world, engine, traffic, .. }, border, .. } = self;
        border.pack(engine.bodies());
        border.sent.iter().for_each(|positions| traffic.sent(positions));
        engine.begin();
        let Border { partners, sent, received, affected, .. } = border;
        T::exchange_positions(world, partners, sent, received, || engine.move_inner(affected));
        let mut observer = O::default();
        self.fastest = engine.move_outer(border.accelerations(&mut observer));
        engine.observer_mut().merge(&observer);
        self.moved += self.fastest + self.domain.rounding();
    }
    // ANCHOR_END: step

    fn read(&self, first: usize, out: &mut [Particle]) {
        self.domain.read(first, out, |_| true);
    }

    fn statistics(&self) -> Option<Statistics> {
        reduce(&self.domain.world, &self.domain.engine.statistics()?)
    }

    fn counters(&self) -> Vec<(&'static str, f64)> {
        self.domain.counters("steps per list")
    }
}
