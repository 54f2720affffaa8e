//! Task 4.3: what a lock costs.

use std::time::{Duration, Instant};

use parking_lot::{Mutex, MutexGuard};

/// What one thread has spent on moving and rebinning, and on locks.
#[derive(Clone, Copy, Debug, Default)]
pub struct Meter {
    /// Time in the parts of the step that move and rebin, waiting included.
    pub rebinning: Duration,
    /// Locks taken.
    pub locks: u64,
    /// Of these, how many somebody else held at the time.
    pub contended: u64,
    /// Time spent waiting for those.
    pub waiting: Duration,
}

impl Meter {
    /// Takes the lock, and notes down what it cost.
    ///
    /// A clock takes longer to read than a free lock to take: if every lock were timed, one would
    /// measure the clock. So try first, with [`Mutex::try_lock`]. Only if somebody else holds the
    /// lock, count that, read the clock, wait with [`Mutex::lock`], and add up the time.
    ///
    /// Book: chapter 4, *Reading contention*.
    #[inline]
    pub fn lock<'a, T>(&mut self, mutex: &'a Mutex<T>) -> MutexGuard<'a, T> {
        todo!("task 4.3: take a lock, and measure the wait")
    }

    /// Adds up the meters of all threads.
    pub fn sum<'a>(meters: impl IntoIterator<Item = &'a Self>) -> Self {
        meters.into_iter().fold(Self::default(), |sum, meter| Self {
            rebinning: sum.rebinning + meter.rebinning,
            locks: sum.locks + meter.locks,
            contended: sum.contended + meter.contended,
            waiting: sum.waiting + meter.waiting,
        })
    }
}
