//! Sorted cells, a neighbour list with a skin, and a move without branches.
//!
//! The forces and the move are one pass over the particles, in `sweep.rs`.

use std::ops::Range;

use common::soft::{CUTOFF, DT, Observer, Particle, Scene, Simulation, Statistics};

use super::pushes::Pushes;
use super::step::{Step, Work};
use super::sweep::Pass;
use crate::list::{Block, Limits, Neighbours};
use crate::particles::Bodies;
use crate::threads::Workers;

/// The engine of variant `verlet`.
pub struct Verlet<O> {
    pub(super) workers: Workers,
    /// The skin that was asked for, or 0 for the cheapest.
    fixed_skin: f64,
    /// Steps that an official step is divided into.
    divide: u32,
    pub(super) size: f64,
    pub(super) bodies: Bodies,
    pub(super) spare: Bodies,
    pub(super) list: Neighbours,
    pub(super) limits: Limits,
    pub(super) passes: Vec<Pass>,
    pub(super) observer: O,
    counts: Counts,
}

impl<O: Observer> Verlet<O> {
    /// An engine for these threads with a skin of `skin` cutoffs, 0 for the cheapest, and each
    /// official step divided into `divide`.
    pub fn new(workers: Workers, skin: f64, divide: u32) -> Self {
        Self {
            workers,
            fixed_skin: skin * CUTOFF,
            divide,
            size: 0.0,
            bodies: Bodies::default(),
            spare: Bodies::default(),
            list: Neighbours::default(),
            limits: Limits::default(),
            passes: Vec::new(),
            observer: O::default(),
            counts: Counts::default(),
        }
    }

    /// Goes on from particles in a box of side `size`.
    pub fn start(&mut self, bodies: Bodies, size: f64) {
        (self.size, self.bodies) = (size, bodies);
        self.list.forget();
        self.limits = Limits::default();
    }

    /// The particles, in an order of the engine's own.
    pub fn bodies(&self) -> &Bodies {
        &self.bodies
    }

    /// What was counted.
    pub fn counts(&self) -> Counts {
        self.counts
    }

    fn dt(&self) -> f64 {
        DT / f64::from(self.divide)
    }

    pub(super) fn rebuild(&mut self, workers: &Workers) {
        let dt = self.dt();
        let Self { list, limits, bodies, spare, size, fixed_skin, .. } = self;
        let skin = |displacement| {
            if *fixed_skin > 0.0 { *fixed_skin } else { list.cheapest_skin(bodies, displacement) }
        };
        let skin = limits.renew(bodies, dt, *size, skin);
        let tested = list.rebuild(bodies, spare, skin, *size, workers);
        self.note_fast(workers);
        self.hold_back();
        self.counts.rebuilds += 1;
        self.counts.skins += skin / CUTOFF;
        self.count(tested);
    }

    /// Notes the particles of each block that exceed the speed limit.
    fn note_fast(&mut self, workers: &Workers) {
        let Self { list, limits, bodies, passes, .. } = self;
        passes.resize_with(list.blocks.len(), Pass::default);
        let work = list.blocks.iter().zip(passes).collect();
        workers.map(work, |(block, pass): (&Block, &mut Pass)| {
            limits.note_fast(bodies, block.particles.clone(), &mut pass.fast);
        });
    }

    /// Makes the short list anew if it is worn out.
    pub(super) fn shorten_if_due(&mut self, workers: &Workers) {
        if !self.limits.short_is_spent() {
            return;
        }
        let Self { list, limits, bodies, passes, .. } = self;
        let fast = passes.iter_mut().flat_map(|pass| pass.fast.indices.drain(..));
        let tested = limits.shorten(list, bodies, fast, workers);
        self.hold_back();
        self.counts.shortened += 1;
        self.counts.outliers += self.limits.outliers().count() as u64;
        self.count(tested);
    }

    /// Has each block hold back the particles that pairs of earlier blocks may push.
    fn hold_back(&mut self) {
        let mut ahead = 0;
        for (block, pass) in self.list.blocks.iter().zip(&mut self.passes) {
            let Range { start, end } = block.particles;
            pass.held = ahead.clamp(start, end) - start;
            pass.is_overrun = ahead > end;
            ahead = ahead.max(block.ahead());
        }
    }

