//! Tasks 3.6 to 3.8: parallel loops over workers, and rebinning by one thread and by all.

use std::marker::PhantomData;
use std::ops::DerefMut;

use common::soft::{Observer, Particle, Scene, Simulation, Statistics, merged, read_by_id};
use rayon::ThreadPool;
use rayon::prelude::*;
use solution2::{Grid, VecBins};

use crate::{Worker, pool, rows_of_each};

/// How the change buffers are emptied.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rebinning {
    /// By one thread, while the others wait.
    ByOne,
    /// By all threads, each for the bins of its own rows.
    ByAll,
}

/// Two parallel loops over `workers`, on rayon's threads: in the first each worker sums the forces on
/// its particles, in the second each moves them.
///
/// `W` is a [`Worker`] in memory of its own, and is used like one. All workers read `bins` in the
/// first loop; in the second each has the bins of its own rows, which [`own_bins`] cuts out.
///
/// Book: chapter 3, *Parallel loops*.
pub fn sum_and_move<O, W>(workers: &mut [W], bins: &mut VecBins)
where
    O: Observer,
    W: DerefMut<Target = Worker<O>> + Send + Sync,
{
    let grid = *bins.grid();
    // task 3.6: parallel loops over workers
    workers.par_iter_mut().for_each(|worker| worker.sum_forces(bins));
    let own = own_bins(bins, workers);
    workers.par_iter_mut().zip(own).for_each(|(worker, own)| worker.move_particles(&grid, own));
    // end 3.6
}

/// Cuts the bins into the disjoint parts that belong to the workers, in their order.
// ANCHOR: own_bins
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
// ANCHOR_END: own_bins

/// Puts all particles of the change buffers into their bins.
///
/// `buffers` are those of all workers, in their order. Afterwards every particle is in the bin in
/// which it lies. (The buffers are cleared before the next move; here they are only read.)
///
/// Book: chapter 3, *Rebinning by one*.
pub fn rebin_by_one<'a>(bins: &mut VecBins, buffers: impl Iterator<Item = &'a [Particle]>) {
    // task 3.7: rebinning by one thread
    for particle in buffers.flatten() {
        bins.put(*particle);
    }
    // end 3.7
}

/// Puts the particles of the change buffers that lie in the own rows into their bins.
///
/// `own` are the bins of the own rows; the first has number `first_bin` in `grid`. `buffers` are
/// those of *all* workers, the own one among them; all workers read all of them at the same time.
///
/// Book: chapter 3, *Rebinning by all*.
pub fn take_arrivals<'a>(
    grid: &Grid,
    first_bin: usize,
    own: &mut [Vec<Particle>],
    buffers: impl Iterator<Item = &'a [Particle]>,
) {
    // task 3.8: rebinning by all
    for particle in buffers.flatten() {
        let bin = grid.bin(particle).checked_sub(first_bin).and_then(|bin| own.get_mut(bin));
        if let Some(bin) = bin {
            bin.push(*particle);
        }
    }
    // end 3.8
}

/// Fork and join: parallel loops over workers, at the end of which all threads wait.
///
/// `W` is a worker in memory of its own: `CachePadded<Worker<O>>` on cache lines of its own,
/// `Box<Worker<O>>` wherever the allocator puts it.
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
    /// An engine for `threads` threads and bins of `bin_size` cutoffs or more.
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

    // ANCHOR: step
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
    // ANCHOR_END: step

    fn read(&self, first: usize, out: &mut [Particle]) {
        read_by_id(self.bins.particles(), first, out);
    }

    fn statistics(&self) -> Option<Statistics> {
        merged(self.workers.iter().flat_map(|worker| &worker.seen))
    }
}
