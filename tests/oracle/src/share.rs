//! Checks whether threads share work: each thread does some, and no thread much more than its part.
//!
//! The division of a loop depends on the load of the machine: a correct program may leave nearly
//! all of the work to one thread. Therefore threads are delayed here. The first thread that arrives
//! waits for the others. A thread that has done its part continues when the others have done a
//! third of the work. The others can always do this if four threads share the work. A thread is
//! delayed when it has done a fourth of the work. No other thread can take over the rest of the
//! block that it has begun, but this rest is less than another fourth. So no thread of a correct
//! program does more than two thirds. This holds for blocks and for single items, which may be
//! fixed or come from a queue. With two or three threads only the arrival is checked, because half
//! of the work and the rest of a block may be nearly all of the work.

use std::sync::{Condvar, Mutex, MutexGuard};
use std::thread::{self, ThreadId};
use std::time::{Duration, Instant};

/// Total time that threads wait for others. After this time it is clear that the other threads do
/// not come.
const PATIENCE: Duration = Duration::from_secs(3);

/// Work that is shared by some threads.
pub struct Share(Mutex<Work>, Condvar);

struct Work {
    /// Number of threads that share the work.
    threads: usize,
    /// Number of units of work.
    total: u64,
    /// For each thread, the size of its pool, and the units that it has done.
    done: Vec<(ThreadId, usize, u64)>,
    until: Option<Instant>,
}

impl Work {
    const NONE: Self = Self { threads: 0, total: 0, done: Vec::new(), until: None };

    /// Returns whether a thread that has done `own` units is ahead of the others.
    fn is_ahead(&self, own: u64) -> bool {
        let others = self.done.iter().map(|(_, _, work)| work).sum::<u64>() - own;
        let has_its_part = own as f64 * self.threads as f64 > self.total as f64;
        let are_behind = 3.0 * (others as f64) < self.total as f64;
        self.done.len() < self.threads || self.threads > 3 && has_its_part && are_behind
    }
}

impl Share {
    /// Returns a share without work.
    pub const fn new() -> Self {
        Self(Mutex::new(Work::NONE), Condvar::new())
    }

    /// Executes work of `total` units that `threads` threads share. Returns two numbers for each
    /// thread that did some of the work: the size of the thread's pool, and the units that the
    /// thread did.
    pub fn record(&self, threads: usize, total: u64, work: impl FnOnce()) -> Vec<f64> {
        *self.lock() = Work { threads, total, ..Work::NONE };
        work();
        self.lock().done.iter().flat_map(|(_, pool, units)| [*pool as f64, *units as f64]).collect()
    }

    /// Judges the result of [`record`](Self::record).
    ///
    /// # Errors
    /// If a thread did nothing, a thread belongs to a different pool, or one of four or more
    /// threads did more than two thirds of the work.
    pub fn judge(threads: usize, recorded: &[f64]) -> Result<(), String> {
        let (done, _) = recorded.as_chunks::<2>();
        if done.len() != threads {
            return Err(format!(
                "{} threads did some of the work, but the pool has {threads} threads",
                done.len()
            ));
        }
        if let Some([pool, _]) = done.iter().find(|[pool, _]| *pool != threads as f64) {
            return Err(format!(
                "some of the work was done by a thread of a different pool, which has {pool} threads"
            ));
        }
        let busiest = done.iter().map(|[_, units]| *units).fold(0.0, f64::max);
        let all: f64 = done.iter().map(|[_, units]| units).sum();
        if threads > 3 && 3.0 * busiest > 2.0 * all {
            return Err(format!(
                "one thread did {busiest} of {all} units, which is more than two thirds"
            ));
        }
        Ok(())
    }

