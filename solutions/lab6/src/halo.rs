//! The engine: a block of rows, and ghosts from the neighbours.

use std::ops::Range;
use std::thread;

use common::soft::{
    CUTOFF, Observer, OfficialParticles, Particle, Scene, SceneError, Simulation, Statistics,
    official_size,
};
use common::{Settings, Vec2};
use common_mpi::{Ghost, Traffic, Wire};
use mpi::Rank;
use mpi::collective::SystemOperation;
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;
use solution1::advance;
use solution2::{BIN_SIZE, Gather, Grid, SortedBins};
use solution5::{gather_at_root, reduce};

use crate::{
    Cuts, balanced, border_rows, exchange_all, exchange_beside, interior_rows, sort_leavers,
};

/// The fullest rank may have so many times the mean before the rows are cut anew.
const TOLERANCE: f64 = 1.05;

/// How messages travel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Route {
    /// Non-blocking, to the two neighbours; to others only if somebody goes there.
    Neighbours,
    /// By collective operations of all ranks.
    Everybody,
}

/// One rank of the job: the particles of its block of rows and nothing else of the scene.
// ANCHOR: engine
pub struct Halo<O> {
    world: SimpleCommunicator,
    bin_size: f64,
    threads: usize,
    rebalance: u64,
    route: Route,
    n: usize,
    cuts: Cuts,
    block: Range<usize>,
    /// The particles of the block.
    own: SortedBins,
    /// Those of the row before it and of the row after it.
    ghosts: [SortedBins; 2],
    /// In the order of the own particles.
    accelerations: Vec<Vec2>,
    observer: O,
    traffic: Traffic,
    steps: u64,
    recuts: u64,
}
// ANCHOR_END: engine

/// A generator that shows a scene, one particle after the other, as often as it is asked to.
type Show<'a> = &'a dyn Fn(&mut dyn FnMut(Particle));

impl<O: Observer> Halo<O> {
    /// An engine that sends its messages along `route`.
    pub fn new(world: SimpleCommunicator, settings: &Settings, route: Route) -> Self {
        let nothing = || SortedBins::new(Grid::with_bins_along(1.0, 1), 0..0);
        Self {
            world,
            bin_size: settings.knob(BIN_SIZE),
            threads: settings.threads,
            rebalance: settings.knob("rebalance") as u64,
            route,
            n: 0,
            cuts: Cuts { starts: Vec::new() },
            block: 0..0,
            own: nothing(),
            ghosts: [nothing(), nothing()],
            accelerations: Vec::new(),
            observer: O::default(),
            traffic: Traffic::default(),
            steps: 0,
            recuts: 0,
        }
    }

    fn rank(&self) -> usize {
        self.world.rank() as usize
    }

    fn ranks(&self) -> usize {
        self.world.size() as usize
    }

    /// Starts over from a scene of `n` particles in a box of side `size`.
    fn start(&mut self, n: usize, size: f64, show: Show) {
        let grid = Grid::new(size, self.bin_size * CUTOFF, n);
        let (cuts, share) = keep_share(&grid, self.ranks(), self.rank(), show);
        self.n = n;
        self.settle(grid, cuts, share);
        self.observer = O::default();
        self.traffic = Traffic::default();
        (self.steps, self.recuts) = (0, 0);
    }

    /// Makes bins for the block that `cuts` give this rank and puts `particles` into them.
    fn settle(&mut self, grid: Grid, cuts: Cuts, particles: Vec<Particle>) {
        self.block = cuts.block(self.rank());
        self.cuts = cuts;
        self.own = SortedBins::new(grid, self.block.clone());
        self.own.refill(particles);
        let Range { start, end } = self.block;
        let after = if end < grid.rows() { end..end + 1 } else { end..end };
        self.ghosts = [start.saturating_sub(1)..start, after].map(|row| SortedBins::new(grid, row));
    }

    /// Sums the forces: of the interior rows while ghosts travel, of the border rows when they
    /// are there.
    ///
    /// All ranks call it together.
    fn sum_forces(&mut self) {
        self.accelerations.resize(self.own.particles().len(), Vec2::ZERO);
        let interior = interior_rows(&self.block, self.own.grid().rows());
        let outgoing = self.border_lists();
        for (_, list) in &outgoing {
            self.traffic.sent(&[0_u64]);
            self.traffic.sent(list);
        }
        let (own, threads) = (&self.own, self.threads);
        let places = own.places(interior.clone());
        let inner = &mut self.accelerations[places];
        let mut work = || sum_rows::<O>(own, interior.clone(), inner, threads);
        let (arrived, seen) = match self.route {
            Route::Neighbours => exchange_beside(&self.world, &outgoing, work),
            Route::Everybody => {
                let mut lists = vec![Vec::new(); self.world.size() as usize];
                for (rank, list) in outgoing {
                    lists[rank as usize] = list;
                }
                (vec![exchange_all(&self.world, &lists)], work())
            }
        };
        self.observer.merge(&seen);
        self.take_ghosts(&arrived);
        for rows in border_rows(&self.block, &interior) {
            self.sum_border(rows);
        }
    }

