//! What threads share in a loop: a count, a count behind a lock, deques to steal from.

use std::ops::Range;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

use crossbeam::deque::{Steal, Stealer, Worker};

type Interruption<T> = Box<dyn Fn(&T) + Send + Sync>;

/// A count that several threads share.
///
/// A test can have another thread's work done at the worst moment: between a `load` and what
/// follows it ([`SharedCount::interrupted`]). Without a test that costs one look at a `None`.
#[derive(Default)]
pub struct SharedCount {
    value: AtomicUsize,
    interruption: Option<Interruption<SharedCount>>,
}

impl SharedCount {
    /// A count from 0 that calls `interruption` after each `load`.
    pub fn interrupted(interruption: impl Fn(&Self) + Send + Sync + 'static) -> Self {
        Self { value: AtomicUsize::new(0), interruption: Some(Box::new(interruption)) }
    }

    // Relaxed is enough below: no thread learns from the count what another thread has written.

    /// What it is now. It may be something else at once.
    pub fn load(&self) -> usize {
        let value = self.value.load(Ordering::Relaxed);
        if let Some(interrupt) = &self.interruption {
            interrupt(self);
        }
        value
    }

    /// Overwrites it.
    pub fn store(&self, value: usize) {
        self.value.store(value, Ordering::Relaxed);
    }

    /// Adds to it, and returns what it was before; nothing comes in between.
    pub fn fetch_add(&self, more: usize) -> usize {
        self.value.fetch_add(more, Ordering::Relaxed)
    }
}

/// A count that several threads share, behind a lock: a thread that reads or writes it is alone with it.
///
/// A test can have another thread's work done at the worst moment: when the lock has just been given
/// back ([`LockedCount::interrupted`]). Without a test that costs one look at a `None`.
#[derive(Default)]
pub struct LockedCount {
    value: Mutex<usize>,
    interruption: Option<Interruption<LockedCount>>,
}

impl LockedCount {
    /// A count from 0 that calls `interruption` after each critical section.
    pub fn interrupted(interruption: impl Fn(&Self) + Send + Sync + 'static) -> Self {
        Self { value: Mutex::new(0), interruption: Some(Box::new(interruption)) }
    }

    /// A critical section: takes the lock, lets `act` read and write the count, and gives the lock
    /// back. Returns what `act` returned.
    pub fn locked<T>(&self, act: impl FnOnce(&mut usize) -> T) -> T {
        let result = act(&mut self.value.lock().expect("no critical section panics"));
        if let Some(interrupt) = &self.interruption {
            interrupt(self);
        }
        result
    }
}

/// A worker's own parts of a loop. `push` puts one on top, `pop` takes the top one.
pub type Deque = Worker<Range<usize>>;

/// Another worker's deque, at the end that one may steal from: the bottom.
///
/// A test can have steals fail as they do when another thread steals at the same moment
/// ([`Victim::crowded`]). Without a test that costs one look at a zero.
pub struct Victim {
    stealer: Stealer<Range<usize>>,
    refusals: AtomicUsize,
}

impl Victim {
    /// The other end of `deque`.
    pub fn of(deque: &Deque) -> Self {
        Self::crowded(deque, 0)
    }

    /// The same, which answers [`Steal::Retry`] so many times before it says what there is.
    pub fn crowded(deque: &Deque, times: usize) -> Self {
        Self { stealer: deque.stealer(), refusals: AtomicUsize::new(times) }
    }

    /// Tries to take the part at the bottom: [`Steal::Success`] with the part, [`Steal::Empty`] if
    /// there is none, [`Steal::Retry`] if another thread came between, and nothing is known.
    pub fn steal(&self) -> Steal<Range<usize>> {
        let less = |left: usize| left.checked_sub(1);
        match self.refusals.fetch_update(Ordering::Relaxed, Ordering::Relaxed, less) {
            Ok(_) => Steal::Retry,
            Err(_) => self.stealer.steal(),
        }
    }
}
