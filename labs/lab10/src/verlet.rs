//! Sorted cells, a neighbour list with a skin, and a move without branches.
//!
//! The forces and the move are one pass over the particles, in `sweep.rs`.

use std::ops::Range;

use common::soft::{CUTOFF, DT, Observer, Particle, Scene, Simulation, Statistics};
use pulp::Arch;

use crate::counts::Counts;
use crate::neighbours::Neighbours;
use crate::sweep::{MoveHeld, Moving, Pass, Stride, Sweep};
use crate::workers::cut;
use crate::{Bodies, Workers};

/// The engine of variant `verlet`.
pub struct Verlet<O> {
    workers: Workers,
    arch: Arch,
    /// The skin that was asked for, or 0 for the cheapest.
    fixed_skin: f64,
    /// Steps that an official step is divided into.
    divide: u32,
    size: f64,
    bodies: Bodies,
    spare: Bodies,
    list: Neighbours,
    passes: Vec<Pass>,
    observer: O,
    counts: Counts,
}

impl<O: Observer> Verlet<O> {
    /// An engine for `threads` threads with a skin of `skin` cutoffs, 0 for the cheapest, and each
    /// official step divided into `divide`.
    pub fn new(threads: usize, skin: f64, divide: u32) -> Self {
        Self {
            workers: Workers::new(threads),
            arch: Arch::new(),
            fixed_skin: skin * CUTOFF,
            divide,
            size: 0.0,
            bodies: Bodies::default(),
            spare: Bodies::default(),
            list: Neighbours::default(),
            passes: Vec::new(),
            observer: O::default(),
            counts: Counts::default(),
        }
    }

    /// Goes on from particles in a box of side `size`.
    pub fn start(&mut self, bodies: Bodies, size: f64) {
        (self.size, self.bodies) = (size, bodies);
        self.list.forget();
    }

    /// Begins to count anew.
    pub(crate) fn count_anew(&mut self) {
        self.counts = Counts::default();
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

    fn rebuild(&mut self, workers: &Workers) {
        let skin = if self.fixed_skin > 0.0 {
            self.fixed_skin
        } else {
            self.list.cheapest_skin(&self.bodies, self.dt())
        };
        let Self { list, bodies, spare, size, .. } = self;
        let tested = list.rebuild(bodies, spare, skin, *size, workers);
        self.hold_back();
        self.counts.rebuilds += 1;
        self.counts.skins += skin / CUTOFF;
        self.counts.tests += tested;
        self.observer.tested(tested);
    }

    /// Has each block hold back those whom the one before may push.
    fn hold_back(&mut self) {
        self.passes.resize_with(self.list.blocks.len(), Pass::default);
        let mut ahead = 0;
        for (block, pass) in self.list.blocks.iter().zip(&mut self.passes) {
            let Range { start, end } = block.particles;
            pass.held = ahead.clamp(start, end) - start;
            ahead = block.pieces.iter().fold(ahead, |ahead, piece| ahead.max(piece.ahead));
        }
    }

    /// Forces and move of all blocks.
    fn sweep(&mut self, workers: &Workers) -> f64 {
        let stride = Stride { dt: self.dt(), size: self.size };
        let ends = || self.list.blocks.iter().map(|block| block.particles.end);
        let (old_x, old_y) = (&self.bodies.x[..], &self.bodies.y[..]);
        let new = cut(&mut self.spare.x, ends()).into_iter().zip(cut(&mut self.spare.y, ends()));
        let speeds =
            cut(&mut self.bodies.vx, ends()).into_iter().zip(cut(&mut self.bodies.vy, ends()));
        let work = self.list.blocks.iter().zip(&mut self.passes).zip(new.zip(speeds)).collect();
        let arch = self.arch;
        let seen = workers.map(work, |((block, pass), ((x, y), (vx, vy)))| {
            let own = block.particles.clone();
            let (from_x, from_y) = (&old_x[own.clone()], &old_y[own]);
            let moving = Moving { old_x: from_x, old_y: from_y, x, y, vx, vy };
            let (mut observer, places) = (O::default(), (old_x, old_y));
            let sweep = Sweep { block, pass, places, moving, stride, observer: &mut observer };
            (arch.dispatch(sweep), observer)
        });
        for (_, observer) in &seen {
            self.observer.merge(observer);
        }
        let tests = self.list.pairs();
        self.counts.tests += tests as u64;
        self.observer.tested(tests as u64);
        seen.into_iter().map(|(fastest, _)| fastest).fold(0.0, f64::max)
    }

    /// The move of those who were held back, with what the blocks before did to them.
    fn move_held(&mut self) -> f64 {
        let stride = Stride { dt: self.dt(), size: self.size };
        let mut fastest = 0.0_f64;
        for k in 1..self.list.blocks.len() {
            let [before, pass] = &mut self.passes[k - 1..=k] else { break };
            pass.own.add(&before.sums, 0);
            if before.sums.len() > pass.held {
                // A block that is shorter than what the one before it sees ahead.
                pass.sums.reach(before.sums.len() - pass.held);
                pass.sums.add(&before.sums, pass.held);
            }
            let start = self.list.blocks[k].particles.start;
            let own = start..start + pass.held;
            let moving = Moving {
                old_x: &self.bodies.x[own.clone()],
                old_y: &self.bodies.y[own.clone()],
                x: &mut self.spare.x[own.clone()],
                y: &mut self.spare.y[own.clone()],
                vx: &mut self.bodies.vx[own.clone()],
                vy: &mut self.bodies.vy[own],
            };
            fastest = fastest.max(self.arch.dispatch(MoveHeld { own: &pass.own, moving, stride }));
        }
        fastest
    }

    /// A small step.
    fn advance(&mut self, workers: &Workers) {
        if self.list.wear.is_out(0.0) {
            self.rebuild(workers);
        }
        let fastest = self.sweep(workers).max(self.move_held());
        std::mem::swap(&mut self.bodies.x, &mut self.spare.x);
        std::mem::swap(&mut self.bodies.y, &mut self.spare.y);
        // A place is rounded at each step.
        self.list.age(fastest.sqrt() * self.dt() + f64::EPSILON * self.size);
    }
}

impl<O: Observer> Simulation for Verlet<O> {
    fn load(&mut self, scene: &Scene) {
        self.start(Bodies::of(scene), scene.size());
        self.count_anew();
    }

    fn step(&mut self) {
        self.observer = O::default();
        let workers = std::mem::take(&mut self.workers);
        workers.within(|| (0..self.divide).for_each(|_| self.advance(&workers)));
        self.workers = workers;
        self.counts.steps += 1;
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
