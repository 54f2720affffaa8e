//! Task 8.7: a master that decides, and workers that search.

use common::Event;
use common::hard::{Disc, Scene, Simulation};
use common_mpi::Traffic;
use mpi::traits::*;
use solution7::{Candidate, resolve, take_in_order};

use crate::engines::MasterWorkers;
use crate::{Deal, update};

impl MasterWorkers {
    /// What the master does with the candidates of all workers: takes those that happen, moves the
    /// discs that are in none of these straight on, and carries out the collisions taken.
    ///
    /// Lab 7 has the functions: [`take_in_order`] and [`resolve`]. `self.taken` is what happened in
    /// the step before, and is replaced; `self.tally.taken` counts it.
    ///
    /// Book: chapter 8, *A step of master and workers*.
    fn decide(&mut self, mut candidates: Vec<Candidate>) {
        self.tally.candidates += candidates.len() as u64;
        let mut free = vec![true; self.discs.len()];
        todo!("task 8.7b: the master decides")
    }

    /// One step.
    ///
    /// 1. If it is the first since the scene was loaded (`self.deal` is `None`), deal the pairs to
    ///    the workers of the team ([`Deal::new`]).
    /// 2. The master makes its lists ([`Self::lists`]; elsewhere there are none), and all call
    ///    [`Self::send`], which counts, calls [`hand_out`] and returns what arrived.
    /// 3. A worker that is not the master [`update`]s its discs, those of its blocks ([`Deal::blocks`]). They
    ///    have to be moved if this is not the first step and workers keep their blocks. The master's
    ///    discs are up to date.
    /// 4. A worker, the master too if it is one, looks for candidates ([`Self::find`]).
    /// 5. All call [`Self::receive`], which counts and calls [`collect`], and the master decides
    ///    ([`Self::decide`]).
    ///
    /// [`Team::worker`] says which worker a rank is. The functions of `self` that change it cannot borrow the
    /// deal from it at the same time: [take](Option::take) it out, and put it back at the end. All ranks call
    /// this together.
    ///
    /// Book: chapter 8, *A step of master and workers*.
    ///
    /// [`hand_out`]: crate::hand_out
    /// [`collect`]: crate::collect
    /// [`Team::worker`]: crate::Team::worker
    fn step_once(&mut self) {
        todo!("task 8.7: one step of master and workers")
    }
}

impl Simulation for MasterWorkers {
    fn load(&mut self, scene: &Scene) {
        self.start(scene);
    }

    fn step(&mut self) {
        let first = self.deal.is_none();
        self.traffic.begin_step();
        self.clock.begin_step();
        self.step_once();
        self.clock.end_step();
        if first && self.keep {
            // The blocks that workers keep are sent once, in no other step.
            self.traffic = Traffic::default();
        }
    }

    fn read(&self, first: usize, out: &mut [Disc]) {
        if self.is_master() {
            out.copy_from_slice(&self.discs[first..first + out.len()]);
        }
    }

    fn counters(&self) -> Vec<(&'static str, f64)> {
        let mut counters = self.tally.report(&self.world, &self.traffic);
        counters.extend(self.clock.report(&self.world));
        counters
    }

    fn events(&self) -> Option<Vec<Event>> {
        self.clock.events(&self.world)
    }
}
