//! Given: the engine around tasks 4.1 to 4.5.

use std::sync::Arc;
use std::time::{Duration, Instant};

use common::soft::{Observer, Particle, Scene, Simulation, Statistics, read_by_id};
use crossbeam_queue::SegQueue;
use crossbeam_utils::CachePadded;
use rayon::ThreadPool;
use rayon::prelude::*;
use solution2::{Grid, VecBins};
use solution3::{Desk, own_bins, rows_of_each, team};

use crate::{Meter, Regions, post, put_all, rebuild, take};

/// How leavers get into their new bins.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    /// One thread clears all bins and fills them again.
    Rebuild,
    /// All threads, under so many locks.
    Locks(usize),
    /// Through the owners' queues.
    Queues,
}

/// Lab 3's fork and join, with other ways to rebin, and a meter for every thread.
pub struct SharedBins<O> {
    team: Arc<ThreadPool>,
    bin_size: f64,
    way: Way,
    bins: VecBins,
    desks: Vec<CachePadded<Desk<O>>>,
    meters: Vec<CachePadded<Meter>>,
    queues: Vec<SegQueue<Particle>>,
    /// Who owns a row.
    owners: Vec<usize>,
    all: Vec<Particle>,
    making_locks: Duration,
}

impl<O: Observer> SharedBins<O> {
    /// An engine for `threads` threads and bins of `bin_size` cutoffs or more.
    pub fn new(threads: usize, bin_size: f64, way: Way) -> Self {
        Self {
            team: Arc::new(team(threads)),
            bin_size,
            way,
            bins: VecBins::new(Grid::with_bins_along(1.0, 1)),
            desks: Vec::new(),
            meters: Vec::new(),
            queues: Vec::new(),
            owners: Vec::new(),
            all: Vec::new(),
            making_locks: Duration::ZERO,
        }
    }

    fn move_particles(&mut self) {
        let grid = *self.bins.grid();
        let own = own_bins(&mut self.bins, &self.desks);
        let desks = self.desks.par_iter_mut().zip(&mut self.meters).zip(own);
        desks.for_each(|((desk, meter), own)| {
            let start = Instant::now();
            desk.move_particles(&grid, own);
            meter.rebinning += start.elapsed();
        });
    }

    fn rebin(&mut self) {
        let grid = *self.bins.grid();
        match self.way {
            Way::Rebuild => {
                let start = Instant::now();
                let buffers = self.desks.iter().map(|desk| &desk.changed[..]);
                rebuild(&mut self.bins, buffers, &mut self.all);
                self.meters[0].rebinning += start.elapsed();
            }
            Way::Locks(count) => {
                let start = Instant::now();
                let regions = Regions::new(self.bins.bins_mut(), count);
                self.making_locks += start.elapsed();
                let desks = self.desks.par_iter().zip(&mut self.meters);
                desks.for_each(|(desk, meter)| {
                    let start = Instant::now();
                    put_all(&grid, &regions, &desk.changed, meter);
                    meter.rebinning += start.elapsed();
                });
            }
            Way::Queues => {
                let desks = self.desks.par_iter().zip(&mut self.meters);
                desks.for_each(|(desk, meter)| {
                    let start = Instant::now();
                    post(&grid, &self.owners, &self.queues, &desk.changed);
                    meter.rebinning += start.elapsed();
                });
                let own = own_bins(&mut self.bins, &self.desks);
                let desks = self.desks.par_iter().zip(&mut self.meters);
                desks.zip(own).zip(&self.queues).for_each(|(((desk, meter), own), queue)| {
                    let start = Instant::now();
                    take(&grid, desk.rows.start * grid.columns(), own, queue);
                    meter.rebinning += start.elapsed();
                });
            }
        }
    }
}

impl<O: Observer> Simulation for SharedBins<O> {
    fn load(&mut self, scene: &Scene) {
        self.bins = VecBins::of_scene(scene, self.bin_size);
        self.bins.refill(scene.particles());
        let threads = self.team.current_num_threads();
        self.desks.clear();
        self.owners.clear();
        for (owner, rows) in rows_of_each(threads, self.bins.grid().rows()).enumerate() {
            self.owners.resize(rows.end, owner);
            self.desks.push(Desk::new(rows).into());
        }
        self.meters = vec![CachePadded::default(); threads];
        self.queues = (0..threads).map(|_| SegQueue::new()).collect();
        self.making_locks = Duration::ZERO;
    }

    fn step(&mut self) {
        let team = Arc::clone(&self.team);
        team.install(|| {
            let bins = &self.bins;
            self.desks.par_iter_mut().for_each(|desk| desk.sum_forces(bins));
            self.move_particles();
            self.rebin();
        });
    }

    fn read(&self, first: usize, out: &mut [Particle]) {
        read_by_id(self.bins.particles(), first, out);
    }

    fn statistics(&self) -> Option<Statistics> {
        let mut all = O::default();
        for seen in self.desks.iter().flat_map(|desk| &desk.seen) {
            all.merge(seen);
        }
        all.statistics()
    }

    fn counters(&self) -> Vec<(&'static str, f64)> {
        let sum = Meter::sum(self.meters.iter().map(|meter| &**meter));
        let mut counters =
            vec![("moving and rebinning, all threads [s]", sum.rebinning.as_secs_f64())];
        if let Way::Locks(_) = self.way {
            counters.extend([
                ("locks taken", sum.locks as f64),
                ("locks waited for", sum.contended as f64),
                ("lock wait, all threads [s]", sum.waiting.as_secs_f64()),
                ("making the locks [s]", self.making_locks.as_secs_f64()),
            ]);
        }
        counters
    }
}
