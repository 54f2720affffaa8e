//! The engine: it sorts particles, lists pairs with a skin, sums forces and moves particles.
//!
//! The pass over a block is in `sweep.rs`.

use common::soft::{CUTOFF, DT, Observer, Particle, Scene, Simulation, Statistics};
use pulp::Arch;

use super::across::{Across, External};
use super::clock::{Clock, Part};
use super::counts::Counts;
use super::sweep::{Pass, Sweep};
use crate::kernels::Primitives;
use crate::list::{Block, Limits, Neighbours};
use crate::particles::{Bodies, Moving};
use crate::threads::Crew;

/// The engine, with the primitives `P` and an observer `O`, on several threads.
#[derive(Default)]
pub struct NeighbourList<O, P> {
    crew: Crew,
    /// The skin that the user chose, or 0 for the cheapest; a length.
    fixed_skin: f64,
    /// Number of small steps in an official step.
    divide: u32,
    size: f64,
    bodies: Bodies,
    list: Neighbours<P>,
    limits: Limits,
    /// The working memory of each block of the list.
    passes: Vec<Pass<P>>,
    across: Across<P>,
    observer: O,
    counts: Counts,
    clock: Clock,
}

impl<O: Observer, P: Primitives> NeighbourList<O, P> {
    /// Makes an engine that runs on `crew`.
    ///
    /// `skin` is in cutoffs; 0 selects the cheapest skin. Each official step is divided into
    /// `divide` small steps.
    pub fn new(crew: impl Into<Crew>, skin: f64, divide: u32) -> Self {
        Self { crew: crew.into(), fixed_skin: skin * CUTOFF, divide, ..Self::default() }
    }

    /// Decides whether the engine measures the parts of each step.
    pub fn timed(self, is_timed: bool) -> Self {
        let clock = if is_timed { Clock::started() } else { Clock::default() };
        Self { clock, ..self }
    }

    /// Continues with these particles in a box of side `size`.
    pub fn start(&mut self, bodies: Bodies, size: f64) {
        self.size = size;
        self.bodies = bodies;
        self.list.forget();
        self.limits = Limits::default();
    }

    /// Returns the particles in the engine's order.
    pub fn bodies(&self) -> &Bodies {
        &self.bodies
    }

    /// Returns the particles, so that the caller can remove and add particles. The caller must then
    /// rebuild the list.
    pub fn bodies_mut(&mut self) -> &mut Bodies {
        &mut self.bodies
    }

    /// Returns the neighbour list.
    pub fn list(&self) -> &Neighbours<P> {
        &self.list
    }

    /// Returns the speed limits that the list was built for.
    pub fn limits(&self) -> &Limits {
        &self.limits
    }

    /// Returns the observer, so that the caller can take its records.
    pub fn observer_mut(&mut self) -> &mut O {
        &mut self.observer
    }

    /// Returns the counters.
    pub fn counts(&self) -> Counts {
        self.counts
    }

    fn dt(&self) -> f64 {
        DT / f64::from(self.divide)
    }

    fn count(&mut self, tested: u64) {
        self.counts.tests += tested;
        self.observer.tested(tested);
    }

    /// Whether the list must be rebuilt before the next forces.
    pub fn has_expired(&self) -> bool {
        let n = self.bodies.len();
        n > 0 && (self.list.budget.has_expired::<P>() || self.limits.are_outrun(n))
    }

    /// Rebuilds the list, which may be empty.
    pub fn rebuild(&mut self) {
        if self.bodies.is_empty() {
            self.start(Bodies::default(), self.size);
            self.passes.clear();
            return;
        }
        let dt = self.dt();
        let Self { crew, list, limits, bodies, passes, size, fixed_skin, clock, .. } = self;
        let skin = |displacement| {
            if *fixed_skin > 0.0 { *fixed_skin } else { list.cheapest_skin(bodies, displacement) }
        };
        let skin = limits.renew(bodies, dt, *size, skin);
        clock.lap(Part::Limits);
        list.sort(bodies, skin, *size, crew.workers());
        clock.lap(Part::Sort);
        let tested = list.collect(bodies, crew.workers());
        passes.resize_with(list.blocks.len(), Pass::default);
        let work = list.blocks.iter().zip(passes).collect();
        crew.workers().map(work, |(block, pass): (&Block, &mut Pass<P>)| {
            limits.note_fast(bodies, block.particles.clone(), &mut pass.fast);
        });
        clock.lap(Part::Outer);
        self.counts.rebuilds += 1;
        self.counts.skins += skin / CUTOFF;
        self.count(tested);
    }

    /// Rebuilds the list, and stores the particles in their former order in `kept`.
    pub fn rebuild_keeping(&mut self, kept: &mut Bodies) {
        self.rebuild();
        // Sorting has left the particles in the arrays that the next sort would write to.
        std::mem::swap(kept, self.list.unsorted());
        kept.resize(self.bodies.len());
    }

