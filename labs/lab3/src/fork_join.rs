//! Tasks 3.6 to 3.8: parallel loops over workers, and rebinning by one thread and by all.

use std::marker::PhantomData;
use std::ops::DerefMut;

use common::soft::{Observer, Particle, Scene, Simulation, Statistics, merged, read_by_id};
use rayon::ThreadPool;
use rayon::prelude::*;
use solution2::{Grid, VecBins};

use crate::{Worker, pool, rows_of_each};

/// The threads that empty the change buffers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rebinning {
    /// One thread empties all buffers, while the others wait.
    ByOne,
    /// All threads empty the buffers, each for the bins of its own rows.
    ByAll,
}

/// Sums the forces, then moves the particles, in two parallel loops over `workers`.
///
/// Both loops run on rayon's threads. In the first loop, each worker sums the forces on its
/// particles, and all workers read `bins`. In the second loop, each worker moves its particles, and
/// may access only the bins of its own rows. [`own_bins`] returns these bins for every worker.
///
/// `W` wraps a [`Worker`], so you can call the methods of `Worker` on it.
///
/// Book: chapter 3, *Parallel loops*.
pub fn sum_and_move<O, W>(workers: &mut [W], bins: &mut VecBins)
where
    O: Observer,
    W: DerefMut<Target = Worker<O>> + Send + Sync,
{
    let grid = *bins.grid();
    todo!("task 3.6: parallel loops over workers")
}

/// Cuts the bins into disjoint parts, one for each worker, in the order of the workers.
pub fn own_bins<'a, O: 'a, W>(bins: &'a mut VecBins, workers: &[W]) -> Vec<&'a mut [Vec<Particle>]>
where
    W: DerefMut<Target = Worker<O>>,
{
    let columns = bins.grid().columns();
    let mut rest = bins.bins_mut();
    let mut parts = Vec::with_capacity(workers.len());
    for worker in workers {
        let (own, behind) = rest.split_at_mut(worker.rows.len() * columns);
        parts.push(own);
        rest = behind;
    }
    parts
}

/// Puts all particles of the change buffers into their bins.
///
/// `buffers` are the change buffers of all workers, in the order of the workers. Afterwards, every
/// particle is in the bin that contains its position. (This function only reads the buffers.
/// Workers clear them before the next move.)
///
/// Book: chapter 3, *Rebinning by one*.
pub fn rebin_by_one<'a>(bins: &mut VecBins, buffers: impl Iterator<Item = &'a [Particle]>) {
    todo!("task 3.7: rebinning by one thread")
}

/// Puts particles of the change buffers into their bins, if these bins are in the worker's rows.
///
/// `own` are the bins of the worker's rows. The first of these bins has number `first_bin` in
/// `grid`. `buffers` are the change buffers of *all* workers, including this one. All workers read
/// all buffers at the same time.
///
/// Book: chapter 3, *Rebinning by all*.
pub fn take_arrivals<'a>(
    grid: &Grid,
    first_bin: usize,
    own: &mut [Vec<Particle>],
    buffers: impl Iterator<Item = &'a [Particle]>,
) {
    todo!("task 3.8: rebinning by all")
}

/// The fork-join engine: parallel loops over workers. All threads wait at the end of each loop.
///
/// `W` decides where each worker is in memory. A `CachePadded<Worker<O>>` has its own cache lines.
/// A `Box<Worker<O>>` is wherever the allocator puts it.
pub struct ForkJoin<O, W> {
    pool: ThreadPool,
    bin_size: f64,
    rebinning: Rebinning,
    bins: VecBins,
    workers: Vec<W>,
    observer: PhantomData<O>,
}

impl<O, W> ForkJoin<O, W>
where
    O: Observer,
    W: DerefMut<Target = Worker<O>> + From<Worker<O>> + Send + Sync,
{
    /// Makes an engine for `threads` threads, with bins at least `bin_size` cutoffs wide.
    pub fn new(threads: usize, bin_size: f64, rebinning: Rebinning) -> Self {
        Self {
            pool: pool(threads),
            bin_size,
            rebinning,
            bins: VecBins::default(),
            workers: Vec::new(),
            observer: PhantomData,
        }
    }
}

impl<O, W> Simulation for ForkJoin<O, W>
where
    O: Observer,
    W: DerefMut<Target = Worker<O>> + From<Worker<O>> + Send + Sync,
{
    fn load(&mut self, scene: &Scene) {
        self.bins = VecBins::of_scene(scene, self.bin_size);
        self.bins.refill(scene.particles());
        let rows = self.bins.grid().rows();
        let workers = rows_of_each(self.pool.current_num_threads(), rows).map(Worker::new);
        self.workers = workers.map(W::from).collect();
    }

    fn step(&mut self) {
        let Self { pool, rebinning, bins, workers, .. } = self;
        let grid = *bins.grid();
        pool.install(|| {
            sum_and_move(workers, bins);
            let buffers = || workers.iter().map(|worker| &worker.changed[..]);
            match rebinning {
                Rebinning::ByOne => rebin_by_one(bins, buffers()),
                Rebinning::ByAll => {
                    let own = own_bins(bins, workers);
                    workers.par_iter().zip(own).for_each(|(worker, own)| {
                        take_arrivals(&grid, worker.rows.start * grid.columns(), own, buffers());
                    });
                }
            }
        });
    }

    fn read(&self, first: usize, out: &mut [Particle]) {
        read_by_id(self.bins.particles(), first, out);
    }

    fn statistics(&self) -> Option<Statistics> {
        merged(self.workers.iter().flat_map(|worker| &worker.seen))
    }
}
