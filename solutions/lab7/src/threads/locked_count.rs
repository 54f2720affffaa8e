//! A count behind a lock.

use std::sync::Mutex;

type Interruption = Box<dyn Fn(&LockedCount) + Send + Sync>;

/// A count that several threads share, behind a lock: a thread that reads or writes it is alone with it.
///
/// A test can have another thread's work done at the worst moment: when the lock has just been given
/// back ([`LockedCount::interrupted`]). Without a test that costs one look at a `None`.
#[derive(Default)]
pub struct LockedCount {
    value: Mutex<usize>,
    interruption: Option<Interruption>,
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