    /// A step of all blocks, in which particles elsewhere push those in the places `pushed`.
    pub(super) fn sweep(&mut self, workers: &Workers, pushed: &[u32]) -> Step<'_, O> {
        self.count(self.list.blocks.iter().map(|block| block.pairs().pairs.len() as u64).sum());
        let stride = (self.dt(), self.size);
        let Self { list, limits, bodies, passes, observer, .. } = self;
        for (block, pass) in list.blocks.iter().zip(passes.iter_mut()) {
            let behind = block.particles.end..block.ahead();
            pass.ghosts.copy(&bodies.x[behind.clone()], &bodies.y[behind]);
        }
        let work = Work::all(&list.blocks, passes, bodies);
        Step::new(workers.clone(), limits, stride, work, pushed, observer)
    }

    fn count(&mut self, tested: u64) {
        self.counts.tests += tested;
        self.observer.tested(tested);
    }

    /// Whether the list must be made anew before the next forces.
    pub(super) fn is_spent(&self) -> bool {
        self.list.budget.is_spent() || self.limits.are_outrun(self.bodies.len())
    }

    /// The step is over: the lists are older by it. Brings back how many times as fast as allowed the
    /// worst particle was.
    pub(super) fn age(&mut self) -> f64 {
        let over = self.passes.iter().fold(1.0, |over: f64, pass| over.max(pass.fast.over));
        // A place is rounded at each step.
        self.limits.age(&mut self.list.budget, over, f64::EPSILON * self.size);
        over
    }

    /// A small step.
    fn advance(&mut self, workers: &Workers) {
        if self.is_spent() {
            self.rebuild(workers);
        }
        self.shorten_if_due(workers);
        let mut step = self.sweep(workers, &[]);
        step.move_inner();
        step.move_outer(Pushes::default());
        self.age();
    }

    fn official_step(&mut self, workers: &Workers) {
        self.observer = O::default();
        self.advance(workers);
        // An observer sees an official step, so the first look of its small steps.
        let seen = std::mem::take(&mut self.observer);
        (1..self.divide).for_each(|_| self.advance(workers));
        self.observer = seen;
        self.counts.steps += 1;
    }
}

impl<O: Observer> Simulation for Verlet<O> {
    fn load(&mut self, scene: &Scene) {
        self.workers.engage(scene.len());
        self.start(Bodies::of(scene), scene.size());
        self.counts = Counts::default();
    }

    fn step(&mut self) {
        self.run(1);
    }

    fn run(&mut self, steps: u64) {
        let workers = self.workers.clone();
        workers.within(|| (0..steps).for_each(|_| self.official_step(&workers)));
    }

    fn read(&self, first: usize, out: &mut [Particle]) {
        self.bodies.read(first, out);
    }

    fn statistics(&self) -> Option<Statistics> {
        self.observer.statistics()
    }

    fn counters(&self) -> Vec<(&'static str, f64)> {
        self.counts.shown(self.bodies.len())
    }
}

/// What the engine counts since it was loaded.
#[derive(Clone, Copy, Debug, Default)]
pub struct Counts {
    /// Steps taken.
    pub steps: u64,
    /// Lists built.
    pub rebuilds: u64,
    /// Pairs looked at, in lists and to build them.
    pub tests: u64,
    /// Sum over rebuilds of the skin, in cutoffs.
    pub skins: f64,
    /// Short lists made.
    pub shortened: u64,
    /// Sum over short lists of their outliers.
    pub outliers: u64,
}

impl Counts {
    /// With names, for a run of `n` particles.
    pub(crate) fn shown(&self, n: usize) -> Vec<(&'static str, f64)> {
        let Counts { steps, rebuilds, tests, skins, shortened, outliers } = *self;
        let particle_steps = n as f64 * steps as f64;
        vec![
            ("pair tests per particle and step", tests as f64 / particle_steps),
            ("particles touched per particle and step", 1.0),
            ("steps per rebuild", steps as f64 / rebuilds as f64),
            ("mean skin [cutoffs]", skins / rebuilds as f64),
            ("short lists per list", shortened as f64 / rebuilds as f64),
            ("share that outruns the list", outliers as f64 / (n as f64 * shortened.max(1) as f64)),
        ]
    }
}