    /// For each neighbour the ghosts that it needs: of the first row for the one before, of the
    /// last row for the one after.
    fn border_lists(&self) -> Vec<(Rank, Vec<Ghost>)> {
        let Range { start, end } = self.block;
        let columns = 0..self.own.grid().columns();
        let rows = [start, end.saturating_sub(1)];
        let neighbours = self.cuts.neighbours(self.rank()).into_iter().zip(rows);
        neighbours
            .filter_map(|(neighbour, row)| {
                let neighbour = neighbour? as Rank;
                let particles = self.own.bins(row, columns.clone());
                Some((neighbour, particles.iter().map(Ghost::from).collect()))
            })
            .collect()
    }

    /// The ghosts of the step before go, and these come.
    fn take_ghosts(&mut self, arrived: &[Vec<Ghost>]) {
        let grid = *self.own.grid();
        let start = self.block.start;
        let all = || arrived.iter().flatten();
        let [before, after] = &mut self.ghosts;
        before.refill(all().filter(|g| grid.row(g.y) < start).map(Particle::from));
        after.refill(all().filter(|g| grid.row(g.y) >= start).map(Particle::from));
    }

    fn sum_border(&mut self, rows: Range<usize>) {
        let grid = *self.own.grid();
        let mut gather = Gather::default();
        let places = self.own.places(rows);
        let (own, [before, after]) = (&self.own, &self.ghosts);
        let particles = &own.particles()[places.clone()];
        for (particle, a) in particles.iter().zip(&mut self.accelerations[places]) {
            let columns = grid.near(grid.column(particle.x));
            let around = grid.near(grid.row(particle.y)).map(|row| {
                let bins = match row {
                    row if row < self.block.start => before,
                    row if row < self.block.end => own,
                    _ => after,
                };
                bins.bins(row, columns.clone())
            });
            *a = gather.acceleration(particle, around, &mut self.observer);
        }
    }

    /// Moves the own particles and takes out those that left the block.
    fn move_particles(&mut self) -> Vec<Wire> {
        let grid = *self.own.grid();
        let mut places = Vec::new();
        let particles = self.own.particles_mut().iter_mut().zip(&self.accelerations);
        for (place, (particle, a)) in particles.enumerate() {
            advance(particle, *a, grid.size());
            if !self.block.contains(&grid.row(particle.y)) {
                places.push(place);
            }
        }
        // From the last to the first: whoever fills a gap has been looked at.
        places.iter().rev().map(|&place| Wire::from(&self.own.take(place))).collect()
    }

    /// Sends `leavers` to their new owners and takes in those that come here.
    ///
    /// Along [`Route::Neighbours`] it takes messages to the neighbours; and since somebody may go
    /// further, all ranks add up how many do, and only if there are any they all exchange.
    fn migrate(&mut self, leavers: Vec<Wire>) {
        let grid = *self.own.grid();
        let neighbours = self.cuts.neighbours(self.rank());
        let (near, far) = match self.route {
            Route::Neighbours => {
                let sorted = sort_leavers(&grid, &self.cuts, neighbours, &leavers);
                (sorted.near, sorted.far)
            }
            Route::Everybody => {
                let owner = |wire: &Wire| self.cuts.owner(grid.row(wire.y));
                (<_>::default(), leavers.iter().map(|wire| (owner(wire), *wire)).collect())
            }
        };
        let mut anybody = true;
        if self.route == Route::Neighbours {
            let outgoing: Vec<_> = neighbours
                .into_iter()
                .zip(near)
                .filter_map(|(neighbour, list)| Some((neighbour? as Rank, list)))
                .collect();
            for (_, list) in &outgoing {
                self.traffic.sent(&[0_u64]);
                self.traffic.sent(list);
            }
            let (arrived, ()) = exchange_beside(&self.world, &outgoing, || ());
            arrived.iter().flatten().for_each(|wire| self.own.put(wire.into()));
            let mut all_far = 0_u64;
            self.world.all_reduce_into(&(far.len() as u64), &mut all_far, SystemOperation::sum());
            self.traffic.sent(&[0_u64]);
            anybody = all_far > 0;
        }
        if anybody {
            for wire in self.send_anywhere(far) {
                self.own.put((&wire).into());
            }
        }
        self.own.sort();
    }

    /// Sends particles to the ranks they are listed with, whichever those are.
    fn send_anywhere(&mut self, particles: Vec<(usize, Wire)>) -> Vec<Wire> {
        let mut lists = vec![Vec::new(); self.ranks()];
        for (rank, wire) in particles {
            lists[rank].push(wire);
        }
        let rank = self.rank();
        for (_, list) in lists.iter().enumerate().filter(|(other, _)| *other != rank) {
            self.traffic.sent(&[0_i32]);
            if !list.is_empty() {
                self.traffic.sent(list);
            }
        }
        exchange_all(&self.world, &lists)
    }

