//! Sorted cells, a neighbour list with a skin, and a move without branches.

use std::f64::consts::PI;
use std::ops::Range;

use common::soft::{CUTOFF, DT, Observer, Particle, Scene, Simulation, Statistics};
use pulp::{Arch, NullaryFnOnce};
use solution1::bounce;

use crate::contacts::{BATCH, Contacts};
use crate::lanes::drift;
use crate::list::Block;
use crate::workers::cut;
use crate::{Bodies, Cells, Extent, Grid, Sorter, Workers, best_skin, worn_out};

/// Particles in a piece of work, roughly.
const PIECE: usize = 1024;
/// Particles whose walls are tested together.
const CHUNK: usize = 64;

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
    ax: Vec<f64>,
    ay: Vec<f64>,
    /// Where everybody stood when the list was built.
    old_x: Vec<f64>,
    old_y: Vec<f64>,
    sorter: Sorter,
    blocks: Vec<Block>,
    skin: f64,
    /// The square of the longest way from there; infinite before the first list.
    moved_squared: f64,
    age: u32,
    observer: O,
    counts: Counts,
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
            ax: Vec::new(),
            ay: Vec::new(),
            old_x: Vec::new(),
            old_y: Vec::new(),
            sorter: Sorter::default(),
            blocks: Vec::new(),
            skin: 0.0,
            moved_squared: f64::INFINITY,
            age: 0,
            observer: O::default(),
            counts: Counts::default(),
        }
    }

    /// Starts over from particles in a box of side `size`.
    pub fn start(&mut self, bodies: Bodies, size: f64) {
        (self.size, self.bodies) = (size, bodies);
        for array in [&mut self.ax, &mut self.ay, &mut self.old_x, &mut self.old_y] {
            array.clear();
            array.resize(self.bodies.len(), 0.0);
        }
        self.blocks.clear();
        self.moved_squared = f64::INFINITY;
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
        let listed: usize = self.blocks.iter().map(|block| block.neighbours.len()).sum();
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
        best_skin(density, self.moved_squared.sqrt() / f64::from(self.age.max(1)))
    }

    fn rebuild(&mut self) {
        let extent = Extent::of(&self.bodies);
        self.skin = self.choose_skin(&extent);
        // The place of a particle is rounded; a list must not miss a pair for that.
        let reach = (CUTOFF + self.skin) * (1.0 + 1e-9) + 1e-15 * self.size;
        let grid = Grid::new(&extent, reach);
        let dense = grid.cells() <= 4 * self.bodies.len() as u64 + 64;
        let cells =
            self.sorter.sort(&self.bodies, &mut self.spare, grid, dense, 0.0, &self.workers);
        std::mem::swap(&mut self.bodies, &mut self.spare);
        self.old_x.copy_from_slice(&self.bodies.x);
        self.old_y.copy_from_slice(&self.bodies.y);
        self.list(&cells, reach);
        self.sorter.take_back(cells);
        (self.moved_squared, self.age) = (0.0, 0);
        self.counts.rebuilds += 1;
        self.counts.skins += self.skin / CUTOFF;
    }

    fn list(&mut self, cells: &Cells, reach: f64) {
        let pieces = cells.pieces(PIECE);
        self.blocks.resize_with(pieces.len(), Block::default);
        let (bodies, arch) = (&self.bodies, self.arch);
        let work = self.blocks.iter_mut().zip(pieces).collect();
        self.workers.map(work, |(block, piece): (&mut Block, _)| {
            arch.dispatch(Fill { block, bodies, cells, piece, reach });
        });
        let tested: u64 = self.blocks.iter().map(|block| block.tested).sum();
        self.counts.tests += tested;
        self.observer.tested(tested);
    }

    fn forces(&mut self) {
        let ends: Vec<usize> = self.blocks.iter().map(|block| block.particles.end).collect();
        let axes = cut(&mut self.ax, ends.iter().copied())
            .into_iter()
            .zip(cut(&mut self.ay, ends.iter().copied()));
        let work: Vec<_> = self.blocks.iter_mut().zip(axes).collect();
        let (bodies, arch) = (&self.bodies, self.arch);
        let seen = self.workers.map(work, |(block, (ax, ay)): (&mut Block, (&mut [f64], _))| {
            let mut observer = O::default();
            arch.dispatch(Feel { block, bodies, ax, ay, observer: &mut observer });
            observer
        });
        // Always in the order of the blocks, whoever computed them.
        for (j, x, y) in self.blocks.iter().flat_map(|block| &block.pushes) {
            self.ax[*j as usize] += x;
            self.ay[*j as usize] += y;
        }
        for observer in &seen {
            self.observer.merge(observer);
        }
        let tests: usize = self.blocks.iter().map(|block| block.neighbours.len()).sum();
        self.counts.tests += tests as u64;
        self.observer.tested(tests as u64);
    }

    fn move_all(&mut self) {
        let (size, dt, arch) = (self.size, self.dt(), self.arch);
        let work: Vec<_> = self
            .bodies
            .x
            .chunks_mut(PIECE)
            .zip(self.bodies.vx.chunks_mut(PIECE))
            .zip(self.ax.chunks(PIECE).zip(self.old_x.chunks(PIECE)))
            .zip(self.bodies.y.chunks_mut(PIECE).zip(self.bodies.vy.chunks_mut(PIECE)))
            .zip(self.ay.chunks(PIECE).zip(self.old_y.chunks(PIECE)))
            .collect();
        let moved = self.workers.map(work, |((((x, vx), (ax, old_x)), (y, vy)), (ay, old_y))| {
            arch.dispatch(MoveAll { x, y, vx, vy, ax, ay, old_x, old_y, dt, size })
        });
        self.moved_squared = moved.into_iter().fold(0.0, f64::max);
    }
}

