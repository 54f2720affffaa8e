//! Counters that threads share: an atomic counter, and a counter that a lock protects.

use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

type Interruption<T> = Box<dyn Fn(&T) + Send + Sync>;

/// An atomic counter that several threads share.
///
/// A test can make the counter do another thread's work at the worst moments: just before and just
/// after each change of the value ([`SharedCount::interrupted`]). Without a test this costs the
/// comparison of an `Option` with `None`.
#[derive(Default)]
pub struct SharedCount {
    value: AtomicUsize,
    interruption: Option<Interruption<SharedCount>>,
}

impl SharedCount {
    /// Returns a counter at 0 that calls `interruption` before and after each change of the value.
    pub fn interrupted(interruption: impl Fn(&Self) + Send + Sync + 'static) -> Self {
        Self { value: AtomicUsize::new(0), interruption: Some(Box::new(interruption)) }
    }

    // Relaxed ordering is enough below, because no thread learns from the counter what another
    // thread has written.

    /// Returns the current value, which another thread may change immediately.
    #[inline]
    pub fn load(&self) -> usize {
        self.value.load(Ordering::Relaxed)
    }

    /// Overwrites the value.
    #[inline]
    pub fn store(&self, value: usize) {
        self.interrupt();
        self.value.store(value, Ordering::Relaxed);
        self.interrupt();
    }

    /// Adds to the value and returns the previous value. No other thread can change the value in
    /// between.
    #[inline]
    pub fn fetch_add(&self, more: usize) -> usize {
        if more == 0 {
            // The value does not change.
            return self.load();
        }
        self.interrupt();
        let previous = self.value.fetch_add(more, Ordering::Relaxed);
        self.interrupt();
        previous
    }

    #[inline]
    fn interrupt(&self) {
        if let Some(interrupt) = &self.interruption {
            interrupt(self);
        }
    }
}

/// A counter that several threads share and a lock protects. One thread at a time reads or writes
/// it.
///
/// A test can make the counter do another thread's work at the worst moment: just after the lock is
/// released ([`LockedCount::interrupted`]). Without a test this costs the comparison of an `Option`
/// with `None`.
#[derive(Default)]
pub struct LockedCount {
    value: Mutex<usize>,
    interruption: Option<Interruption<LockedCount>>,
}

impl LockedCount {
    /// Returns a counter at 0 that calls `interruption` after each critical section.
    pub fn interrupted(interruption: impl Fn(&Self) + Send + Sync + 'static) -> Self {
        Self { value: Mutex::new(0), interruption: Some(Box::new(interruption)) }
    }

    // ANCHOR: locked
    /// Runs a critical section: takes the lock, calls `act` with the value, and releases the lock.
    ///
    /// Returns the result of `act`.
    pub fn locked<T>(&self, act: impl FnOnce(&mut usize) -> T) -> T {
        let result = act(&mut self.value.lock().expect("no critical section panics"));
        if let Some(interrupt) = &self.interruption {
            interrupt(self);
        }
        result
    }
    // ANCHOR_END: locked
}
