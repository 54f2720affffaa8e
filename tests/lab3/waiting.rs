//! Members that hold each other back, threads that wait for each other, and one that comes between.

use std::collections::HashSet;
use std::sync::atomic::{AtomicU32, AtomicU64, AtomicUsize, Ordering};
use std::thread::{self, ThreadId};
use std::time::{Duration, Instant};

use common::soft::Statistics;
use lab3::{AtomicStatistics, Barrier, Part, Word, on_threads, take_steps};
use parking_lot::Mutex;

pub(super) const MEMBERS: usize = 3;
const PARTS: [Part; 3] = [Part::Forces, Part::Moves, Part::Arrivals];

/// How long a thread waits for others that may never come.
const PATIENCE: Duration = Duration::from_secs(5);

/// What the members of a team did in each part of all steps.
pub(super) struct Rehearsal {
    /// Members that began it.
    pub(super) begun: Vec<usize>,
    /// Members that ended it.
    pub(super) ended: Vec<usize>,
    /// As each member began it: how many had ended the part before.
    pub(super) before: Vec<[usize; MEMBERS]>,
    /// How often the others did not wait at the barrier for a member that was held back.
    pub(super) alone: usize,
    /// Members that have begun a part too early.
    early: usize,
}

impl Rehearsal {
    fn begin(&mut self, turn: usize, member: usize) {
        self.begun[turn] += 1;
        if turn > 0 {
            self.before[turn][member] = self.ended[turn - 1];
        }
        self.early += usize::from(self.before[turn][member] < MEMBERS);
    }

    fn is_sound(&self) -> bool {
        self.early + self.alone == 0
    }
}

/// Three members take some steps. In each part one of them holds back until the others wait at the
/// barrier, or have begun too early: time alone does not let it go on.
pub(super) fn rehearse(steps: usize) -> Rehearsal {
    let turns = PARTS.len() * steps;
    let (begun, before) = (vec![0; turns], vec![[MEMBERS; MEMBERS]; turns]);
    let notes = Rehearsal { ended: begun.clone(), begun, before, alone: 0, early: 0 };
    let (barrier, notes) = (Barrier::new(MEMBERS), Mutex::new(notes));
    thread::scope(|scope| {
        for member in 0..MEMBERS {
            let (barrier, notes) = (&barrier, &notes);
            scope.spawn(move || {
                let _membership = barrier.membership();
                let mut turn = 0;
                let part = |part: Part| {
                    assert!(
                        turn < turns,
                        "task 3.10: member {member} takes more than {steps} steps"
                    );
                    assert_eq!(part, PARTS[turn % 3], "task 3.10: part {} of a step", turn % 3 + 1);
                    notes.lock().begin(turn, member);
                    if turn % 4 == member && notes.lock().is_sound() {
                        let until = Instant::now() + PATIENCE;
                        while !barrier.others_wait()
                            && notes.lock().is_sound()
                            && Instant::now() < until
                        {
                            thread::yield_now();
                        }
                        notes.lock().alone += usize::from(!barrier.others_wait());
                    }
                    notes.lock().ended[turn] += 1;
                    turn += 1;
                };
                take_steps(steps as u64, part, barrier);
            });
        }
    });
    notes.into_inner()
}

/// What became of threads of which none goes on before all have come, or it is clear that they never will.
pub(super) struct Gathering {
    /// At work at the same time, at the most.
    pub(super) most: usize,
    /// That had ended when the call returned.
    pub(super) ended: usize,
    /// The numbers that they were given, in their order.
    pub(super) numbers: Vec<usize>,
    /// Different threads, the caller's not among them.
    pub(super) different: usize,
}

/// Gathers `threads` threads.
pub(super) fn gather(threads: usize) -> Gathering {
    let came: Mutex<(Vec<usize>, HashSet<ThreadId>)> = Mutex::default();
    let (most, ended) = (AtomicUsize::new(0), AtomicUsize::new(0));
    let until = Instant::now() + PATIENCE;
    on_threads(threads, |number| {
        {
            let (numbers, ids) = &mut *came.lock();
            numbers.push(number);
            ids.insert(thread::current().id());
        }
        let count = || came.lock().0.len();
        while count() < threads && Instant::now() < until {
            thread::yield_now();
        }
        most.fetch_max(count() - ended.load(Ordering::SeqCst), Ordering::SeqCst);
        thread::sleep(Duration::from_millis(20));
        ended.fetch_add(1, Ordering::SeqCst);
    });
    let ended = ended.into_inner();
    let (mut numbers, mut ids) = came.into_inner();
    ids.remove(&thread::current().id());
    numbers.sort_unstable();
    Gathering { most: most.into_inner(), ended, numbers, different: ids.len() }
}

/// Twice dmin 0.5, davg 0.5, navg 1 and 4 pair tests, while another thread comes between: the first `times` times
/// that a word is read or about to be exchanged it finds 0.125, and adds 0.25, 2 and 2.
pub(super) fn interrupted(times: u32) -> Statistics {
    let at_first = |by: fn(&AtomicU64)| {
        let done = AtomicU32::new(0);
        move |bits: &AtomicU64| {
            if done.fetch_add(1, Ordering::Relaxed) < times {
                by(bits);
            }
        }
    };
    let add_two = |bits: &AtomicU64| {
        bits.fetch_add(2, Ordering::Relaxed);
    };
    let add_quarter = |bits: &AtomicU64| {
        let sum = f64::from_bits(bits.load(Ordering::Relaxed)) + 0.25;
        bits.store(sum.to_bits(), Ordering::Relaxed);
    };
    let lower = |bits: &AtomicU64| bits.store(0.125_f64.to_bits(), Ordering::Relaxed);
    let total = AtomicStatistics {
        dmin: Word::new(1.0_f64.to_bits()).interrupted(at_first(lower)),
        davg: Word::new(0.0_f64.to_bits()).interrupted(at_first(add_quarter)),
        navg: Word::new(0).interrupted(at_first(add_two)),
        pair_tests: Word::new(0).interrupted(at_first(add_two)),
    };
    let part = Statistics { dmin: 0.5, davg: 0.5, navg: 1, pair_tests: 4 };
    // The first reading of each word may be that of `sum`.
    total.add(&part);
    total.sum();
    total.add(&part);
    total.sum()
}
