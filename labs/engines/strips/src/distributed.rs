//! The engine that sends the positions of ghosts in each step.

use std::marker::PhantomData;

use common::Config;
use common::soft::{Observer, Particle, Scene, SceneError, Simulation, Statistics};
use mpi::topology::SimpleCommunicator;
use solution5::reduce;

use crate::border::Border;
use crate::domain::Domain;
use crate::sent_halo::Halo;

/// One rank of the job: the engine of a neighbour list on the particles of a strip.
///
/// Of the other particles of the scene, this rank knows only the ghosts, and only their positions.
// ANCHOR: engine
pub struct Distributed<O, T> {
    pub(crate) domain: Domain<O>,
    pub(crate) border: Border,
    /// The greatest distance of a ghost from the strip.
    pub(crate) width: f64,
    /// The greatest distance that a particle of this rank may have gone since ghosts were chosen.
    pub(crate) moved: f64,
    /// The distance that the fastest particle of this rank goes in a step.
    pub(crate) fastest: f64,
    asks: PhantomData<T>,
}
// ANCHOR_END: engine

impl<O: Observer, T: Halo> Distributed<O, T> {
    /// Makes an engine without particles.
    pub fn new(world: SimpleCommunicator, config: &Config) -> Self {
        let domain = Domain::new(world, config);
        let border = Border::default();
        Self { domain, border, width: 0.0, moved: 0.0, fastest: 0.0, asks: PhantomData }
    }

    /// Begins with the particles that the domain has loaded.
    fn begin(&mut self) {
        self.fastest = self.domain.fastest();
        self.border = Border::default();
        // There are no ghosts yet, so the first step must choose ghosts.
        self.width = 0.0;
        self.moved = f64::INFINITY;
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
