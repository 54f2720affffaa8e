//! Tasks 3.5 and 3.6: rebinning, by one thread and by all.

use std::marker::PhantomData;
use std::ops::DerefMut;

use common::soft::{Observer, Particle, Scene, Simulation, Statistics, read_by_id};
use rayon::ThreadPool;
use rayon::prelude::*;
use solution2::{Grid, VecBins};

use crate::{Desk, rows_of_each, team};

/// Who empties the change buffers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rebinning {
    /// One thread, while the others wait.
    ByOne,
    /// Every thread, for the bins of its own rows.
    ByAll,
}

/// Puts all particles of the change buffers into their bins.
///
/// `buffers` are those of all threads, in their order. Afterwards every particle is in the bin in
/// which it lies. (The buffers are cleared before the next move; here they are only read.)
///
/// Book: chapter 3, *Rebinning by one*.
pub fn rebin_by_one<'a>(bins: &mut VecBins, buffers: impl Iterator<Item = &'a [Particle]>) {
    todo!("task 3.5: rebinning by one thread")
}

/// Puts those particles of the change buffers that lie in the own rows into their bins.
///
/// `own` are the bins of the own rows; the first has number `first_bin` in `grid`. `buffers` are
/// those of *all* threads, one's own among them: everybody reads all of them and takes what is
/// theirs. Nobody asks for a lock, because nobody writes where another one writes.
///
/// Book: chapter 3, *Rebinning by all*.
pub fn take_arrivals<'a>(
    grid: &Grid,
    first_bin: usize,
    own: &mut [Vec<Particle>],
    buffers: impl Iterator<Item = &'a [Particle]>,
) {
    todo!("task 3.6: rebinning by all")
}

/// Fork and join: three parallel loops a step, a desk for every thread.
///
/// `D` is a desk in a place of its own: `CachePadded<Desk<O>>` on cache lines of its own,
/// `Box<Desk<O>>` wherever the allocator puts it.
pub struct ForkJoin<O, D> {
    team: ThreadPool,
    bin_size: f64,
    rebinning: Rebinning,
    bins: VecBins,
    desks: Vec<D>,
    observer: PhantomData<O>,
}

impl<O, D> ForkJoin<O, D>
where
    O: Observer,
    D: DerefMut<Target = Desk<O>> + From<Desk<O>> + Send + Sync,
{
    /// An engine for `threads` threads and bins of `bin_size` cutoffs or more.
    pub fn new(threads: usize, bin_size: f64, rebinning: Rebinning) -> Self {
        Self {
            team: team(threads),
            bin_size,
            rebinning,
            bins: VecBins::new(Grid::with_bins_along(1.0, 1)),
            desks: Vec::new(),
            observer: PhantomData,
        }
    }
}

impl<O, D> Simulation for ForkJoin<O, D>
where
    O: Observer,
    D: DerefMut<Target = Desk<O>> + From<Desk<O>> + Send + Sync,
{
    fn load(&mut self, scene: &Scene) {
        self.bins = VecBins::of_scene(scene, self.bin_size);
        self.bins.refill(scene.particles());
        let rows = self.bins.grid().rows();
        let desks = rows_of_each(self.team.current_num_threads(), rows).map(Desk::new);
        self.desks = desks.map(D::from).collect();
    }

    fn step(&mut self) {
        let Self { team, rebinning, bins, desks, .. } = self;
        let grid = *bins.grid();
        team.install(|| {
            desks.par_iter_mut().for_each(|desk| desk.sum_forces(bins));

            let own = own_bins(bins, desks);
            desks.par_iter_mut().zip(own).for_each(|(desk, own)| desk.move_particles(&grid, own));

            let buffers = || desks.iter().map(|desk| &desk.changed[..]);
            match rebinning {
                Rebinning::ByOne => rebin_by_one(bins, buffers()),
                Rebinning::ByAll => {
                    let own = own_bins(bins, desks);
                    desks.par_iter().zip(own).for_each(|(desk, own)| {
                        take_arrivals(&grid, desk.rows.start * grid.columns(), own, buffers());
                    });
                }
            }
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
}

/// Cuts the bins into the disjoint parts that belong to the desks.
pub fn own_bins<'a, O: 'a, D>(bins: &'a mut VecBins, desks: &[D]) -> Vec<&'a mut [Vec<Particle>]>
where
    D: DerefMut<Target = Desk<O>>,
{
    let columns = bins.grid().columns();
    let mut rest = bins.bins_mut();
    let mut parts = Vec::with_capacity(desks.len());
    for desk in desks {
        let (own, others) = rest.split_at_mut(desk.rows.len() * columns);
        parts.push(own);
        rest = others;
    }
    parts
}
