//! The engine that takes steps as the report's program does: the workers move the discs.

use common::Event;
use common::hard::{Disc, Scene, Simulation};
use common_mpi::{Clock, Partners};
use hard_discs::{Candidate, Collisions, resolve};
use mpi::collective::SystemOperation;
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;

use crate::deal::Deal;
use crate::master_workers::{Dealing, MasterWorkers};
use crate::queues::slots_of as discs_of;
use crate::team::{MASTER, Team};
use crate::wire::{CandidateWire, DiscWire};

/// Master and workers as in the report.
///
/// In each step the workers receive their blocks again and send back the candidates that they find.
/// The master takes the candidates that really happen, and sends them to the workers. Then the
/// workers move discs: each worker its own block (the report's `major_chunk`) and the other discs
/// of the collisions that it carries out (`extra_send`). They send back the moved discs. The master
/// sends with blocking calls, to one worker after the other.
pub struct AsReported<T> {
    base: MasterWorkers<T>,
    deal: Deal,
    /// Number of discs that this rank has sent back from outside its own block.
    extra: u64,
    steps: u64,
}

impl<T: Dealing> AsReported<T> {
    /// Makes the engine of one rank of `world`.
    pub fn new(world: SimpleCommunicator, clock: Clock) -> Self {
        let team = Team::new(world.size() as usize, false);
        let deal = Deal { workers: team.workers, offsets: Vec::new() };
        Self { base: MasterWorkers::new(world, team, false, clock), deal, extra: 0, steps: 0 }
    }

    /// Sends each worker its list. The master waits until each message is sent before it sends the
    /// next one.
    fn send<W: Equivalence + Clone>(&mut self, lists: &[Vec<W>]) -> Vec<W> {
        let MasterWorkers { world, team, traffic, clock, .. } = &mut self.base;
        clock.call(Partners::Through(MASTER), || {
            if world.rank() != MASTER {
                return world.process_at_rank(MASTER).receive_vec().0;
            }
            let mut own = Vec::new();
            for (worker, list) in lists.iter().enumerate() {
                match team.rank(worker) {
                    MASTER => own.clone_from(list),
                    rank => {
                        traffic.sent(list);
                        world.process_at_rank(rank).send(&list[..]);
                    }
                }
            }
            own
        })
    }

    /// Returns the blocks that contain a collision's discs.
    fn blocks_of(&self, candidate: &Candidate) -> impl Iterator<Item = usize> + Clone {
        let blocks = self.base.blocks;
        discs_of(candidate).map(move |disc| blocks.owner(disc))
    }

    /// Returns the worker that carries out a collision.
    ///
    /// This worker holds a copy of the block of each disc in the collision. If possible, the method
    /// chooses a worker that owns one of these blocks.
    fn carrier(&self, candidate: &Candidate) -> usize {
        let blocks = self.blocks_of(candidate);
        let mut workers = blocks.clone().chain(0..self.deal.workers);
        let carrier = workers.find(|worker| {
            let held = self.deal.blocks(*worker);
            blocks.clone().all(|block| held.contains(&block))
        });
        carrier.expect("some worker has looked at the pair")
    }

    /// Returns the orders for each worker: the collisions that it carries out, and all other
    /// collisions with discs of its own block.
    fn orders(&self) -> Vec<Vec<CandidateWire>> {
        let mut orders = vec![Vec::new(); self.deal.workers];
        for candidate in &self.base.taken {
            let mut workers: Vec<usize> =
                self.blocks_of(candidate).chain([self.carrier(candidate)]).collect();
            workers.sort_unstable();
            workers.dedup();
            workers.into_iter().for_each(|worker| orders[worker].push(candidate.into()));
        }
        orders
    }

    /// Moves the discs that `worker` must move, and returns them.
    fn carry_out(&mut self, worker: usize, orders: &[CandidateWire]) -> Vec<DiscWire> {
        let (carried, left): (Vec<Candidate>, Vec<Candidate>) =
            orders.iter().map(Candidate::from).partition(|order| self.carrier(order) == worker);
        let own = self.base.blocks.block(worker);
        let mut moves = vec![false; self.base.discs.len()];
        moves[own.clone()].fill(true);
        left.iter().flat_map(discs_of).for_each(|disc| moves[disc] = false);
        carried.iter().flat_map(discs_of).for_each(|disc| moves[disc] = false);
        let discs = &mut self.base.discs;
        for disc in own.clone().filter(|&disc| moves[disc]) {
            discs[disc].x += discs[disc].vx;
            discs[disc].y += discs[disc].vy;
        }
        resolve::<T::Rules>(&carried, discs, self.base.square);
        carried.iter().flat_map(discs_of).for_each(|disc| moves[disc] = true);
        let moved = (0..discs.len()).filter(|&disc| moves[disc]);
        let moved: Vec<DiscWire> = moved.map(|disc| DiscWire::new(disc, &discs[disc])).collect();
        self.extra += moved.iter().filter(|wire| !own.contains(&wire.index())).count() as u64;
        moved
    }

    fn put(&mut self, arrived: &[DiscWire]) {
        arrived.iter().for_each(|wire| self.base.discs[wire.index()] = wire.into());
    }

    fn step_once(&mut self) {
        let master = self.base.is_master();
        let worker = self.base.team.worker(self.base.world.rank());
        let blocks = if master { self.base.lists(&self.deal, true) } else { Vec::new() };
        let arrived = self.send(&blocks);
        self.put(&arrived);
        let found = worker.map_or_else(Vec::new, |worker| self.base.find(&self.deal, worker));
        let mut candidates = self.base.receive(&found);
        let mut orders = Vec::new();
        if master {
            let MasterWorkers { taken, tally, discs, .. } = &mut self.base;
            tally.candidates += candidates.len() as u64;
            taken.clear();
            T::Rules::take_in_order(&mut candidates, &mut vec![true; discs.len()], taken);
            tally.taken(taken);
            orders = self.orders();
        }
        let orders = self.send(&orders);
        let moved = worker.map_or_else(Vec::new, |worker| self.carry_out(worker, &orders));
        let MasterWorkers { world, team, traffic, clock, .. } = &mut self.base;
        if !master {
            traffic.sent(&moved);
        }
        let all = clock.call(Partners::Through(MASTER), || T::collect(world, *team, &moved));
        self.put(&all);
    }
}

impl<T: Dealing> Simulation for AsReported<T> {
    fn load(&mut self, scene: &Scene) {
        self.base.load(scene);
        self.deal = T::deal(self.base.team.workers);
        self.extra = 0;
        self.steps = 0;
    }

    fn step(&mut self) {
        self.steps += 1;
        self.base.traffic.begin_step();
        self.base.clock.begin_step();
        self.step_once();
        self.base.clock.end_step();
    }

    fn read(&self, first: usize, out: &mut [Disc]) {
        self.base.read(first, out);
    }

    fn counters(&self) -> Vec<(&'static str, f64)> {
        let mut counters = self.base.counters();
        let mut extra = 0_u64;
        self.base.world.all_reduce_into(&self.extra, &mut extra, SystemOperation::sum());
        let steps = self.steps.max(1) as f64;
        counters
            .push(("discs sent back from beyond the own block, per step", extra as f64 / steps));
        counters
    }

    fn events(&self) -> Option<Vec<Event>> {
        self.base.events()
    }
}
