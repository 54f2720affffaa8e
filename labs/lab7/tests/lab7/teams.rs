//! Questions about the threads that execute the loops over all pairs: task 7.9.

use std::collections::HashSet;
use std::sync::{Mutex, OnceLock};
use std::thread::{self, ThreadId};
use std::time::{Duration, Instant};

use hard_discs::{Schedule, Team, Workers};
use lab7::nested;
use oracle::{Ask, Random, Share, integers};

use super::loops::{INNER, Loop, NESTED, OUTER, SHARES};

/// Asks about rows from the queue while the worker with disc 0 is delayed. The worker keeps the
/// rest of its part.
pub(crate) fn held_up(_: &mut Random, ask: &mut impl Ask) {
    const N: usize = 40;
    for (name, share) in [SHARES[OUTER], SHARES[NESTED]] {
        for chunk in [1, 5] {
            let question = format!(
                "{name} of {N} discs from a queue in parts of {chunk}, with 2 workers. The worker that has disc 0 is \
                 delayed: rows that the other worker does meanwhile"
            );
            let found = || integers(rows_of_the_other(N, chunk, share));
            ask.exact(&question, found, || integers(chunk..N - 1));
        }
    }
}

fn rows_of_the_other(n: usize, chunk: usize, share: Loop) -> Vec<usize> {
    let others = Mutex::new(Vec::new());
    let rows = || others.lock().expect("no thread panics while it holds this lock");
    let seen = OnceLock::new();
    share(n, Team::Fresh(2), Schedule::Dynamic { chunk }, &|_, a, partners| {
        let begin = Instant::now();
        while a == 0 && rows().len() < n - 1 - chunk && begin.elapsed() < Duration::from_secs(5) {
            thread::yield_now();
        }
        if a == 0 {
            seen.get_or_init(|| rows().clone());
        } else if partners.contains(&(n - 1)) {
            // Each row ends with the last disc.
            rows().push(a);
        }
    });
    let mut seen = seen.into_inner().unwrap_or_default();
    seen.sort_unstable();
    seen
}

/// The threads that test pairs.
static LOOKS: Share = Share::new();

/// Asks whether the threads of a team share the pairs, in fixed parts and from a queue. Of the
/// inner loop, the question covers one row: the next row begins when all threads have finished the
/// row, so no thread can be delayed for longer than a row.
pub(crate) fn shared_loops(random: &mut Random, ask: &mut impl Ask) {
    let count = 4 + random.below(3);
    for (which, (name, share)) in SHARES.into_iter().enumerate() {
        for schedule in [Schedule::Static, Schedule::Dynamic { chunk: 1 }] {
            let n = 60 + random.below(40);
            let row = (which == INNER).then(|| random.below(20));
            let what = row.map_or("all rows".into(), |row| format!("row {row}"));
            let question = format!(
                "{name} of {n} discs on a team of {count}, {schedule:?}, {what}: (1) number of threads that test \
                 pairs, at least {count}, (2) 1 if one thread tests more than two thirds of the pairs, 0 if not"
            );
            let found = || threads_of(n, count, schedule, share, row);
            ask.judge(&question, found, |found| match found {
                [threads, 0.0] if *threads >= count as f64 => Ok(()),
                _ => Err(format!("     found: {found:?}\n  expected: [{count}, 0]")),
            });
        }
    }
}

/// Returns how many of `count` threads test pairs, of one row or of all rows, and whether one
/// thread tests nearly all pairs.
fn threads_of(
    n: usize,
    count: usize,
    schedule: Schedule,
    share: Loop,
    row: Option<usize>,
) -> Vec<f64> {
    let workers = Workers::new(count).expect("the threads start");
    let pairs = row.map_or(n * (n - 1) / 2, |row| n - row - 1);
    let found = LOOKS.of(count, pairs as u64, || {
        share(n, Team::Standing(&workers), schedule, &|_, a, partners| {
            if !partners.is_empty() && row.is_none_or(|row| row == a) {
                LOOKS.does(count, partners.len() as u64);
            }
        });
    });
    vec![found[0], found[2]]
}

/// Asks whether each row has its own team if both loops are shared. The second worker of a row must
/// not be a thread of the team that shares the rows, nor a thread that has served another row.
pub(crate) fn fresh_teams(_: &mut Random, ask: &mut impl Ask) {
    let question = "both loops of 20 discs, on a team of 2 that waits for work. Each row has its own team: number of \
                    rows whose second worker is a thread (1) of the waiting team, (2) that was already the second \
                    worker of a row";
    ask.exact(question, || integers(rows_of_used_threads()), || integers([0, 0]));
}

fn rows_of_used_threads() -> [usize; 2] {
    let workers = Workers::new(2).expect("both threads start");
    let team = Team::Standing(&workers);
    let standing = threads_that(|note| team.on_each(|_| note()));
    let seconds = threads_that(|note| {
        nested(20, team, Schedule::Static, |list, _, partners| {
            if list % 2 > 0 && !partners.is_empty() {
                note();
            }
        });
    });
    let different: HashSet<ThreadId> = seconds.iter().copied().collect();
    let of_team = seconds.iter().filter(|thread| standing.contains(thread)).count();
    [of_team, seconds.len() - different.len()]
}

/// Returns the threads on which `work` calls the function that it gets, one for each call.
fn threads_that(work: impl FnOnce(&(dyn Fn() + Sync))) -> Vec<ThreadId> {
    let seen = Mutex::new(Vec::new());
    work(&|| {
        seen.lock().expect("no thread panics while it holds this lock").push(thread::current().id())
    });
    seen.into_inner().expect("as above")
}
