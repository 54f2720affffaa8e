//! Task 4.2: the cost of a lock.

use std::time::Duration;

use common_threads::{Guard, Lock, Stopwatch};

/// The times and the lock counts of one thread.
#[derive(Clone, Copy, Debug, Default)]
pub struct Meter {
    /// The time spent on forces.
    pub forces: Duration,
    /// The time spent on moves, including the work at each change of bin.
    ///
    /// This work is taking locks, waiting for them, recording changes and handing them over.
    pub moving: Duration,
    /// The time spent on bringing bins up to date after all particles had moved.
    pub rebinning: Duration,
    /// The number of locks taken.
    pub locks: u64,
    /// The number of times that another thread held a lock when this thread wanted it.
    pub contended: u64,
    /// The time spent waiting for the contended locks.
    pub waiting: Duration,
}

impl Meter {
    /// Takes the lock, and records the cost.
    ///
    /// - Count every lock in [`locks`](Self::locks).
    /// - A free lock must cost no more than a call of [`Lock::try_lock`]. Do not time this call:
    ///   reading a clock takes longer than taking a free lock, so you would measure the clock.
    /// - If another thread holds the lock, also count it in [`contended`](Self::contended). Wait
    ///   for the lock with [`Lock::lock`], measure the wait with a [`Stopwatch`], and add the time
    ///   to [`waiting`](Self::waiting).
    ///
    /// Book: chapter 4, *Reading contention*.
    #[inline]
    pub fn lock<'a, T>(&mut self, lock: &'a Lock<T>) -> Guard<'a, T> {
        todo!("task 4.2: take a lock, and measure the wait")
    }

    /// Adds up the meters of all threads.
    pub fn sum<'a>(meters: impl IntoIterator<Item = &'a Self>) -> Self {
        meters.into_iter().fold(Self::default(), |sum, meter| Self {
            forces: sum.forces + meter.forces,
            moving: sum.moving + meter.moving,
            rebinning: sum.rebinning + meter.rebinning,
            locks: sum.locks + meter.locks,
            contended: sum.contended + meter.contended,
            waiting: sum.waiting + meter.waiting,
        })
    }
}
