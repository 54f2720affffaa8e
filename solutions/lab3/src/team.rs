//! Tasks 3.9 to 3.11: threads that live for the whole run.

use std::ops::Range;
use std::panic::resume_unwind;
use std::sync::atomic::{AtomicU64, Ordering};
use std::thread;

use common::soft::{Observer, Particle, Scene, Simulation, Statistics, read_by_id};
use common::{Config, Vec2};
use crossbeam_utils::CachePadded;
use parking_lot::{Mutex, RwLock, RwLockReadGuard};
use solution1::advance;
use solution2::{BIN_SIZE, Gather, Grid, SortedBins};

use crate::barrier::Barrier;
use crate::{own_rows, rows_of_each};

/// A team: each member is a thread with its own rows, and all members run the same program.
///
/// This is called *single program, multiple data*. OpenMP parallel regions and MPI programs work in
/// this way. The threads are started once for many steps. Each member keeps the particles of its
/// rows in its own sorted bins. A particle that leaves these rows travels to its new member through
/// a mailbox.
///
/// A member's bins are behind a [`RwLock`], and a mailbox is behind a [`Mutex`]. The barriers alone
/// keep members from disturbing each other, so no thread ever waits for a lock. Rust requires the
/// locks, so that a missing barrier cannot corrupt memory.
// ANCHOR: team
#[derive(Default)]
pub struct Team<O> {
    bin_size: f64,
    threads: usize,
    late: usize,
    grid: Grid,
    /// The bins of each member.
    bins: Vec<RwLock<SortedBins>>,
    /// `mail[from][to]`: the particles that travel from one member to another.
    mail: Vec<Vec<Mutex<Vec<Particle>>>>,
    /// The observers of each member, one for each of its rows. An observer has seen the row's pairs
    /// in the last step.
    seen: Vec<Mutex<Vec<O>>>,
    /// The member that owns each row.
    owners: Vec<usize>,
    /// The number of parts that each member has finished in this run.
    ended: Vec<CachePadded<AtomicU64>>,
}

/// The private data of a member, kept for as long as its thread runs.
#[derive(Default)]
struct Member {
    number: usize,
    rows: Range<usize>,
    accelerations: Vec<Vec2>,
    gather: Gather,
}
// ANCHOR_END: team

impl<O: Observer> Team<O> {
    /// Makes an engine from the config of its variant.
    pub fn new(config: &Config) -> Self {
        Self {
            bin_size: config.parameter(BIN_SIZE),
            threads: config.threads,
            late: config.parameter("late") as usize,
            ..Self::default()
        }
    }

    /// Runs one part of a step for one member.
    ///
    /// The parameter `late` may select a member. This member begins the part when all other members
    /// have finished it.
    fn part(&self, part: Part, member: &mut Member, barrier: &Barrier) {
        let before = self.ended[member.number].load(Ordering::Relaxed);
        for (other, ended) in self.ended.iter().enumerate() {
            if ended.load(Ordering::Acquire) < before {
                missing_barrier(member, part, other);
            }
        }
        if self.late == member.number + 1 {
            barrier.be_last();
        }
        match part {
            Part::Forces => self.sum_forces(member),
            Part::Moves => self.move_particles(member),
            Part::Arrivals => self.take_arrivals(member),
        }
        self.ended[member.number].store(before + 1, Ordering::Release);
    }

