//! Tasks 4.1, 4.4 and 4.5: how leavers get into their new bins.

use common::soft::Particle;
use crossbeam_queue::SegQueue;
use solution2::{Grid, VecBins};

use crate::{Meter, Regions};

/// Clears all bins and fills them again with all particles: those that are in `bins` now and those
/// in the change `buffers` of the threads. Only one thread runs this.
///
/// `all` is memory to collect them in; what it holds from the step before is of no use.
/// [`VecBins::refill`] clears and fills.
///
/// Book: chapter 4, *One thread*.
pub fn rebuild<'a>(
    bins: &mut VecBins,
    buffers: impl Iterator<Item = &'a [Particle]>,
    all: &mut Vec<Particle>,
) {
    todo!("task 4.1: one thread clears and fills again")
}

/// Puts the particles of one thread's change buffer into the bins that they lie in, each under the
/// lock of its region. All threads run this at the same time.
///
/// Take one lock at a time, by [`Meter::lock`], and hold it no longer than it takes to push one
/// particle. (Whoever held one lock while waiting for a second could meet a thread that does it
/// the other way round, and both would wait for ever.)
///
/// Book: chapter 4, *Many locks*.
pub fn put_all(grid: &Grid, regions: &Regions, leavers: &[Particle], meter: &mut Meter) {
    todo!("task 4.4: put the leavers into their bins, under locks")
}

/// Posts the particles of one thread's change buffer: each into the queue of the thread that owns
/// its row.
///
/// `owners[row]` is the owner of a row, `queues[owner]` its queue. All threads run this at the same
/// time, and nobody waits: [`SegQueue::push`] needs no lock.
///
/// Book: chapter 4, *Queues*.
pub fn post(grid: &Grid, owners: &[usize], queues: &[SegQueue<Particle>], leavers: &[Particle]) {
    todo!("task 4.5: hand the leavers over in queues")
}

/// Empties a thread's own queue into its own bins. Nobody posts any more when this runs.
///
/// `own` are the bins of its rows; the first of them has number `first_bin` in `grid`.
///
/// Book: chapter 4, *Queues*.
pub fn take(grid: &Grid, first_bin: usize, own: &mut [Vec<Particle>], queue: &SegQueue<Particle>) {
    todo!("task 4.5b: take what is in the own queue")
}