/// Lists the neighbours of a block.
struct Fill<'a> {
    block: &'a mut Block,
    bodies: &'a Bodies,
    cells: &'a Cells,
    piece: Range<usize>,
    reach: f64,
}

impl NullaryFnOnce for Fill<'_> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        self.block.fill(self.bodies, self.cells, self.piece, self.reach);
    }
}

/// The forces on a block.
struct Feel<'a, O> {
    block: &'a mut Block,
    bodies: &'a Bodies,
    ax: &'a mut [f64],
    ay: &'a mut [f64],
    observer: &'a mut O,
}

impl<O: Observer> NullaryFnOnce for Feel<'_, O> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        feel(self.block, self.bodies, self.ax, self.ay, self.observer);
    }
}

/// The move of a piece; brings back the square of the longest way from the old places.
struct MoveAll<'a> {
    x: &'a mut [f64],
    y: &'a mut [f64],
    vx: &'a mut [f64],
    vy: &'a mut [f64],
    ax: &'a [f64],
    ay: &'a [f64],
    old_x: &'a [f64],
    old_y: &'a [f64],
    dt: f64,
    size: f64,
}

impl NullaryFnOnce for MoveAll<'_> {
    type Output = f64;

    #[inline(always)]
    fn call(self) -> f64 {
        move_axis(self.x, self.vx, self.ax, self.dt, self.size);
        move_axis(self.y, self.vy, self.ay, self.dt, self.size);
        longest_way(self.x, self.y, self.old_x, self.old_y)
    }
}

/// Sums into `ax`, `ay` what the listed pairs do to the particles of a block.
#[inline(always)]
fn feel<O: Observer>(
    block: &mut Block,
    bodies: &Bodies,
    ax: &mut [f64],
    ay: &mut [f64],
    observer: &mut O,
) {
    let Block { particles, ends, neighbours, pushes, .. } = block;
    let (mut contacts, first) = (Contacts::default(), particles.start);
    pushes.clear();
    ax.fill(0.0);
    ay.fill(0.0);
    let (x, y) = (&bodies.x[..], &bodies.y[..bodies.x.len()]);
    let mut start = 0;
    for (k, &end) in ends.iter().enumerate() {
        let (xi, yi) = (x[first + k], y[first + k]);
        for batch in neighbours[start..end as usize].chunks(BATCH) {
            if contacts.is_full() {
                contacts.settle_pairs(first, ax, ay, pushes, observer);
            }
            for &j in batch {
                let (dx, dy) = (x[j as usize] - xi, y[j as usize] - yi);
                contacts.offer_pair(k as u32, j, dx, dy);
            }
        }
        start = end as usize;
    }
    contacts.settle_pairs(first, ax, ay, pushes, observer);
}

/// Moves one coordinate of all particles of a piece, and brings back who left the box.
#[inline(always)]
fn move_axis(x: &mut [f64], v: &mut [f64], a: &[f64], dt: f64, size: f64) {
    for ((x, v), a) in x.chunks_mut(CHUNK).zip(v.chunks_mut(CHUNK)).zip(a.chunks(CHUNK)) {
        if drift(x, v, a, dt, size) {
            for (x, v) in x.iter_mut().zip(v) {
                (*x, *v) = bounce(*x, *v, size);
            }
        }
    }
}

/// The square of the longest way from the old places.
#[inline(always)]
fn longest_way(x: &[f64], y: &[f64], old_x: &[f64], old_y: &[f64]) -> f64 {
    let mut longest = [0.0; 8];
    let n = x.len();
    let (y, old_x, old_y) = (&y[..n], &old_x[..n], &old_y[..n]);
    for i in 0..n {
        let (dx, dy) = (x[i] - old_x[i], y[i] - old_y[i]);
        longest[i % 8] = crate::lanes::larger(dx * dx + dy * dy, longest[i % 8]);
    }
    longest.into_iter().fold(0.0, f64::max)
}

impl<O: Observer> Simulation for Verlet<O> {
    fn load(&mut self, scene: &Scene) {
        self.start(Bodies::of(scene), scene.size());
    }

    fn step(&mut self) {
        self.observer = O::default();
        for _ in 0..self.divide {
            if worn_out(self.moved_squared, self.skin) {
                self.rebuild();
            }
            self.forces();
            self.move_all();
            self.age += 1;
        }
        self.counts.steps += 1;
    }

    fn read(&self, first: usize, out: &mut [Particle]) {
        self.bodies.read(first, out);
    }

    fn statistics(&self) -> Option<Statistics> {
        self.observer.statistics()
    }

    fn counters(&self) -> Vec<(&'static str, f64)> {
        let Counts { steps, rebuilds, tests, skins } = self.counts;
        let particle_steps = self.bodies.len() as f64 * steps as f64;
        vec![
            ("pair tests per particle and step", tests as f64 / particle_steps),
            ("particles touched per particle and step", 1.0),
            ("steps per rebuild", steps as f64 / rebuilds as f64),
            ("mean skin [cutoffs]", skins / rebuilds as f64),
        ]
    }
}