    /// Begins a step: rebuilds an expired inner list, and computes the pairs whose particles are in
    /// different blocks.
    pub fn begin(&mut self) {
        self.rebuild_inner_if_due();
        self.clock.lap(Part::Inner);
        self.count(self.list.blocks.iter().map(|block| block.pairs().len() as u64).sum());
        let Self { list, bodies, across, observer, .. } = self;
        across.find(&list.blocks, bodies.positions(), observer);
        self.clock.lap(Part::Across);
    }

    fn rebuild_inner_if_due(&mut self) {
        if !self.limits.inner_has_expired::<P>() {
            return;
        }
        let Self { crew, list, limits, bodies, passes, .. } = self;
        let fast = passes.iter_mut().flat_map(|pass| pass.fast.indices.drain(..));
        let tested = limits.rebuild_inner(list, bodies, fast, crew.workers());
        self.counts.inner_rebuilds += 1;
        self.counts.outliers += self.limits.outliers().count() as u64;
        self.count(tested);
    }

    /// Moves the blocks that contain none of the particles `waiting`, whose indices are ascending.
    ///
    /// Particles outside the engine may act on the particles `waiting`, so
    /// [`move_outer`](Self::move_outer) moves the blocks of these particles.
    pub fn move_inner(&mut self, waiting: &[u32]) {
        self.sweep(External::default(), |block| !block.has_any(waiting));
    }

    /// Moves the other blocks, to which the accelerations `external` are added, and ends the step.
    /// Returns an upper bound for the distance that the fastest particle went.
    pub fn move_outer(&mut self, external: External<'_>) -> f64 {
        self.sweep(external, |block| block.has_any(external.indices));
        let over = self.passes.iter().fold(1.0, |over: f64, pass| over.max(pass.fast.over));
        // Every step rounds the positions.
        self.limits.age(&mut self.list.budget, over, f64::EPSILON * self.size);
        over * self.limits.outliers().fastest() * self.limits.displacement()
    }

    fn sweep(&mut self, external: External<'_>, is_chosen: impl Fn(&Block) -> bool) {
        let dt = self.dt();
        let size = self.size;
        let arch = Arch::new();
        let Self { crew, list, limits, bodies, passes, across, observer, .. } = self;
        let ends: Vec<usize> = list.blocks.iter().map(|block| block.particles.end).collect();
        let blocks = list.blocks.iter().zip(passes).zip(bodies.split(&ends));
        let work = blocks.filter(|((block, _), _)| is_chosen(block)).collect();
        let observers = crew.workers().map(
            work,
            |((block, pass), moving): ((&Block, &mut Pass<P>), Moving<'_>)| {
                let limit = limits.speed_limit(&block.particles);
                let mut observer = O::default();
                arch.dispatch(Sweep {
                    block,
                    pass,
                    across,
                    external,
                    moving,
                    dt,
                    size,
                    limit,
                    observer: &mut observer,
                });
                observer
            },
        );
        observers.iter().for_each(|seen| observer.merge(seen));
        self.clock.lap(Part::Sweep);
    }

    /// Moves all particles by a small step, with a new list if the old one has expired.
    ///
    /// Returns an upper bound for the distance that the fastest particle went.
    pub fn advance(&mut self) -> f64 {
        self.clock.resume();
        if self.has_expired() {
            self.rebuild();
        }
        self.begin();
        self.move_inner(&[]);
        self.move_outer(External::default())
    }

    fn official_step(&mut self) {
        self.observer = O::default();
        self.advance();
        // An observer sees the forces of the first small step only; these are the forces of the
        // official step.
        let seen = std::mem::take(&mut self.observer);
        for _ in 1..self.divide {
            self.advance();
        }
        self.observer = seen;
        self.counts.steps += 1;
    }
}

impl<O: Observer, P: Primitives> Simulation for NeighbourList<O, P> {
    fn load(&mut self, scene: &Scene) {
        self.crew.engage(scene.len());
        self.start(Bodies::of(scene), scene.size());
        self.counts = Counts::default();
        self.clock.reset();
    }

    fn step(&mut self) {
        self.run(1);
    }

    fn run(&mut self, steps: u64) {
        (0..steps).for_each(|_| self.official_step());
    }

    fn read(&self, first: usize, out: &mut [Particle]) {
        self.bodies.read(first, out);
    }

    fn statistics(&self) -> Option<Statistics> {
        self.observer.statistics()
    }

    fn counters(&self) -> Vec<(&'static str, f64)> {
        let mut counters = self.counts.shown(self.bodies.len());
        counters.extend(self.clock.shown(self.crew.most()));
        counters
    }
}
