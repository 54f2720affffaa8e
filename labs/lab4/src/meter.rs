//! Task 4.2: what a lock costs.

use std::time::Duration;

use common_threads::{Guard, Lock, Stopwatch};

/// What one thread has spent its time on, and on locks.
#[derive(Clone, Copy, Debug, Default)]
pub struct Meter {
    /// Time in which it summed forces.
    pub forces: Duration,
    /// Time in which it moved particles, with all that it did at the moment of a change: locks, waiting
    /// for them, noting down, handing over.
    pub moving: Duration,
    /// Time in which it brought bins up to date when all particles had moved.
    pub rebinning: Duration,
    /// Locks taken.
    pub locks: u64,
    /// Of these, how many another thread held at the time.
    pub contended: u64,
    /// Time spent waiting for all of those.
    pub waiting: Duration,
}

impl Meter {
    /// Takes the lock, and notes down what it cost.
    ///
    /// A clock takes longer to read than a free lock to take: if every lock were timed, one would
    /// measure the clock. So a free lock is counted in [`locks`](Self::locks) and costs no more than
    /// [`Lock::try_lock`]. Only a lock that another thread holds is counted in
    /// [`contended`](Self::contended) too, and the wait for it ([`Lock::lock`]) is added to
    /// [`waiting`](Self::waiting). The clock is a [`Stopwatch`].
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