    /// Cuts the rows anew if one rank has too many particles.
    fn keep_balance(&mut self) {
        let (own, mut most) = (self.own.particles().len() as u64, 0_u64);
        self.world.all_reduce_into(&own, &mut most, SystemOperation::max());
        if most as f64 <= TOLERANCE * self.n as f64 / self.ranks() as f64 {
            return;
        }
        let grid = *self.own.grid();
        let mut counts = vec![0_u64; grid.rows()];
        for row in self.block.clone() {
            counts[row] = self.own.places(row..row + 1).len() as u64;
        }
        let mut all = vec![0_u64; grid.rows()];
        self.world.all_reduce_into(&counts[..], &mut all[..], SystemOperation::sum());
        let cuts = balanced(&all, self.ranks());
        if cuts == self.cuts {
            return;
        }
        let addressed = |p: &Particle| (cuts.owner(grid.row(p.y)), Wire::from(p));
        let particles = self.own.particles().iter().map(addressed).collect();
        let arrived = self.send_anywhere(particles);
        self.settle(grid, cuts, arrived.iter().map(Particle::from).collect());
        self.recuts += 1;
    }
}

/// The cuts of a scene and the particles of `rank`'s block, from a scene that can only be shown
/// one particle after the other.
///
/// Nobody may keep the whole scene, and nobody knows the cuts before all rows are counted. So let
/// it be shown twice: count the particles of each row of `grid`, make the cuts ([`balanced`]), then
/// keep those of the own block. Every rank finds the same cuts, without a message.
fn keep_share(grid: &Grid, ranks: usize, rank: usize, show: Show) -> (Cuts, Vec<Particle>) {
    // task 6.7: each rank keeps its share
    let mut counts = vec![0; grid.rows()];
    show(&mut |particle| counts[grid.row(particle.y)] += 1);
    let cuts = balanced(&counts, ranks);
    let block = cuts.block(rank);
    let mut share = Vec::new();
    show(&mut |particle| {
        if block.contains(&grid.row(particle.y)) {
            share.push(particle);
        }
    });
    (cuts, share)
    // end 6.7
}

/// Sums the forces on the particles of `rows`, which need no ghosts, on so many threads.
fn sum_rows<O: Observer>(
    own: &SortedBins,
    rows: Range<usize>,
    accelerations: &mut [Vec2],
    threads: usize,
) -> O {
    let chunk = rows.len().div_ceil(threads).max(1);
    let mut rest = accelerations;
    let mut parts = Vec::new();
    for start in rows.clone().step_by(chunk) {
        let rows = start..(start + chunk).min(rows.end);
        let (part, others) = rest.split_at_mut(own.places(rows.clone()).len());
        parts.push((rows, part));
        rest = others;
    }
    let sum = |(rows, part): (Range<usize>, &mut [Vec2])| {
        let mut observer = O::default();
        own.gather_rows(rows, part, &mut Gather::default(), &mut observer);
        observer
    };
    let mut all = O::default();
    thread::scope(|scope| {
        let last = parts.pop();
        let others: Vec<_> = parts.into_iter().map(|part| scope.spawn(move || sum(part))).collect();
        if let Some(part) = last {
            all.merge(&sum(part));
        }
        for other in others {
            all.merge(&other.join().expect("a panic ends the whole job before this"));
        }
    });
    all
}

impl<O: Observer> Simulation for Halo<O> {
    fn load(&mut self, scene: &Scene) {
        let show = |see: &mut dyn FnMut(Particle)| scene.particles().iter().for_each(|p| see(*p));
        self.start(scene.len(), scene.size(), &show);
    }

    fn load_official(&mut self, n: u64, seed: u32) -> Result<(), SceneError> {
        let generator = OfficialParticles::new(n, seed)?;
        let n = n as usize;
        let show = |see: &mut dyn FnMut(Particle)| generator.clone().for_each(see);
        self.start(n, official_size(n), &show);
        Ok(())
    }

    fn step(&mut self) {
        self.observer = O::default();
        self.traffic.begin_step();
        self.steps += 1;
        self.sum_forces();
        let leavers = self.move_particles();
        self.migrate(leavers);
        if self.rebalance > 0 && self.steps.is_multiple_of(self.rebalance) {
            self.keep_balance();
        }
    }

    fn read(&self, first: usize, out: &mut [Particle]) {
        let wanted = first..first + out.len();
        let inside = |particle: &&Particle| wanted.contains(&(particle.id as usize));
        let own: Vec<Wire> = self.own.particles().iter().filter(inside).map(Wire::from).collect();
        for wire in gather_at_root(&self.world, &own).iter().flatten() {
            out[wire.id as usize - first] = wire.into();
        }
    }

    fn statistics(&self) -> Option<Statistics> {
        reduce(&self.world, &self.observer.statistics()?)
    }

    fn counters(&self) -> Vec<(&'static str, f64)> {
        let mut counters = self.traffic.report(&self.world);
        counters.push(("times the rows were cut anew", self.recuts as f64));
        counters
    }
}
