//! Task 4.9, and the engine around tasks 4.9 to 4.11: every thread takes its own particles.

use std::mem;

use common::Vec2;
use common::soft::{Observer, Particle, Scene, Simulation, Statistics, merged, read_by_id};
use rayon::ThreadPool;
use rayon::prelude::*;
use solution1::advance;
use solution2::{Gather, Grid, SortedBins};
use solution3::{pool, rows_of_each};

use crate::{Bin, Cut, add_across, pairs_across, pairs_within};

/// Empties the `bins` of region `own`, then fills them with the particles in this region.
///
/// Bins keep their memory. `particles[i]` has number i. All threads run this at the same time, each
/// with its own region and with *all* particles. [`Cut::find`] returns the region of a bin.
///
/// Book: chapter 4, *Owners*.
pub fn claim(cut: Cut, own: usize, bins: &mut [Bin], grid: &Grid, particles: &[Particle]) {
    todo!("task 4.9: an owner claims what lies in its region")
}

/// Fills a thread's sorted bins with the particles in its rows.
///
/// `all` are the particles of all threads, in any order. Most of these particles are in the rows of
/// other threads. With p threads, every particle is read p times. This is the price of needing no
/// locks, no buffers and no agreement.
///
/// [`SortedBins::rows`] returns the thread's rows. [`SortedBins::refill`] replaces the particles of
/// the bins, and keeps the memory.
///
/// Book: chapter 4, *Owners*.
pub fn take_own<'a>(own: &mut SortedBins, all: impl Iterator<Item = &'a Particle>) {
    todo!("task 4.9b: an owner takes what lies in its rows")
}

/// The method of summing the forces on an owner's particles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Forces {
    /// Each particle looks at all its neighbours, so every pair is tested from both sides.
    OneWay,
    /// Every pair is tested once, and the result serves both particles.
    TwoWay,
}

/// The private memory of a thread.
#[derive(Debug, Default)]
struct Worker<O> {
    /// The accelerations of the thread's particles, in the order of its bins.
    accelerations: Vec<Vec2>,
    /// The accelerations that the thread's particles cause in the next owner's first row.
    across: Vec<Vec2>,
    gather: Gather,
    /// The observers of this step. One-way forces use an observer for each row. Two-way forces use
    /// a single observer.
    seen: Vec<O>,
}

/// The owner-computes engine: every thread owns rows, and no other thread writes there.
pub struct Owners<O> {
    pool: ThreadPool,
    bin_size: f64,
    forces: Forces,
    grid: Grid,
    bins: Vec<SortedBins>,
    /// The bins of the next step. They are filled from `bins` while all threads read `bins`. Then
    /// `bins` and `next` are swapped.
    next: Vec<SortedBins>,
    workers: Vec<Worker<O>>,
    /// The thread that owns each row.
    owners: Vec<usize>,
}

impl<O: Observer> Owners<O> {
    /// Makes an engine for `threads` threads, with bins at least `bin_size` cutoffs wide.
    pub fn new(threads: usize, bin_size: f64, forces: Forces) -> Self {
        Self {
            pool: pool(threads),
            bin_size,
            forces,
            grid: Grid::default(),
            bins: Vec::new(),
            next: Vec::new(),
            workers: Vec::new(),
            owners: Vec::new(),
        }
    }
}

/// Sums the forces on a thread's own particles from all neighbours, in the order of ids.
///
/// The neighbours include the particles of other threads.
fn sum_one_way<O: Observer>(
    worker: &mut Worker<O>,
    own: &SortedBins,
    all: &[SortedBins],
    owners: &[usize],
) {
    let grid = own.grid();
    worker.accelerations.clear();
    worker.seen.clear();
    for row in own.rows() {
        let mut observer = O::default();
        for particle in own.bins(row, 0..grid.columns()) {
            let columns = grid.near(grid.column(particle.x));
            let around = grid.near(row).map(|row| all[owners[row]].bins(row, columns.clone()));
            let a = worker.gather.acceleration(particle, around, &mut observer);
            worker.accelerations.push(a);
        }
        worker.seen.push(observer);
    }
}

/// Computes the force of each pair once, in the thread that owns the row with the lower number.
///
/// The accelerations of the next owner's particles are stored separately, in `across`. The next
/// owner adds them when all threads have finished.
fn sum_two_way<O: Observer>(
    worker: &mut Worker<O>,
    own: &SortedBins,
    all: &[SortedBins],
    owners: &[usize],
) {
    let mut observer = O::default();
    worker.accelerations.clear();
    worker.accelerations.resize(own.particles().len(), Vec2::ZERO);
    pairs_within(own, &mut worker.accelerations, &mut observer);
    worker.across.clear();
    if let Some(owner) = owners.get(own.rows().end).filter(|_| !own.rows().is_empty()) {
        let next = &all[*owner];
        let first_row = next.bins(next.rows().start, 0..next.grid().columns());
        worker.across.resize(first_row.len(), Vec2::ZERO);
        pairs_across(own, next, &mut worker.accelerations, &mut worker.across, &mut observer);
    }
    worker.seen.clear();
    worker.seen.push(observer);
}

impl<O: Observer> Simulation for Owners<O> {
    fn load(&mut self, scene: &Scene) {
        self.grid = Grid::of_scene(scene, self.bin_size);
        let threads = self.pool.current_num_threads();
        self.owners.clear();
        self.bins.clear();
        self.next.clear();
        for (owner, rows) in rows_of_each(threads, self.grid.rows()).enumerate() {
            self.owners.resize(rows.end, owner);
            let mut own = SortedBins::new(self.grid, rows.clone());
            take_own(&mut own, scene.particles().iter());
            self.bins.push(own);
            self.next.push(SortedBins::new(self.grid, rows));
        }
        self.workers = (0..threads).map(|_| Worker::default()).collect();
    }

    fn step(&mut self) {
        let Self { pool, forces, grid, bins, next, workers, owners, .. } = self;
        let sum = match forces {
            Forces::OneWay => sum_one_way,
            Forces::TwoWay => sum_two_way,
        };
        pool.install(|| {
            workers
                .par_iter_mut()
                .zip(&*bins)
                .for_each(|(worker, own)| sum(worker, own, bins, owners));
            if *forces == Forces::TwoWay {
                add_across_cuts(workers, bins, owners);
            }
            bins.par_iter_mut().zip(workers).for_each(|(own, worker)| {
                for (particle, a) in own.particles_mut().iter_mut().zip(&worker.accelerations) {
                    advance(particle, *a, grid.size());
                }
            });
            let all = || bins.iter().flat_map(SortedBins::particles);
            next.par_iter_mut().for_each(|own| take_own(own, all()));
        });
        mem::swap(bins, next);
    }

    fn read(&self, first: usize, out: &mut [Particle]) {
        for own in &self.bins {
            read_by_id(own.particles(), first, out);
        }
    }

    fn statistics(&self) -> Option<Statistics> {
        merged(self.workers.iter().flat_map(|worker| &worker.seen))
    }
}

/// Adds the separately stored accelerations to those of the owners above the cuts.
///
/// There are few such accelerations: at most one row of them for each owner.
fn add_across_cuts<O>(workers: &mut [Worker<O>], bins: &[SortedBins], owners: &[usize]) {
    for (number, own) in bins.iter().enumerate().filter(|(_, own)| !own.rows().is_empty()) {
        if let Some(&next) = owners.get(own.rows().end) {
            let across = mem::take(&mut workers[number].across);
            add_across(&mut workers[next].accelerations, &across);
            workers[number].across = across;
        }
    }
}