    /// Executes work as [`record`](Self::record) does. Returns three numbers. The first is the
    /// number of threads that did some of the work. The second is the number of these threads that
    /// belong to a pool of `threads` threads. The third is 1 if one of four or more threads did
    /// more than two thirds of the work, otherwise 0.
    pub fn of(&self, threads: usize, total: u64, work: impl FnOnce()) -> Vec<f64> {
        let recorded = self.record(threads, total, work);
        let (done, _) = recorded.as_chunks::<2>();
        let pool = done.iter().filter(|[pool, _]| *pool == threads as f64).count();
        let busiest = done.iter().map(|[_, units]| *units).fold(0.0, f64::max);
        let all: f64 = done.iter().map(|[_, units]| units).sum();
        let much = f64::from(u8::from(threads > 3 && 3.0 * busiest > 2.0 * all));
        vec![done.len() as f64, pool as f64, much]
    }

    /// Records that this thread, of a pool of `pool` threads, does `units` of the work.
    pub fn does(&self, pool: usize, units: u64) {
        let me = thread::current().id();
        let mut work = self.lock();
        let at = work.done.iter().position(|(thread, ..)| *thread == me).unwrap_or_else(|| {
            work.done.push((me, pool, 0));
            work.done.len() - 1
        });
        work.done[at].2 += units;
        let until = *work.until.get_or_insert_with(|| Instant::now() + PATIENCE);
        self.1.notify_all();
        while work.done.get(at).is_some_and(|(_, _, own)| work.is_ahead(*own)) {
            let left = until.saturating_duration_since(Instant::now());
            if left.is_zero() {
                return;
            }
            work = self
                .1
                .wait_timeout(work, left)
                .expect("no thread panics while it holds this lock")
                .0;
        }
    }

    fn lock(&self) -> MutexGuard<'_, Work> {
        self.0.lock().expect("no thread panics while it holds this lock")
    }
}

impl Default for Share {
    fn default() -> Self {
        Self::new()
    }
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::{AtomicU64, Ordering::Relaxed};
    use std::thread;

    use super::Share;

    /// Judges four threads that take units from a queue, `chunks` of them at a time.
    fn from_a_queue(chunks: [u64; 4]) -> Result<(), String> {
        let (share, next) = (Share::new(), AtomicU64::new(0));
        let worker = |chunk: u64| {
            while let first = next.fetch_add(chunk, Relaxed)
                && first < 1000
            {
                (first..1000.min(first + chunk)).for_each(|_| share.does(4, 1));
            }
        };
        let recorded = share.record(4, 1000, || {
            thread::scope(|scope| {
                for chunk in chunks {
                    let worker = &worker;
                    scope.spawn(move || worker(chunk));
                }
            });
        });
        Share::judge(4, &recorded)
    }

    #[test]
    fn no_thread_at_a_queue_does_much_more_than_its_part() {
        for _ in 0..20 {
            assert_eq!(from_a_queue([1, 1, 1, 1]), Ok(()));
            assert_eq!(from_a_queue([1, 7, 30, 100]), Ok(()));
        }
    }

    #[test]
    fn one_that_does_nearly_all_is_seen() {
        let share = Share::new();
        let recorded = share.record(4, 1000, || {
            thread::scope(|scope| {
                for units in [1, 1, 1, 997] {
                    let share = &share;
                    scope.spawn(move || (0..units).for_each(|_| share.does(4, 1)));
                }
            });
        });
        let words = Share::judge(4, &recorded).unwrap_err();
        assert_eq!(words, "one thread did 997 of 1000 units, which is more than two thirds");
        assert_eq!(
            Share::judge(3, &recorded).unwrap_err(),
            "4 threads did some of the work, but the pool has 3 threads"
        );
    }

    #[test]
    fn a_thread_of_another_pool_is_seen() {
        let share = Share::new();
        let recorded = share.record(1, 10, || share.does(2, 10));
        let words = Share::judge(1, &recorded).unwrap_err();
        assert_eq!(
            words,
            "some of the work was done by a thread of a different pool, which has 2 threads"
        );
    }
}
