//! Tasks 3.4 and 3.5: the work of one thread, in its own memory.

use std::ops::Range;

use common::Vec2;
use common::soft::{Observer, Particle};
use solution1::advance;
use solution2::{Gather, Grid, VecBins, take_leavers};

/// A worker's own memory, into which no other thread writes.
#[derive(Debug)]
pub struct Worker<O> {
    /// The rows of bins whose particles belong to this worker.
    pub rows: Range<usize>,
    /// The accelerations of the worker's particles, in the order of the particles in its bins.
    pub accelerations: Vec<Vec2>,
    /// The change buffer: particles that have left their bin and are not in any bin now.
    pub changed: Vec<Particle>,
    /// One observer for each of the worker's rows. It has seen the pairs of the row's particles in
    /// this step.
    pub seen: Vec<O>,
    /// The memory for the sum of the forces on one particle.
    pub gather: Gather,
}

impl<O: Observer> Worker<O> {
    /// Makes the worker that owns `rows`, before its first step.
    pub fn new(rows: Range<usize>) -> Self {
        Self {
            rows,
            accelerations: Vec::new(),
            changed: Vec::new(),
            seen: Vec::new(),
            gather: Gather::default(),
        }
    }

    /// Computes the accelerations of all particles in the worker's rows.
    ///
    /// - `bins` are the bins of the whole box. Neighbours may be in the rows of other workers.
    ///   During this phase, no worker writes to the bins.
    /// - [`accelerations`](Self::accelerations) gets one acceleration for each particle, in the
    ///   order of the bins.
    /// - [`seen`](Self::seen) gets one new observer for each row, in the order of rows.
    /// - At first, both lists contain the values of the previous step: clear them.
    ///
    /// The [`acceleration`](Gather::acceleration) method of the worker's [`gather`](Self::gather)
    /// computes the acceleration of one particle. [`VecBins::around`] returns the candidates.
    ///
    /// Book: chapter 3, *Forces*.
    pub fn sum_forces(&mut self, bins: &VecBins) {
        let columns = bins.grid().columns();
        todo!("task 3.4: the forces on a thread's own particles")
    }

    /// Moves the particles in `own`, and puts each particle that left its bin into the change buffer.
    ///
    /// - `own` are the bins of the worker's rows, row by row. The first of these bins has number
    ///   `rows.start` · columns in `grid`. `&mut` guarantees that no other thread can touch them
    ///   while this runs.
    /// - [`advance`] moves one particle. [`take_leavers`] of lab 2 removes from a bin the particles
    ///   that left it.
    /// - A particle may move to a bin of the same worker or of another worker. Put it into the
    ///   buffer in both cases.
    /// - At first, the buffer contains the particles of the previous step. These are already in the
    ///   bins: clear the buffer.
    ///
    /// Book: chapter 3, *Change buffers*.
    pub fn move_particles(&mut self, grid: &Grid, own: &mut [Vec<Particle>]) {
        todo!("task 3.5: move, and note down which particles left their bins")
    }
}