    /// The first part: reads the bins of all members and writes the member's accelerations.
    fn sum_forces(&self, member: &mut Member) {
        // Any number of members may hold read locks at once.
        let bins: Vec<RwLockReadGuard<SortedBins>> = self
            .bins
            .iter()
            .enumerate()
            .map(|(owner, bins)| {
                bins.try_read().unwrap_or_else(|| missing_barrier(member, Part::Forces, owner))
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

    /// The second part: moves the member's particles, and posts the particles that left its rows.
    fn move_particles(&self, member: &Member) {
        let mut bins = self.bins[member.number]
            .try_write()
            .unwrap_or_else(|| missing_barrier(member, Part::Moves, member.number));
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

    /// The third part: takes the mail, and sorts the member's bins.
    fn take_arrivals(&self, member: &Member) {
        let mut bins = self.bins[member.number]
            .try_write()
            .unwrap_or_else(|| missing_barrier(member, Part::Arrivals, member.number));
        take_posted(&mut bins, member.number, &self.mail);
    }
}

fn missing_barrier(member: &Member, part: Part, other: usize) -> ! {
    let number = member.number;
    panic!(
        "task 3.10: member {number} begins its {part:?} before member {other} has finished the \
         previous part: a barrier is missing"
    )
}

/// The parts of a step, in their order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// Reads the bins of all members.
    Forces,
    /// Writes the member's own bins, and mail to other members.
    Moves,
    /// Reads the mail to the member, and writes the member's own bins.
    Arrivals,
}

/// Adds the particles posted to member `number` to its `bins`, then sorts the bins once.
///
/// - `mail[from][to]` contains the particles posted by member `from` to member `to`.
/// - Take the particles of all senders, in the order of the senders.
/// - Afterwards, `mail[from][number]` must be empty for every sender. Particles left in a mailbox
///   would arrive twice.
///
/// No member posts while this runs, so you never have to wait for a lock.
///
/// Book: chapter 3, *Mail*.
pub fn take_posted(bins: &mut SortedBins, number: usize, mail: &[Vec<Mutex<Vec<Particle>>>]) {
    // task 3.9: take the arrivals
    for posted in mail {
        bins.particles_mut().append(&mut posted[number].lock());
    }
    bins.sort();
    // end 3.9
}

/// Runs a member's thread for `steps` steps, from the first to the last.
///
/// In each step, call `part` for [`Part::Forces`], [`Part::Moves`] and [`Part::Arrivals`]. All
/// members run this function at the same time, each with its own `part`.
///
/// The documentation of [`Part`] lists what each part reads and writes. Which parts may a member
/// begin only when every other member has finished the previous part? Wait before these parts:
/// [`Barrier::wait`] returns when every other member has called it or has taken all its steps. In a
/// small scene, a barrier takes longer than a part, so use no barrier that is not needed.
///
/// Book: chapter 3, *Barriers*.
pub fn take_steps(steps: u64, mut part: impl FnMut(Part), barrier: &Barrier) {
    // task 3.10: a worker's body and its barriers
    for _ in 0..steps {
        part(Part::Forces);
        barrier.wait();
        part(Part::Moves);
        barrier.wait();
        part(Part::Arrivals);
        barrier.wait();
    }
    // end 3.10
}

/// Calls `work` on `threads` new threads at the same time, and returns when all have finished.
///
/// The threads call `work` with the numbers 0, 1, … `threads` − 1.
///
/// [`thread::scope`] lets the threads borrow `work`. If a thread panics, this function panics with
/// the same message: pass the error of [`join`](thread::ScopedJoinHandle::join) to
/// [`resume_unwind`].
///
/// Book: chapter 3, *Threads that stay*.
pub fn on_threads(threads: usize, work: impl Fn(usize) + Sync) {
    // task 3.11: start the threads, and wait for them to finish
    let work = &work;
    thread::scope(|scope| {
        let threads: Vec<_> =
            (0..threads).map(|number| scope.spawn(move || work(number))).collect();
        for thread in threads {
            thread.join().unwrap_or_else(|panic| resume_unwind(panic));
        }
    });
    // end 3.11
}

impl<O: Observer> Simulation for Team<O> {
    // ANCHOR: load
    fn load(&mut self, scene: &Scene) {
        self.grid = Grid::of_scene(scene, self.bin_size);
        let members = 0..self.threads;
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
            members.clone().map(|_| members.clone().map(|_| Mutex::default()).collect()).collect();
        self.seen = members.map(|_| Mutex::default()).collect();
    }
    // ANCHOR_END: load

    fn step(&mut self) {
        self.run(1);
    }

    // ANCHOR: run
    fn run(&mut self, steps: u64) {
        self.ended = (0..self.threads).map(|_| CachePadded::default()).collect();
        let barrier = Barrier::new(self.threads);
        let team = &*self;
        on_threads(team.threads, |number| {
            let _membership = barrier.membership();
            let rows = own_rows(number, team.threads, team.grid.rows());
            let mut member = Member { number, rows, ..Member::default() };
            take_steps(steps, |part| team.part(part, &mut member, &barrier), &barrier);
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
