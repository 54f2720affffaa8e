//! The engine with a master and workers: the data of a rank, its messages and its search.

use std::marker::PhantomData;

use common::Event;
use common::hard::{Disc, Scene, Simulation};
use common_mpi::{Clock, Partners, Traffic};
use hard_discs::{Candidate, Collisions, Square};
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;
use solution5::Cut;

use crate::deal::{Deal, Job};
use crate::tally::Tally;
use crate::team::{MASTER, Messages, Team};
use crate::wire::{CandidateWire, DiscWire};

/// The work of a master and its workers: the master distributes pairs and decides, and the workers
/// search.
pub trait Dealing: Messages {
    /// The rules of a collision.
    type Rules: Collisions;

    /// Returns the distribution of all pairs to a number of workers.
    fn deal(workers: usize) -> Deal;

    /// Returns the jobs of a worker. Together, all workers have every pair of blocks exactly once.
    fn jobs(deal: &Deal, worker: usize) -> Vec<Job>;

    /// Tests the pairs of a job, and appends the pairs that collide in this step to `list`.
    ///
    /// `discs` has an element for every disc of the scene. Returns the number of pairs that were
    /// tested.
    fn search_job(
        discs: &[Disc],
        blocks: &Cut,
        job: &Job,
        radius: f64,
        list: &mut Vec<Candidate>,
    ) -> u64;

    /// Returns the discs of the blocks `held` that have collided; `discs` are all discs after the
    /// step.
    fn collided(discs: &[Disc], blocks: &Cut, held: &[usize], taken: &[Candidate])
    -> Vec<DiscWire>;

    /// Takes one step. All ranks call this function together.
    fn step(engine: &mut MasterWorkers<Self>);
}

/// One rank of the job, master or worker.
pub struct MasterWorkers<T> {
    tasks: PhantomData<T>,
    /// The communicator of all ranks.
    pub world: SimpleCommunicator,
    /// The assignment of workers to ranks.
    pub team: Team,
    /// Whether workers keep their blocks from step to step.
    pub keep: bool,
    /// The square, and the radius of all discs.
    pub square: Square,
    /// The discs in blocks, one for each worker.
    pub blocks: Cut,
    /// The distribution of pairs; `None` before the first step.
    pub deal: Option<Deal>,
    /// An element for every disc of the scene. All elements of the master are valid, but only the
    /// elements in a worker's blocks are valid on the worker.
    pub discs: Vec<Disc>,
    /// The collisions of the last step; empty on workers.
    pub taken: Vec<Candidate>,
    /// The messages that this rank has sent.
    pub traffic: Traffic,
    /// The counters of this rank.
    pub tally: Tally,
    /// The time that calls to the MPI library took.
    pub clock: Clock,
}

impl<T: Dealing> MasterWorkers<T> {
    /// Makes one rank of the `team`. Its workers `keep` their blocks, or receive them again in
    /// every step.
    pub fn new(world: SimpleCommunicator, team: Team, keep: bool, clock: Clock) -> Self {
        Self {
            tasks: PhantomData,
            world,
            team,
            keep,
            square: Square { side: 1.0, radius: 0.5 },
            blocks: Cut { rows: 1, ranks: 1 },
            deal: None,
            discs: Vec::new(),
            taken: Vec::new(),
            traffic: Traffic::default(),
            tally: Tally::default(),
            clock,
        }
    }

    /// Whether this rank is the master.
    pub fn is_master(&self) -> bool {
        self.world.rank() == MASTER
    }

    /// Returns the lists that the master sends to the workers.
    ///
    /// A worker receives all its blocks if it has no blocks yet or does not keep them. Otherwise it
    /// receives the discs of its blocks that have collided.
    pub fn lists(&self, deal: &Deal, first: bool) -> Vec<Vec<DiscWire>> {
        let mut lists = Vec::with_capacity(self.team.workers);
        for worker in 0..self.team.workers {
            let held = deal.blocks(worker);
            lists.push(if first || !self.keep {
                let numbers = held.into_iter().flat_map(|block| self.blocks.block(block));
                numbers.map(|number| DiscWire::new(number, &self.discs[number])).collect()
            } else {
                T::collided(&self.discs, &self.blocks, &held, &self.taken)
            });
        }
        lists
    }

    /// Returns the candidates that `worker` finds: its own block with walls, and the pairs of its
    /// jobs.
    pub fn find(&mut self, deal: &Deal, worker: usize) -> Vec<CandidateWire> {
        let mut list: Vec<Candidate> = self
            .blocks
            .block(worker)
            .filter_map(|number| {
                <T::Rules>::wall_hit(number as u32, &self.discs[number], self.square)
            })
            .collect();
        for job in T::jobs(deal, worker) {
            let radius = self.square.radius;
            self.tally.pair_tests +=
                T::search_job(&self.discs, &self.blocks, &job, radius, &mut list);
        }
        list.iter().map(CandidateWire::from).collect()
    }

    /// Calls [`Messages::hand_out`], times the call, and counts its messages.
    pub fn send(&mut self, lists: &[Vec<DiscWire>]) -> Vec<DiscWire> {
        for (worker, list) in lists.iter().enumerate() {
            if self.team.rank(worker) != MASTER {
                self.traffic.sent(list);
            }
        }
        self.clock.call(Partners::Through(MASTER), || T::hand_out(&self.world, self.team, lists))
    }

    /// Calls [`Messages::collect`], times the call, and counts its message.
    pub fn receive(&mut self, found: &[CandidateWire]) -> Vec<Candidate> {
        if !self.is_master() {
            self.traffic.sent(found);
        }
        let all = self
            .clock
            .call(Partners::Through(MASTER), || T::collect(&self.world, self.team, found));
        all.iter().map(Candidate::from).collect()
    }
}

impl<T: Dealing> Simulation for MasterWorkers<T> {
    fn load(&mut self, scene: &Scene) {
        self.square = Square::of(scene);
        self.blocks = Cut { rows: scene.len(), ranks: self.team.workers };
        // A worker receives its discs only in messages.
        self.discs = match self.is_master() {
            true => scene.discs().to_vec(),
            false => vec![Disc::default(); scene.len()],
        };
        self.deal = None;
        self.taken.clear();
        self.traffic = Traffic::default();
        self.tally = Tally::default();
        self.clock.start(&self.world);
    }

    fn step(&mut self) {
        let first = self.deal.is_none();
        self.traffic.begin_step();
        self.clock.begin_step();
        T::step(self);
        self.clock.end_step();
        if first && self.keep {
            // The blocks that workers keep are sent only once, so the first step is not counted.
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
