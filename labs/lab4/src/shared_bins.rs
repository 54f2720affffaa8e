//! Given: the engine around tasks 4.1 to 4.9.

use std::slice;
use std::sync::Arc;
use std::time::{Duration, Instant};

use common::Vec2;
use common::soft::{Observer, Particle, Scene, Simulation, Statistics, merged};
use common_threads::{LockOrder, Watch};
use crossbeam::channel::{Receiver, Sender, unbounded};
use crossbeam::queue::SegQueue;
use crossbeam::utils::CachePadded;
use rayon::ThreadPool;
use rayon::prelude::*;
use solution2::{Gather, Grid};
use solution3::pool;

use crate::{
    Bin, Change, Meter, Regions, View, apply_all, apply_own, change_bin, claim, move_own, post,
    rebuild, receive, send, take,
};

/// The method of bringing bins up to date.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    /// One thread empties all bins and fills them again.
    Rebuild {
        /// Whether bins allocate new memory in each step, instead of keeping their memory.
        fresh: bool,
    },
    /// Change buffers, emptied by one thread.
    BuffersByOne,
    /// Change buffers, emptied by all threads.
    BuffersByAll,
    /// Each particle changes its bin as soon as it has moved. This is the number of locks.
    Locks(usize),
    /// Changes are passed through the owners' queues.
    Queues,
    /// Changes are passed through the owners' channels.
    Channels,
    /// Every thread empties its own bins, and fills them from the list of all particles.
    Owners,
}

/// An engine whose threads divide the particles by number, and share the bins.
///
/// A thread sums the forces on its particles and moves them, wherever they are in the box. The
/// [`Way`] determines only how the bins are brought up to date.
pub struct SharedBins<O> {
    pool: ThreadPool,
    bin_size: f64,
    way: Way,
    grid: Grid,
    /// All particles, in the order of their numbers.
    particles: Vec<Particle>,
    regions: Regions,
    workers: Vec<CachePadded<Worker<O>>>,
    /// The change buffer of each thread.
    buffers: Vec<CachePadded<Vec<Change>>>,
    queues: Vec<SegQueue<Change>>,
    senders: Vec<Sender<Change>>,
    receivers: Vec<Receiver<Change>>,
    making_locks: Duration,
    stepping: Duration,
}

/// The private memory of a thread.
#[derive(Debug, Default)]
struct Worker<O> {
    /// The accelerations of the thread's particles, in the order of the particles.
    accelerations: Vec<Vec2>,
    /// One observer for each block of the thread's particles. It has seen the block's pairs in this
    /// step.
    seen: Vec<O>,
    gather: Gather,
    meter: Meter,
}

/// The number of particles that share an observer.
///
/// The number is small, so that many threads have particles even in a small scene. It is fixed, so
/// that sums do not depend on the number of threads.
const BLOCK: usize = 8;

impl<O: Observer> Worker<O> {
    fn sum_forces(&mut self, grid: &Grid, bins: &View, all: &[Particle], own: &[Particle]) {
        let start = Instant::now();
        for block in own.chunks(BLOCK) {
            let mut observer = O::default();
            for particle in block {
                let columns = grid.near(grid.column(particle.x));
                let near = grid.near(grid.row(particle.y)).flat_map(|row| {
                    columns.clone().flat_map(move |column| bins.bin(row * grid.columns() + column))
                });
                let around = near.map(|number| slice::from_ref(&all[*number as usize]));
                self.accelerations.push(self.gather.acceleration(particle, around, &mut observer));
            }
            self.seen.push(observer);
        }
        self.meter.forces += start.elapsed();
    }
}

impl<O: Observer> SharedBins<O> {
    /// Makes an engine for `threads` threads, with bins of `bin_size` cutoffs or more.
    pub fn new(threads: usize, bin_size: f64, way: Way) -> Self {
        let queues = (0..threads).map(|_| SegQueue::new()).collect();
        let (senders, receivers) = (0..threads).map(|_| unbounded()).unzip();
        Self {
            pool: pool(threads),
            bin_size,
            way,
            grid: Grid::default(),
            particles: Vec::new(),
            regions: Regions { cut: crate::Cut { bins_each: 1 }, locks: Vec::new() },
            workers: Vec::new(),
            buffers: vec![CachePadded::default(); threads],
            queues,
            senders,
            receivers,
            making_locks: Duration::ZERO,
            stepping: Duration::ZERO,
        }
    }

    /// The number of particles that each thread has. The last thread may have fewer.
    fn share(&self) -> usize {
        let threads = self.pool.current_num_threads();
        self.particles.len().div_ceil(threads).next_multiple_of(BLOCK)
    }

