//! Task 8.7: a master that decides, and workers that search.

use common::hard::{Disc, Scene, Simulation};
use common_mpi::Traffic;
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;
use solution5::Cut;
use solution7::{Candidate, Square, resolve, take_in_order, wall_hit};

use crate::tally::Tally;
use crate::{
    CandidateWire, Crew, Deal, DiscWire, MASTER, collect, collided, hand_out, look_at, update,
};

/// One rank of the job, master or worker.
// ANCHOR: engine
pub struct MasterWorkers {
    world: SimpleCommunicator,
    crew: Crew,
    /// Whether workers keep their blocks from step to step.
    keep: bool,
    square: Square,
    blocks: Cut,
    deal: Option<Deal>,
    /// A place for every disc of the scene. The master fills all; a worker those of its blocks.
    discs: Vec<Disc>,
    /// What happened in the last step. Only the master knows.
    taken: Vec<Candidate>,
    traffic: Traffic,
    tally: Tally,
}
// ANCHOR_END: engine

impl MasterWorkers {
    /// One rank of the `crew`, whose workers `keep` their blocks or get them anew in every step.
    pub fn new(world: SimpleCommunicator, crew: Crew, keep: bool) -> Self {
        Self {
            world,
            crew,
            keep,
            square: Square { side: 1.0, radius: 0.5 },
            blocks: Cut { rows: 1, ranks: 1 },
            deal: None,
            discs: Vec::new(),
            taken: Vec::new(),
            traffic: Traffic::default(),
            tally: Tally::default(),
        }
    }

    fn is_master(&self) -> bool {
        self.world.rank() == MASTER
    }

    /// What the master sends to each worker: all its blocks if it has none yet or does not keep
    /// them, else the discs of its blocks that have collided.
    fn lists(&self, deal: &Deal, first: bool) -> Vec<Vec<DiscWire>> {
        let all_of = |block: usize| {
            self.blocks.block(block).map(|number| DiscWire::new(number, &self.discs[number]))
        };
        let list = |worker: usize| {
            let held = deal.blocks(worker);
            if first || !self.keep {
                held.into_iter().flat_map(all_of).collect()
            } else {
                collided(&self.discs, &self.blocks, &held, &self.taken)
            }
        };
        (0..self.crew.workers).map(list).collect()
    }

    /// Everything that could happen in this step to the discs of `worker`'s own block (walls) and
    /// in its jobs (pairs).
    fn find(&mut self, deal: &Deal, worker: usize) -> Vec<CandidateWire> {
        let mut list: Vec<Candidate> = self
            .blocks
            .block(worker)
            .filter_map(|number| wall_hit(number as u32, &self.discs[number], self.square))
            .collect();
        for job in deal.jobs(worker) {
            let (discs, radius) = (&self.discs, self.square.radius);
            self.tally.pair_tests += look_at(discs, &self.blocks, &job, radius, &mut list);
        }
        list.iter().map(CandidateWire::from).collect()
    }

    /// What the master does with the candidates of all workers: takes those that happen, moves
    /// the discs that are in none of them straight on, and carries out the others.
    ///
    /// Lab 7 has the functions: [`take_in_order`] and [`resolve`]. `self.taken` is what happened in
    /// the step before, and is replaced.
    ///
    /// Book: chapter 8, *A step of master and workers*.
    fn decide(&mut self, mut candidates: Vec<Candidate>) {
        self.tally.candidates += candidates.len() as u64;
        let mut free = vec![true; self.discs.len()];
        // task 8.7b: the master decides
        self.taken.clear();
        take_in_order(&mut candidates, &mut free, &mut self.taken);
        for (disc, _) in self.discs.iter_mut().zip(&free).filter(|(_, free)| **free) {
            disc.x += disc.vx;
            disc.y += disc.vy;
        }
        resolve(&self.taken, &mut self.discs, self.square);
        self.tally.taken(&self.taken);
        // end 8.7b
    }

    /// One step.
    ///
    /// 1. If it is the first since the scene was loaded (`self.deal` is `None`), deal the pairs to
    ///    the workers of the crew.
    /// 2. The master makes its lists ([`Self::lists`]; elsewhere there are none), and all call
    ///    [`Self::send`], which counts and calls [`hand_out`].
    /// 3. A worker on a rank of its own [`update`]s its discs. They have to be moved if this is not
    ///    the first step and workers keep their blocks. The discs of the master are right as they
    ///    are.
    /// 4. A worker, the master too if it is one, looks for candidates ([`Self::find`]).
    /// 5. All call [`Self::receive`], which counts and calls [`collect`], and the master decides
    ///    ([`Self::decide`]).
    ///
    /// [`Crew::worker`] says which worker a rank is. All ranks call it together.
    ///
    /// Book: chapter 8, *A step of master and workers*.
    fn step_once(&mut self) {
        // task 8.7: one step of master and workers
        let first = self.deal.is_none();
        let deal = self.deal.take().unwrap_or_else(|| Deal::new(self.crew.workers));
        let lists = if self.is_master() { self.lists(&deal, first) } else { Vec::new() };
        let arrived = self.send(&lists);
        let worker = self.crew.worker(self.world.rank());
        if let Some(worker) = worker.filter(|_| !self.is_master()) {
            let held: Vec<_> =
                deal.blocks(worker).into_iter().map(|block| self.blocks.block(block)).collect();
            update(&mut self.discs, &held, !first && self.keep, &arrived);
        }
        let found = worker.map_or_else(Vec::new, |worker| self.find(&deal, worker));
        let candidates = self.receive(&found);
        if self.is_master() {
            self.decide(candidates);
        }
        self.deal = Some(deal);
        // end 8.7
    }

    /// [`hand_out`], counted.
    fn send(&mut self, lists: &[Vec<DiscWire>]) -> Vec<DiscWire> {
        for (worker, list) in lists.iter().enumerate() {
            if self.crew.rank(worker) != MASTER {
                self.traffic.sent(list);
            }
        }
        hand_out(&self.world, self.crew, lists)
    }

    /// [`collect`], counted.
    fn receive(&mut self, found: &[CandidateWire]) -> Vec<Candidate> {
        if !self.is_master() {
            self.traffic.sent(found);
        }
        let all = collect(&self.world, self.crew, found);
        all.iter().map(Candidate::from).collect()
    }
}

impl Simulation for MasterWorkers {
    fn load(&mut self, scene: &Scene) {
        self.square = Square::of(scene);
        self.blocks = Cut { rows: scene.len(), ranks: self.crew.workers };
        // What a worker sees of the scene comes in messages.
        self.discs = match self.is_master() {
            true => scene.discs().to_vec(),
            false => vec![Disc::default(); scene.len()],
        };
        self.deal = None;
        self.taken.clear();
        self.traffic = Traffic::default();
        self.tally = Tally::default();
    }

    fn step(&mut self) {
        self.traffic.begin_step();
        self.step_once();
    }

    fn read(&self, first: usize, out: &mut [Disc]) {
        if self.is_master() {
            out.copy_from_slice(&self.discs[first..first + out.len()]);
        }
    }

    fn counters(&self) -> Vec<(&'static str, f64)> {
        self.tally.report(&self.world, &self.traffic)
    }
}
