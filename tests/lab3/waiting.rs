//! What tests and probe ask alike about members that hold each other back, threads that wait for each other, and
//! one that comes between.

use std::collections::HashSet;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::atomic::{AtomicU32, AtomicU64, AtomicUsize, Ordering};
use std::thread::{self, ThreadId};
use std::time::{Duration, Instant};

use common::soft::Statistics;
use lab3::{AtomicStatistics, Barrier, Part, Word, on_threads, take_steps};
use parking_lot::Mutex;

use super::ask::Ask;

const MEMBERS: usize = 3;
const PARTS: [Part; 3] = [Part::Forces, Part::Moves, Part::Arrivals];

/// How long a thread waits for others that may never come.
const PATIENCE: Duration = Duration::from_secs(5);

/// What the members of a team did in each part of all steps.
struct Rehearsal {
    /// Members that began it.
    begun: Vec<usize>,
    /// Members that ended it.
    ended: Vec<usize>,
    /// As each member began it: how many had ended the part before.
    before: Vec<[usize; MEMBERS]>,
    /// How often the others did not wait at the barrier for a member that was held back.
    alone: usize,
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
fn rehearse(steps: usize) -> Rehearsal {
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

/// What three members do in each part of some steps.
pub(super) fn rehearsals(steps: usize, ask: Ask<'_>) {
    let found = rehearse(steps);
    for (turn, before) in found.before.iter().enumerate() {
        let part = ["forces", "moves", "arrivals"][turn % 3];
        let question = format!(
            "step {}, {part}: how many of 3 members have ended the part before when members 0, 1 and 2 begin; \
             if fewer, a barrier is missing",
            turn / 3
        );
        ask(&question, before.map(|count| count as f64).to_vec(), vec![3.0; 3]);
        let counts = vec![found.begun[turn] as f64, found.ended[turn] as f64];
        let question = format!("step {}, {part}: how many members begin and end it", turn / 3);
        ask(&question, counts, vec![3.0, 3.0]);
    }
    let question = "how often the others do not wait at the barrier for a member that is held back";
    ask(question, vec![found.alone as f64], vec![0.0]);
}

/// The parts and barriers of one member in few and many steps. Behind the last part of all nobody waits for anything.
pub(super) fn barriers(ask: Ask<'_>) {
    for steps in [0_u64, 1, 3, 70_000] {
        let (barrier, mut parts) = (Barrier::new(1), 0);
        take_steps(steps, |_| parts += 1, &barrier);
        let more = barrier.meetings() as f64 - 3.0 * steps as f64;
        let more = if more == -1.0 { 0.0 } else { more };
        let question = format!(
            "{steps} steps of one member: parts, and barriers beyond three in each step; one less is right, too"
        );
        ask(&question, vec![parts as f64, more], vec![3.0 * steps as f64, 0.0]);
    }
}

/// What became of threads of which none goes on before all have come, or it is clear that they never will.
struct Gathering {
    /// At work at the same time, at the most.
    most: usize,
    /// That had ended when the call returned.
    ended: usize,
    /// The numbers that they were given, in their order.
    numbers: Vec<usize>,
    /// Different threads, the caller's not among them.
    different: usize,
}

/// Gathers `threads` threads.
fn gather(threads: usize) -> Gathering {
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

/// These numbers of threads, all at the same time, new ones, and ended when the call returns.
pub(super) fn gatherings(counts: &[usize], ask: Ask<'_>) {
    for &threads in counts {
        let Gathering { most, ended, numbers, different } = gather(threads);
        let told = [most, ended, different].map(|count| count as f64).to_vec();
        let question = format!(
            "{threads} threads: how many are at work at the same time, have ended when it returns, and are new \
             and different"
        );
        ask(&question, told, vec![threads as f64; 3]);
        let numbers = numbers.into_iter().map(|number| number as f64).collect();
        let right = (0..threads).map(|number| number as f64).collect();
        ask(&format!("{threads} threads: the numbers that they are given"), numbers, right);
    }
}

/// A panic of one thread comes out as it was.
pub(super) fn panics(ask: Ask<'_>) {
    let work = |number| {
        if number == 1 {
            resume_unwind(Box::new(17_u8));
        }
    };
    let ended = catch_unwind(AssertUnwindSafe(|| on_threads(3, work)));
    let told = ended.map_or_else(|panic| panic.downcast_ref::<u8>().map_or(1, |n| *n), |()| 0);
    let question = "thread 1 of 3 panics with the words 17: what comes out, 0 if nothing does, 1 if it is \
                    something else";
    ask(question, vec![f64::from(told)], vec![17.0]);
}

/// Another thread comes between, few and many times.
pub(super) fn interruptions(ask: Ask<'_>) {
    for times in [1, 2, 3, 40, 1000] {
        let all = interrupted(times);
        // One addition as a whole is interrupted by no one.
        let most = 2 * u64::from(times);
        let count = |found: u64, own: u64| {
            let more = found.wrapping_sub(own);
            (if more == 2 { own + most } else { found }) as f64
        };
        let question = format!(
            "0.5, 1 and 4 are added twice while another thread comes between {times} times, with 0.125 for dmin \
             and 0.25, 2 and 2 to add: dmin, davg, navg, pair tests"
        );
        let found = vec![all.dmin, all.davg, count(all.navg, 2), count(all.pair_tests, 8)];
        let right = [0.125, 1.0 + 0.25 * f64::from(times), (2 + most) as f64, (8 + most) as f64];
        ask(&question, found, right.to_vec());
    }
}

/// Twice dmin 0.5, davg 0.5, navg 1 and 4 pair tests, while another thread comes between: the first `times` times
/// that a word is read or about to be exchanged it finds 0.125, and adds 0.25, 2 and 2.
fn interrupted(times: u32) -> Statistics {
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
