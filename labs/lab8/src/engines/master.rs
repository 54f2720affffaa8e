//! What a rank of master and workers keeps, sends and finds.

use common::hard::{Disc, Scene};
use common_mpi::{Clock, Partners, Traffic};
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;
use solution5::Cut;
use solution7::{Candidate, Square, wall_hit};

use crate::ranks::Tally;
use crate::{CandidateWire, Deal, DiscWire, MASTER, Team, collect, collided, hand_out, search_job};

/// One rank of the job, master or worker.
pub struct MasterWorkers {
    pub(crate) world: SimpleCommunicator,
    pub(crate) team: Team,
    /// Whether workers keep their blocks from step to step.
    pub(crate) keep: bool,
    pub(crate) square: Square,
    pub(crate) blocks: Cut,
    pub(crate) deal: Option<Deal>,
    /// An entry for every disc of the scene. The master fills all, a worker its blocks.
    pub(crate) discs: Vec<Disc>,
    /// What happened in the last step; empty on workers.
    pub(crate) taken: Vec<Candidate>,
    pub(crate) traffic: Traffic,
    pub(crate) tally: Tally,
    pub(crate) clock: Clock,
}

impl MasterWorkers {
    /// One rank of the `team`, whose workers `keep` their blocks or get them again in every step.
    pub fn new(world: SimpleCommunicator, team: Team, keep: bool, clock: Clock) -> Self {
        Self {
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

    /// Starts over from `scene`.
    pub(crate) fn start(&mut self, scene: &Scene) {
        self.square = Square::of(scene);
        self.blocks = Cut { rows: scene.len(), ranks: self.team.workers };
        // What a worker sees of the scene comes in messages.
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

    pub(crate) fn is_master(&self) -> bool {
        self.world.rank() == MASTER
    }

    /// What the master sends to each worker: all its blocks if it has none yet or does not keep
    /// them, else the discs of its blocks that have collided.
    pub(crate) fn lists(&self, deal: &Deal, first: bool) -> Vec<Vec<DiscWire>> {
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
        (0..self.team.workers).map(list).collect()
    }

    /// Everything that could happen in this step to the discs of `worker`'s own block (walls) and
    /// in its jobs (pairs).
    pub(crate) fn find(&mut self, deal: &Deal, worker: usize) -> Vec<CandidateWire> {
        let mut list: Vec<Candidate> = self
            .blocks
            .block(worker)
            .filter_map(|number| wall_hit(number as u32, &self.discs[number], self.square))
            .collect();
        for job in deal.jobs(worker) {
            let (discs, radius) = (&self.discs, self.square.radius);
            self.tally.pair_tests += search_job(discs, &self.blocks, &job, radius, &mut list);
        }
        list.iter().map(CandidateWire::from).collect()
    }

    /// [`hand_out`], timed and counted.
    pub(crate) fn send(&mut self, lists: &[Vec<DiscWire>]) -> Vec<DiscWire> {
        for (worker, list) in lists.iter().enumerate() {
            if self.team.rank(worker) != MASTER {
                self.traffic.sent(list);
            }
        }
        self.clock.call(Partners::Through(MASTER), || hand_out(&self.world, self.team, lists))
    }

    /// [`collect`], timed and counted.
    pub(crate) fn receive(&mut self, found: &[CandidateWire]) -> Vec<Candidate> {
        if !self.is_master() {
            self.traffic.sent(found);
        }
        let call = || collect(&self.world, self.team, found);
        let all = self.clock.call(Partners::Through(MASTER), call);
        all.iter().map(Candidate::from).collect()
    }
}
