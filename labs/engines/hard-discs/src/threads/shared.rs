//! What threads share in a loop: a count, and a count behind a lock.

use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

type Interruption<T> = Box<dyn Fn(&T) + Send + Sync>;

/// A count that several threads share.
///
/// A test can have another thread's work done at the worst moments: before and after each `load`, and
/// before each `store` and `fetch_add` ([`SharedCount::interrupted`]). Without a test that costs a look at a `None`.
#[derive(Default)]
pub struct SharedCount {
    value: AtomicUsize,
    interruption: Option<Interruption<SharedCount>>,
}

impl SharedCount {
    /// A count from 0 that calls `interruption` before each operation, and after each `load`.
    pub fn interrupted(interruption: impl Fn(&Self) + Send + Sync + 'static) -> Self {
        Self { value: AtomicUsize::new(0), interruption: Some(Box::new(interruption)) }
    }

    // Relaxed is enough below: no thread learns from the count what another thread has written.

    /// What it is now. It may be something else at once.
    #[inline]
    pub fn load(&self) -> usize {
        self.interrupt();
        let value = self.value.load(Ordering::Relaxed);
        self.interrupt();
        value
    }

    /// Overwrites it.
    #[inline]
    pub fn store(&self, value: usize) {
        self.interrupt();
        self.value.store(value, Ordering::Relaxed);
    }

    /// Adds to it, and returns what it was before; nothing comes in between.
    #[inline]
    pub fn fetch_add(&self, more: usize) -> usize {
        if more == 0 {
            // It is a load.
            return self.load();
        }
        self.interrupt();
        self.value.fetch_add(more, Ordering::Relaxed)
    }

    #[inline]
    fn interrupt(&self) {
        if let Some(interrupt) = &self.interruption {
            interrupt(self);
        }
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

    // ANCHOR: locked
    /// A critical section: takes the lock, lets `act` read and write the count, and gives the lock
    /// back. Returns what `act` returned.
    pub fn locked<T>(&self, act: impl FnOnce(&mut usize) -> T) -> T {
        let result = act(&mut self.value.lock().expect("no critical section panics"));
        if let Some(interrupt) = &self.interruption {
            interrupt(self);
        }
        result
    }
    // ANCHOR_END: locked
}
