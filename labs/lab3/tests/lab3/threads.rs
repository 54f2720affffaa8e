//! Questions about starting threads and waiting for them.

use std::collections::HashSet;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread::{self, ThreadId};
use std::time::{Duration, Instant};

use lab3::on_threads;
use oracle::{Ask, Random, integers};
use parking_lot::Mutex;

/// Time that a thread waits for others that may never come.
const PATIENCE: Duration = Duration::from_secs(5);

/// Record of threads that wait until all have come, or until it is clear that some never will.
struct Gathering {
    /// Greatest number of threads that were at work at the same time.
    most: usize,
    /// Number of threads that had ended when the call returned.
    ended: usize,
    /// Numbers that the threads were given, in ascending order.
    numbers: Vec<usize>,
    /// Number of different threads besides the caller's.
    different: usize,
}

/// Threads that have come, by their numbers and ids.
#[derive(Default)]
struct Came {
    numbers: Vec<usize>,
    ids: HashSet<ThreadId>,
}

/// Gathers `threads` threads.
fn gather(threads: usize) -> Gathering {
    let came: Mutex<Came> = Mutex::default();
    let most = AtomicUsize::new(0);
    let ended = AtomicUsize::new(0);
    let until = Instant::now() + PATIENCE;
    on_threads(threads, |number| {
        let count = || came.lock().numbers.len();
        {
            let mut came = came.lock();
            came.numbers.push(number);
            came.ids.insert(thread::current().id());
        }
        while count() < threads && Instant::now() < until {
            thread::yield_now();
        }
        most.fetch_max(count() - ended.load(Ordering::SeqCst), Ordering::SeqCst);
        thread::sleep(Duration::from_millis(20));
        ended.fetch_add(1, Ordering::SeqCst);
    });
    let ended = ended.into_inner();
    let Came { mut numbers, mut ids } = came.into_inner();
    ids.remove(&thread::current().id());
    numbers.sort_unstable();
    Gathering { most: most.into_inner(), ended, numbers, different: ids.len() }
}

/// Asks about few threads and many.
pub(crate) fn gatherings(random: &mut Random, ask: &mut impl Ask) {
    for threads in [0, 1, 2, 5, 3 + random.below(8), 12 + random.below(40)] {
        let Gathering { most, ended, numbers, different } = gather(threads);
        let question = format!(
            "{threads} threads: (1) the most threads that work at the same time, (2) the number of threads that have \
             ended when the call returns, (3) the number of different new threads"
        );
        ask.exact(&question, || integers([most, ended, different]), || integers([threads; 3]));
        let question =
            format!("{threads} threads: the numbers that the threads get, in ascending order");
        ask.exact(&question, || integers(numbers), || integers(0..threads));
    }
    // A submission may not start this number of threads.
    ask.in_tests_only(|| {
        let started = gather(257).numbers.len();
        assert_eq!(started, 257, "257 threads: number of threads that the call starts");
    });
}

/// Returns the result of a call in which thread 1 of 3 panics with `words`. The result is 0 for no
/// panic, and 1 for a panic with different words.
pub(crate) fn panics_with(words: u8) -> u8 {
    let work = |number| {
        if number == 1 {
            resume_unwind(Box::new(words));
        }
    };
    let ended = catch_unwind(AssertUnwindSafe(|| on_threads(3, work)));
    ended.map_or_else(|panic| panic.downcast_ref::<u8>().map_or(1, |words| *words), |()| 0)
}

/// Asks about a panic of one thread.
pub(crate) fn panics(random: &mut Random, ask: &mut impl Ask) {
    let words = 2 + random.below(250) as u8;
    let question = format!(
        "thread 1 of 3 panics with the number {words}: the number with which the call panics, or 0 if it does not \
         panic, or 1 if it panics with anything else"
    );
    ask.exact(&question, || vec![f64::from(panics_with(words))], || vec![f64::from(words)]);
}
