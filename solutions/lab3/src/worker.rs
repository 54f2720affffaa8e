//! Tasks 3.4 and 3.5: what one thread does, with memory of its own.

use std::ops::Range;

use common::Vec2;
use common::soft::{Observer, Particle};
use solution1::advance;
use solution2::{Gather, Grid, VecBins, take_leavers};

/// A worker's own memory: no other thread writes here.
// ANCHOR: worker
#[derive(Debug)]
pub struct Worker<O> {
    /// The rows of bins whose particles this worker looks after.
    pub rows: Range<usize>,
    /// Of its own particles, in the order in which they lie in its bins.
    pub accelerations: Vec<Vec2>,
    /// Its change buffer: particles that have left their bin and are in none at present.
    pub changed: Vec<Particle>,
    /// What its particles' pairs were like in this step, for each of its rows.
    pub seen: Vec<O>,
    /// Sums the force on one particle.
    pub gather: Gather,
}
// ANCHOR_END: worker

impl<O: Observer> Worker<O> {
    /// The worker that owns `rows`, before its first step.
    pub fn new(rows: Range<usize>) -> Self {
        Self {
            rows,
            accelerations: Vec::new(),
            changed: Vec::new(),
            seen: Vec::new(),
            gather: Gather::default(),
        }
    }

    /// Fills [`accelerations`](Self::accelerations) for the particles in the bins of the own rows, and
    /// [`seen`](Self::seen) with one new observer for each row, in the order of rows.
    ///
    /// `bins` are those of the whole box: neighbours may lie in rows of other workers, which only
    /// read them now. [`Gather::acceleration`] of the worker's own [`gather`](Self::gather) does the sum of
    /// one particle, with [`VecBins::around`]. The two lists still hold those of the step before.
    ///
    /// Book: chapter 3, *Forces*.
    pub fn sum_forces(&mut self, bins: &VecBins) {
        let columns = bins.grid().columns();
        // task 3.4: the forces on a thread's own particles
        self.accelerations.clear();
        self.seen.clear();
        for row in self.rows.clone() {
            let mut observer = O::default();
            for bin in &bins.bins()[row * columns..][..columns] {
                for particle in bin {
                    let around = bins.around(particle);
                    let a = self.gather.acceleration(particle, around, &mut observer);
                    self.accelerations.push(a);
                }
            }
            self.seen.push(observer);
        }
        // end 3.4
    }

    /// Moves the particles in `own`, and takes those that left their bin into the change buffer.
    ///
    /// `own` are the bins of the own rows, row by row, and no other thread can touch them while this
    /// runs: that is what `&mut` means. The first of them has number `rows.start` · columns in
    /// `grid`. [`advance`] moves one particle, [`take_leavers`] (lab 2) takes out of one bin the
    /// particles that left it. A particle may leave for a bin of the same worker or of another; both
    /// go into the buffer. What is still in the buffer from the step before is in the bins by now.
    ///
    /// Book: chapter 3, *Change buffers*.
    pub fn move_particles(&mut self, grid: &Grid, own: &mut [Vec<Particle>]) {
        // task 3.5: move, and note down which particles left their bins
        self.changed.clear();
        let first = self.rows.start * grid.columns();
        let mut accelerations = self.accelerations.iter();
        for (bin, inside) in own.iter_mut().enumerate() {
            for (particle, a) in inside.iter_mut().zip(&mut accelerations) {
                advance(particle, *a, grid.size());
            }
            take_leavers(grid, first + bin, inside, &mut self.changed);
        }
        // end 3.5
    }
}
