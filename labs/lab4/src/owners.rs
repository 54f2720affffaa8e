//! Task 4.6, and the engine around tasks 4.6 to 4.8: every thread takes what is its own.

use std::mem;

use common::Vec2;
use common::soft::{Observer, Particle, Scene, Simulation, Statistics, read_by_id};
use rayon::ThreadPool;
use rayon::prelude::*;
use solution1::advance;
use solution2::{Gather, Grid, SortedBins};
use solution3::{rows_of_each, team};

use crate::{add_across, pairs_across, pairs_within};

/// Fills a thread's bins with the particles that lie in its rows.
///
/// `everybody` are the particles of all threads, in any order. All of them are looked at, and most
/// are somebody else's: with p threads every particle is read p times. That is the price for doing
/// without locks, without buffers, without any agreement. [`SortedBins::rows`] are the own rows,
/// [`SortedBins::refill`] takes the particles.
///
/// Book: chapter 4, *Owners*.
pub fn take_own<'a>(own: &mut SortedBins, everybody: impl Iterator<Item = &'a Particle>) {
    todo!("task 4.6: an owner takes what lies in its rows")
}

/// How an owner sums the forces on its particles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Forces {
    /// For each particle it asks all neighbours: every pair is looked at from both sides.
    OneWay,
    /// Every pair is looked at once and serves both.
    TwoWay,
}

/// A thread's own memory.
#[derive(Debug, Default)]
struct Desk<O> {
    /// Of its particles, in the order of its bins.
    accelerations: Vec<Vec2>,
    /// What its particles do to those in the next owner's first row.
    across: Vec<Vec2>,
    gather: Gather,
    /// What it saw in this step, row by row.
    seen: Vec<O>,
}

/// Owner computes: every thread has rows of its own, and nobody else writes there.
pub struct Owners<O> {
    team: ThreadPool,
    bin_size: f64,
    forces: Forces,
    grid: Grid,
    bins: Vec<SortedBins>,
    /// Filled from `bins` while those are read by all; then the two change places.
    next: Vec<SortedBins>,
    desks: Vec<Desk<O>>,
    /// Who owns a row.
    owners: Vec<usize>,
}

impl<O: Observer> Owners<O> {
    /// An engine for `threads` threads and bins of `bin_size` cutoffs or more.
    pub fn new(threads: usize, bin_size: f64, forces: Forces) -> Self {
        Self {
            team: team(threads),
            bin_size,
            forces,
            grid: Grid::with_bins_along(1.0, 1),
            bins: Vec::new(),
            next: Vec::new(),
            desks: Vec::new(),
            owners: Vec::new(),
        }
    }
}

/// Each neighbour is asked, whoever owns it; the sum is in the order of ids.
fn sum_one_way<O: Observer>(
    desk: &mut Desk<O>,
    own: &SortedBins,
    all: &[SortedBins],
    owners: &[usize],
) {
    let grid = own.grid();
    desk.accelerations.clear();
    desk.seen.clear();
    for row in own.rows() {
        let mut observer = O::default();
        for particle in own.bins(row, 0..grid.columns()) {
            let columns = grid.near(grid.column(particle.x));
            let around = grid.near(row).map(|row| all[owners[row]].bins(row, columns.clone()));
            let a = desk.gather.acceleration(particle, around, &mut observer);
            desk.accelerations.push(a);
        }
        desk.seen.push(observer);
    }
}

/// Each pair is looked at once, by the owner of its lower row. What it does to the next owner's
/// particles is kept apart: that owner adds it when everybody has finished.
fn sum_two_way<O: Observer>(
    desk: &mut Desk<O>,
    own: &SortedBins,
    all: &[SortedBins],
    owners: &[usize],
) {
    let mut observer = O::default();
    desk.accelerations.clear();
    desk.accelerations.resize(own.particles().len(), Vec2::ZERO);
    pairs_within(own, &mut desk.accelerations, &mut observer);
    desk.across.clear();
    if let Some(owner) = owners.get(own.rows().end).filter(|_| !own.rows().is_empty()) {
        let next = &all[*owner];
        let first_row = next.bins(next.rows().start, 0..next.grid().columns());
        desk.across.resize(first_row.len(), Vec2::ZERO);
        pairs_across(own, next, &mut desk.accelerations, &mut desk.across, &mut observer);
    }
    desk.seen.clear();
    desk.seen.push(observer);
}

impl<O: Observer> Simulation for Owners<O> {
    fn load(&mut self, scene: &Scene) {
        self.grid = Grid::of_scene(scene, self.bin_size);
        let threads = self.team.current_num_threads();
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
        self.desks = (0..threads).map(|_| Desk::default()).collect();
    }

    fn step(&mut self) {
        let Self { team, forces, grid, bins, next, desks, owners, .. } = self;
        let sum = match forces {
            Forces::OneWay => sum_one_way,
            Forces::TwoWay => sum_two_way,
        };
        team.install(|| {
            desks.par_iter_mut().zip(&*bins).for_each(|(desk, own)| sum(desk, own, bins, owners));
            if *forces == Forces::TwoWay {
                add_across_cuts(desks, bins, owners);
            }
            bins.par_iter_mut().zip(desks).for_each(|(own, desk)| {
                for (particle, a) in own.particles_mut().iter_mut().zip(&desk.accelerations) {
                    advance(particle, *a, grid.size());
                }
            });
            let everybody = || bins.iter().flat_map(SortedBins::particles);
            next.par_iter_mut().for_each(|own| take_own(own, everybody()));
        });
        mem::swap(bins, next);
    }

    fn read(&self, first: usize, out: &mut [Particle]) {
        for own in &self.bins {
            read_by_id(own.particles(), first, out);
        }
    }

    fn statistics(&self) -> Option<Statistics> {
        let mut all = O::default();
        for seen in self.desks.iter().flat_map(|desk| &desk.seen) {
            all.merge(seen);
        }
        all.statistics()
    }
}

/// Hands what was kept apart to the owners of the rows beyond the cuts. It is little: a row each.
fn add_across_cuts<O>(desks: &mut [Desk<O>], bins: &[SortedBins], owners: &[usize]) {
    for (number, own) in bins.iter().enumerate().filter(|(_, own)| !own.rows().is_empty()) {
        if let Some(&next) = owners.get(own.rows().end) {
            let across = mem::take(&mut desks[number].across);
            add_across(&mut desks[next].accelerations, &across);
            desks[number].across = across;
        }
    }
}
