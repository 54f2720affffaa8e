//! Sorted cells, a neighbour list with a skin, and a move without branches.
//!
//! The forces and the move are one pass over the particles, in `sweep.rs`.

use std::f64::consts::PI;
use std::ops::Range;

use common::soft::{CUTOFF, DT, Observer, Particle, Scene, Simulation, Statistics};
use pulp::Arch;

use crate::counts::Counts;
use crate::list::{Block, Fill};
use crate::sweep::{MoveHeld, Moving, Pass, Stride, Sweep};
use crate::workers::{cut, pieces};
use crate::{Bodies, Cells, Extent, Grid, Sorter, Workers, best_skin, worn_out};

/// Particles that are computed and moved together, roughly.
const PIECE: usize = 1024;
/// Most pieces: a row of cells grows with the root of their number, and a piece should be longer
/// than what it looks ahead.
const PIECES: usize = 256;
/// Most blocks.
const BLOCKS: usize = 16;

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
    sorter: Sorter,
    blocks: Vec<Block>,
    passes: Vec<Pass>,
    skin: f64,
    /// Nobody went further since the list was built; infinite before the first one.
    way: f64,
    age: u32,
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
            sorter: Sorter::default(),
            blocks: Vec::new(),
            passes: Vec::new(),
            skin: 0.0,
            way: f64::INFINITY,
            age: 0,
            observer: O::default(),
            counts: Counts::default(),
        }
    }

    /// Starts over from particles in a box of side `size`.
    pub fn start(&mut self, bodies: Bodies, size: f64) {
        (self.size, self.bodies) = (size, bodies);
        self.blocks.clear();
        self.way = f64::INFINITY;
        self.age = 0;
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

    /// Neighbours within the skin per particle, of the last list.
    pub fn listed(&self) -> f64 {
        let listed: usize = self.blocks.iter().map(|block| block.pairs.len()).sum();
        2.0 * listed as f64 / self.bodies.len() as f64
    }

    fn dt(&self) -> f64 {
        DT / f64::from(self.divide)
    }

    fn choose_skin(&self, extent: &Extent) -> f64 {
        if self.fixed_skin > 0.0 {
            return self.fixed_skin;
        }
        if self.blocks.is_empty() {
            let fastest = (0..self.bodies.len())
                .map(|i| self.bodies.vx[i].hypot(self.bodies.vy[i]))
                .fold(0.0, f64::max);
            let area = (extent.width + CUTOFF) * (extent.height + CUTOFF);
            return best_skin(self.bodies.len() as f64 / area, fastest * self.dt());
        }
        let reach = CUTOFF + self.skin;
        let density = self.listed() / (PI * reach * reach);
        best_skin(density, self.way / f64::from(self.age.max(1)))
    }

    fn rebuild(&mut self, workers: &Workers) {
        let extent = Extent::among(&self.bodies, workers);
        self.skin = self.choose_skin(&extent);
        // The place of a particle is rounded; a list must not miss a pair for that.
        let reach = (CUTOFF + self.skin) * (1.0 + 1e-9) + 1e-15 * self.size;
        let grid = Grid::new(&extent, reach);
        let dense = grid.cells() <= 4 * self.bodies.len() as u64 + 64;
        let cells = self.sorter.sort(&self.bodies, &mut self.spare, grid, dense, 0.0, workers);
        std::mem::swap(&mut self.bodies, &mut self.spare);
        self.list(&cells, reach, workers);
        self.sorter.take_back(cells);
        (self.way, self.age) = (0.0, 0);
        self.counts.rebuilds += 1;
        self.counts.skins += self.skin / CUTOFF;
    }

    fn list(&mut self, cells: &Cells, reach: f64, workers: &Workers) {
        let pieces = cells.pieces(pieces(self.bodies.len(), PIECE, PIECES));
        let bands: Vec<_> = pieces.chunks(pieces.len().div_ceil(BLOCKS).max(2)).collect();
        self.blocks.resize_with(bands.len(), Block::default);
        self.passes.resize_with(bands.len(), Pass::default);
        let (bodies, arch) = (&self.bodies, self.arch);
        let work = self.blocks.iter_mut().zip(bands).collect();
        workers.map(work, |(block, pieces): (&mut Block, _)| {
            arch.dispatch(Fill { block, bodies, cells, pieces, reach });
        });
        let mut ahead = 0;
        for (block, pass) in self.blocks.iter().zip(&mut self.passes) {
            let Range { start, end } = block.particles;
            pass.held = ahead.clamp(start, end) - start;
            ahead = block.pieces.iter().fold(ahead, |ahead, piece| ahead.max(piece.ahead));
        }
        let tested: u64 = self.blocks.iter().map(|block| block.tested).sum();
        self.counts.tests += tested;
        self.observer.tested(tested);
    }

    /// Forces and move of all blocks.
    fn sweep(&mut self, workers: &Workers) -> f64 {
        let stride = Stride { dt: self.dt(), size: self.size };
        let ends = || self.blocks.iter().map(|block| block.particles.end);
        let (old_x, old_y) = (&self.bodies.x[..], &self.bodies.y[..]);
        let new = cut(&mut self.spare.x, ends()).into_iter().zip(cut(&mut self.spare.y, ends()));
        let speeds =
            cut(&mut self.bodies.vx, ends()).into_iter().zip(cut(&mut self.bodies.vy, ends()));
        let work = self.blocks.iter().zip(&mut self.passes).zip(new.zip(speeds)).collect();
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
        let tests: usize = self.blocks.iter().map(|block| block.pairs.len()).sum();
        self.counts.tests += tests as u64;
        self.observer.tested(tests as u64);
        seen.into_iter().map(|(fastest, _)| fastest).fold(0.0, f64::max)
    }

    /// The move of those who were held back, with what the blocks before did to them.
    fn move_held(&mut self) -> f64 {
        let stride = Stride { dt: self.dt(), size: self.size };
        let mut fastest = 0.0_f64;
        for k in 1..self.blocks.len() {
            let [before, pass] = &mut self.passes[k - 1..=k] else { break };
            pass.own.add(&before.sums, 0);
            if before.sums.len() > pass.held {
                // A block that is shorter than what the one before it sees ahead.
                pass.sums.reach(before.sums.len() - pass.held);
                pass.sums.add(&before.sums, pass.held);
            }
            let start = self.blocks[k].particles.start;
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
}

impl<O: Observer> Verlet<O> {
    /// A small step.
    fn advance(&mut self, workers: &Workers) {
        if worn_out(self.way * self.way, self.skin) {
            self.rebuild(workers);
        }
        let fastest = self.sweep(workers).max(self.move_held());
        std::mem::swap(&mut self.bodies.x, &mut self.spare.x);
        std::mem::swap(&mut self.bodies.y, &mut self.spare.y);
        // A place is rounded at each step.
        self.way += fastest.sqrt() * self.dt() + f64::EPSILON * self.size;
        self.age += 1;
    }
}

impl<O: Observer> Simulation for Verlet<O> {
    fn load(&mut self, scene: &Scene) {
        self.start(Bodies::of(scene), scene.size());
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
