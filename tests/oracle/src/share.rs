//! Whether threads share work: each does some of it, and none does much more than its part.
//!
//! Which thread does how much of a loop with a queue, or of one whose parts are stolen, depends on what else the machine
//! has to do: a right program may leave nearly all to one thread. So threads are held back. The first that comes waits
//! for the others; and a thread that has done its part goes on when the others have done a third of all. They can if the
//! work is shared: of four threads one has done a fourth when it is held, and what it has begun, which nobody can take
//! from it, is less than another fourth. So no right split, fixed or from a queue, of blocks or of single items, lets one
//! thread do more than two thirds. Of two and three threads only the coming is asked: half of the work and a part that
//! is begun may be nearly all.

use std::sync::{Condvar, Mutex, MutexGuard};
use std::thread::{self, ThreadId};
use std::time::{Duration, Instant};

/// Who waits for others waits no longer than this, all in all: then it is clear that they do not come.
const PATIENCE: Duration = Duration::from_secs(3);

/// The work of some threads.
pub struct Share(Mutex<Work>, Condvar);

struct Work {
    /// How many threads share it, and how much it is.
    threads: usize,
    total: u64,
    /// What each thread has done, and how many threads its pool has.
    done: Vec<(ThreadId, usize, u64)>,
    until: Option<Instant>,
}

impl Work {
    const NONE: Self = Self { threads: 0, total: 0, done: Vec::new(), until: None };

    /// Whether a thread that has done so much is ahead of the others.
    fn is_ahead(&self, own: u64) -> bool {
        let others = self.done.iter().map(|(_, _, work)| work).sum::<u64>() - own;
        let has_its_part = own as f64 * self.threads as f64 > self.total as f64;
        let are_behind = 3.0 * (others as f64) < self.total as f64;
        self.done.len() < self.threads || self.threads > 3 && has_its_part && are_behind
    }
}

impl Share {
    /// Of nobody.
    pub const fn new() -> Self {
        Self(Mutex::new(Work::NONE), Condvar::new())
    }

    /// Does work of which so many threads have a share, and which is `total` units. What comes: how many threads did some
    /// of it, how many of these are of a pool of so many threads, and whether one did more than two thirds (1).
    pub fn of(&self, threads: usize, total: u64, work: impl FnOnce()) -> Vec<f64> {
        *self.lock() = Work { threads, total, ..Work::NONE };
        work();
        let work = self.lock();
        let pool = work.done.iter().filter(|(_, pool, _)| *pool == threads).count();
        let busiest = work.done.iter().map(|(_, _, work)| *work).max().unwrap_or(0);
        let all: u64 = work.done.iter().map(|(_, _, work)| work).sum();
        let much = f64::from(u8::from(threads > 3 && 3 * busiest > 2 * all));
        vec![work.done.len() as f64, pool as f64, much]
    }

    /// This thread, of a pool of so many, does `units` of it.
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
            work = self.1.wait_timeout(work, left).expect("no thread panics with it").0;
        }
    }

    fn lock(&self) -> MutexGuard<'_, Work> {
        self.0.lock().expect("no thread panics with it")
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

    /// What four threads did who take units from a queue, each so many at a time.
    fn from_a_queue(chunks: [u64; 4]) -> Vec<f64> {
        let (share, next) = (Share::new(), AtomicU64::new(0));
        let worker = |chunk: u64| {
            while let first = next.fetch_add(chunk, Relaxed)
                && first < 1000
            {
                (first..1000.min(first + chunk)).for_each(|_| share.does(4, 1));
            }
        };
        share.of(4, 1000, || {
            thread::scope(|scope| {
                for chunk in chunks {
                    let worker = &worker;
                    scope.spawn(move || worker(chunk));
                }
            });
        })
    }

    #[test]
    fn no_thread_at_a_queue_does_much_more_than_its_part() {
        for _ in 0..20 {
            assert_eq!(from_a_queue([1, 1, 1, 1]), [4.0, 4.0, 0.0]);
            assert_eq!(from_a_queue([1, 7, 30, 100]), [4.0, 4.0, 0.0]);
        }
    }

    #[test]
    fn one_that_does_nearly_all_is_seen() {
        let share = Share::new();
        let found = share.of(4, 1000, || {
            thread::scope(|scope| {
                for units in [1, 1, 1, 997] {
                    let share = &share;
                    scope.spawn(move || (0..units).for_each(|_| share.does(4, 1)));
                }
            });
        });
        assert_eq!(found, [4.0, 4.0, 1.0]);
    }
}
