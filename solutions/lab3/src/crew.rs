//! Tasks 3.7 and 3.8: threads that live for the whole run.

use std::ops::Range;
use std::panic::resume_unwind;
use std::thread;
use std::time::Duration;

use common::soft::{Observer, Particle, Scene, Simulation, Statistics, read_by_id};
use common::{Config, Vec2};
use parking_lot::{Mutex, RwLock, RwLockReadGuard};
use solution1::advance;
use solution2::{BIN_SIZE, Gather, Grid, SortedBins};

use crate::barrier::Barrier;
use crate::rows_of_each;

/// A crew: each member is a thread with rows of its own, and all run the same program.
///
/// This is how an OpenMP parallel region works inside, and how MPI programs are written: single
/// program, multiple data. Threads are started once for many steps. Each member keeps its rows in
/// sorted bins of its own; a particle that leaves them is handed over in a mailbox.
///
/// A member's bins are behind a [`RwLock`], and a mailbox is behind a [`Mutex`]. The barriers alone
/// keep everybody apart, so no lock is ever waited for. The locks are there because Rust wants to
/// see it: a missing barrier then cannot corrupt memory. With [`RwLock::try_write`] it cannot even
/// go unnoticed.
// ANCHOR: crew
pub struct Crew<O> {
    bin_size: f64,
    threads: usize,
    late: usize,
    grid: Grid,
    /// The bins of each member.
    bins: Vec<RwLock<SortedBins>>,
    /// `mail[from][to]`: particles on their way from one member to another.
    mail: Vec<Vec<Mutex<Vec<Particle>>>>,
    /// What each member saw in the last step, row by row.
    seen: Vec<Mutex<Vec<O>>>,
    /// Who owns a row.
    owners: Vec<usize>,
}

/// What a member has for itself while its thread lives.
#[derive(Default)]
struct Member {
    number: usize,
    rows: Range<usize>,
    accelerations: Vec<Vec2>,
    gather: Gather,
}
// ANCHOR_END: crew

impl<O: Observer> Crew<O> {
    /// An engine as the config of its variant say.
    pub fn new(config: &Config) -> Self {
        Self {
            bin_size: config.parameter(BIN_SIZE),
            threads: config.threads,
            late: config.parameter("late") as usize,
            grid: Grid::with_bins_along(1.0, 1),
            bins: Vec::new(),
            mail: Vec::new(),
            seen: Vec::new(),
            owners: Vec::new(),
        }
    }

    /// One part of a step of one member.
    fn part(&self, part: Part, member: &mut Member) {
        if self.late == member.number + 1 {
            thread::sleep(Duration::from_millis(1));
        }
        match part {
            Part::Forces => self.sum_forces(member),
            Part::Moves => self.move_particles(member),
            Part::Arrivals => self.take_arrivals(member),
        }
    }

    /// First part: reads the bins of all members, writes the member's accelerations.
    fn sum_forces(&self, member: &mut Member) {
        // Read locks exclude nobody who reads.
        let bins: Vec<RwLockReadGuard<SortedBins>> = self
            .bins
            .iter()
            .enumerate()
            .map(|(owner, bins)| {
                bins.try_read().unwrap_or_else(|| self.missing_barrier(member, "reads", owner))
            })
            .collect();
        let mut seen = self.seen[member.number].lock();
        seen.clear();
        member.accelerations.clear();
        for row in member.rows.clone() {
            let mut observer = O::default();
            for particle in bins[member.number].bins(row, 0..self.grid.columns()) {
                let columns = self.grid.near(self.grid.column(particle.x));
                let around = self.grid.near(row).map(|row| {
                    let owner = self.owners[row];
                    bins[owner].bins(row, columns.clone())
                });
                let a = member.gather.acceleration(particle, around, &mut observer);
                member.accelerations.push(a);
            }
            seen.push(observer);
        }
    }

    /// Second part: moves the member's particles, and posts those that left its rows.
    fn move_particles(&self, member: &Member) {
        let mut bins = self.bins[member.number]
            .try_write()
            .unwrap_or_else(|| self.missing_barrier(member, "moves", member.number));
        let mut accelerations = member.accelerations.iter();
        bins.particles_mut().retain_mut(|particle| {
            let a = accelerations.next().expect("one acceleration for each particle");
            advance(particle, *a, self.grid.size());
            let row = self.grid.row(particle.y);
            let stays = member.rows.contains(&row);
            if !stays {
                self.mail[member.number][self.owners[row]].lock().push(*particle);
            }
            stays
        });
    }