    /// Moves all particles, in all threads. Each thread reports a change of bin as soon as the
    /// change happens.
    fn move_all(&mut self) {
        let Self { way, grid, particles, regions, workers, buffers, queues, senders, .. } = self;
        let threads = workers.par_iter_mut().zip(buffers);
        self.pool.install(|| {
            let share = particles.len().div_ceil(threads.len()).next_multiple_of(BLOCK);
            particles.par_chunks_mut(share).zip(threads).for_each(|(own, (worker, buffer))| {
                let start = Instant::now();
                let Worker { accelerations, meter, .. } = &mut **worker;
                match way {
                    Way::Locks(_) => move_own(grid, own, accelerations, |change| {
                        change_bin(regions, meter, change);
                    }),
                    Way::Queues => {
                        move_own(grid, own, accelerations, |change| {
                            post(regions.cut, queues, change);
                        });
                    }
                    Way::Channels => {
                        move_own(grid, own, accelerations, |change| {
                            send(regions.cut, senders, change);
                        });
                    }
                    Way::BuffersByOne | Way::BuffersByAll => {
                        buffer.clear();
                        move_own(grid, own, accelerations, |change| buffer.push(change));
                    }
                    Way::Rebuild { .. } | Way::Owners => move_own(grid, own, accelerations, |_| ()),
                }
                worker.meter.moving += start.elapsed();
            });
        });
    }

    /// Does the rest of the rebinning, when all particles have moved.
    fn rebin(&mut self) {
        let start = Instant::now();
        let Self { way, grid, particles, regions, workers, buffers, queues, receivers, .. } = self;
        let changes = || buffers.iter().flat_map(|buffer| buffer.iter().copied());
        let cut = regions.cut;
        match way {
            Way::Locks(_) => (),
            Way::Rebuild { fresh } => {
                if *fresh {
                    regions.parts_mut().flatten().for_each(|bin| *bin = Bin::new());
                }
                rebuild(regions, grid, particles);
                workers[0].meter.rebinning += start.elapsed();
            }
            Way::BuffersByOne => {
                apply_all(regions, buffers.iter().map(|buffer| &buffer[..]));
                workers[0].meter.rebinning += start.elapsed();
            }
            Way::BuffersByAll | Way::Queues | Way::Channels | Way::Owners => {
                let parts: Vec<_> = regions.parts_mut().collect();
                self.pool.install(|| {
                    let threads = parts.into_par_iter().zip(workers).enumerate();
                    threads.for_each(|(own, (bins, worker))| {
                        let start = Instant::now();
                        match way {
                            Way::Queues => take(cut, own, bins, &queues[own]),
                            Way::Channels => receive(cut, own, bins, &receivers[own]),
                            Way::Owners => claim(cut, own, bins, grid, particles),
                            _ => apply_own(cut, own, bins, changes()),
                        }
                        worker.meter.rebinning += start.elapsed();
                    });
                });
            }
        }
    }
}

impl<O: Observer> Simulation for SharedBins<O> {
    fn load(&mut self, scene: &Scene) {
        self.grid = Grid::of_scene(scene, self.bin_size);
        self.particles = scene.particles().to_vec();
        let threads = self.pool.current_num_threads();
        let count = match self.way {
            Way::Rebuild { .. } | Way::BuffersByOne => 1,
            Way::Locks(count) => count.min(self.grid.bins()),
            _ => threads,
        };
        let start = Instant::now();
        self.regions = Regions::new(self.grid.bins(), count);
        self.making_locks = start.elapsed();
        if cfg!(debug_assertions) {
            let watch: Arc<dyn Watch> = Arc::new(LockOrder::default());
            self.regions.watch(&watch);
        }
        for particle in &self.particles {
            self.regions.bin_mut(self.grid.bin(particle)).push(particle.id);
        }
        self.workers = (0..threads).map(|_| CachePadded::default()).collect();
        self.stepping = Duration::ZERO;
    }

    fn step(&mut self) {
        let (start, share) = (Instant::now(), self.share());
        let Self { pool, grid, particles, regions, workers, .. } = self;
        let bins = regions.view();
        for worker in workers.iter_mut() {
            worker.accelerations.clear();
            worker.seen.clear();
        }
        pool.install(|| {
            particles.par_chunks(share).zip(workers).for_each(|(own, worker)| {
                worker.sum_forces(grid, &bins, particles, own);
            });
        });
        self.move_all();
        self.rebin();
        self.stepping += start.elapsed();
    }

    fn read(&self, first: usize, out: &mut [Particle]) {
        out.copy_from_slice(&self.particles[first..first + out.len()]);
    }

    fn statistics(&self) -> Option<Statistics> {
        merged(self.workers.iter().flat_map(|worker| &worker.seen))
    }

    fn counters(&self) -> Vec<(&'static str, f64)> {
        let sum = Meter::sum(self.workers.iter().map(|worker| &worker.meter));
        let all = self.stepping * self.workers.len() as u32;
        let idle = all.saturating_sub(sum.forces + sum.moving + sum.rebinning);
        let mut counters = vec![
            ("forces, all threads [s]", sum.forces.as_secs_f64()),
            ("moving, all threads [s]", sum.moving.as_secs_f64()),
            ("rebinning, all threads [s]", sum.rebinning.as_secs_f64()),
            ("waiting for other threads, all threads [s]", idle.as_secs_f64()),
        ];
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