    /// Third part: takes the mail and sorts the member's bins.
    fn take_arrivals(&self, member: &Member) {
        let mut bins = self.bins[member.number]
            .try_write()
            .unwrap_or_else(|| self.missing_barrier(member, "takes arrivals into", member.number));
        take_posted(&mut bins, member.number, &self.mail);
    }

    fn missing_barrier<T>(&self, member: &Member, does: &str, owner: usize) -> T {
        panic!(
            "task 3.8: member {} {does} the bins of member {owner} while somebody is still busy \
             with them: a barrier is missing",
            member.number
        )
    }
}

/// The parts of a step, in their order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// Everybody reads the bins of all.
    Forces,
    /// Everybody writes their own bins, and mail to others.
    Moves,
    /// Everybody reads their mail, and writes their own bins.
    Arrivals,
}

/// One step of one member: calls `part` for [`Part::Forces`], [`Part::Moves`] and
/// [`Part::Arrivals`].
///
/// All members run this at the same time, each with its own `part`. Look at what the parts read
/// and write: nobody may begin a part before everybody has finished the one before. The next step
/// follows at once, and begins with forces. [`Barrier::wait`] returns when all members have called
/// it.
///
/// Book: chapter 3, *The crew*.
pub fn one_step(mut part: impl FnMut(Part), barrier: &Barrier) {
    // task 3.8: three parts, and the barriers between
    part(Part::Forces);
    barrier.wait();
    part(Part::Moves);
    barrier.wait();
    part(Part::Arrivals);
    barrier.wait();
    // end 3.8
}

/// Adds the particles posted to member `number`, by all members in their order, to its `bins`, and
/// sorts them.
///
/// `mail[from][number]` must be empty afterwards for every sender: what is left would arrive
/// twice. ([`Vec::append`] empties what it takes from.) Nobody posts while this runs, so no lock is
/// waited for.
///
/// Book: chapter 3, *The crew*.
pub fn take_posted(bins: &mut SortedBins, number: usize, mail: &[Vec<Mutex<Vec<Particle>>>]) {
    // task 3.7: take the arrivals
    for posted in mail {
        bins.particles_mut().append(&mut posted[number].lock());
    }
    bins.sort();
    // end 3.7
}

impl<O: Observer> Simulation for Crew<O> {
    fn load(&mut self, scene: &Scene) {
        self.grid = Grid::of_scene(scene, self.bin_size);
        let crew = 0..self.threads;
        self.owners.clear();
        self.bins.clear();
        for (member, rows) in rows_of_each(self.threads, self.grid.rows()).enumerate() {
            self.owners.resize(rows.end, member);
            let mut bins = SortedBins::new(self.grid, rows.clone());
            let own = |p: &&Particle| rows.contains(&self.grid.row(p.y));
            bins.refill(scene.particles().iter().filter(own).copied());
            self.bins.push(RwLock::new(bins));
        }
        self.mail =
            crew.clone().map(|_| crew.clone().map(|_| Mutex::default()).collect()).collect();
        self.seen = crew.map(|_| Mutex::default()).collect();
    }

    fn step(&mut self) {
        self.run(1);
    }

    // ANCHOR: run
    fn run(&mut self, steps: u64) {
        let barrier = Barrier::new(self.threads);
        let (crew, barrier) = (&*self, &barrier);
        thread::scope(|scope| {
            let rows = rows_of_each(crew.threads, crew.grid.rows());
            let threads: Vec<_> = rows
                .enumerate()
                .map(|(number, rows)| {
                    scope.spawn(move || {
                        let _membership = barrier.membership();
                        let mut member = Member { number, rows, ..Member::default() };
                        for _ in 0..steps {
                            one_step(|part| crew.part(part, &mut member), barrier);
                        }
                    })
                })
                .collect();
            for thread in threads {
                thread.join().unwrap_or_else(|panic| resume_unwind(panic));
            }
        });
    }
    // ANCHOR_END: run

    fn read(&self, first: usize, out: &mut [Particle]) {
        for bins in &self.bins {
            read_by_id(bins.read().particles(), first, out);
        }
    }

    fn statistics(&self) -> Option<Statistics> {
        let mut all = O::default();
        for seen in &self.seen {
            seen.lock().iter().for_each(|seen| all.merge(seen));
        }
        all.statistics()
    }
}
