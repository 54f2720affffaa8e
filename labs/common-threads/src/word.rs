//! A number that several threads change.

use std::fmt;
use std::sync::atomic::{AtomicU64, Ordering};

/// Called before a thread writes what it has made of a read, as if another thread came in just then.
type Interruption = Box<dyn Fn(&AtomicU64) + Send + Sync>;

/// An [`AtomicU64`]: each operation happens as a whole, and two operations do not.
///
/// All of them are [`Ordering::Relaxed`]: the number itself is never torn or lost, and nothing is
/// promised about other memory. For a sum that is read after a barrier that is enough.
#[derive(Default)]
pub struct Word {
    bits: AtomicU64,
    interruption: Option<Interruption>,
}

impl Word {
    /// A word that begins with `bits`.
    pub fn new(bits: u64) -> Self {
        Self { bits: AtomicU64::new(bits), interruption: None }
    }

    /// The same, with another thread's operation after each [`load`](Self::load) and before each
    /// [`compare_exchange`](Self::compare_exchange): what a test needs, so that a lost update is not left to luck.
    #[must_use]
    pub fn interrupted(mut self, by: impl Fn(&AtomicU64) + Send + Sync + 'static) -> Self {
        self.interruption = Some(Box::new(by));
        self
    }

    /// The number now.
    pub fn load(&self) -> u64 {
        let bits = self.bits.load(Ordering::Relaxed);
        self.interrupt();
        bits
    }

    fn interrupt(&self) {
        if let Some(interruption) = &self.interruption {
            interruption(&self.bits);
        }
    }

    /// Replaces the number, whatever it is by now.
    pub fn store(&self, bits: u64) {
        self.bits.store(bits, Ordering::Relaxed);
    }

    /// Adds to the number.
    pub fn fetch_add(&self, addend: u64) {
        self.bits.fetch_add(addend, Ordering::Relaxed);
    }

    /// Replaces the number if `bits` are less.
    pub fn fetch_min(&self, bits: u64) {
        self.bits.fetch_min(bits, Ordering::Relaxed);
    }

    /// Replaces the number by `new` if it still is `old`.
    ///
    /// # Errors
    /// It is not; then the error is what it is now, and nothing has changed.
    pub fn compare_exchange(&self, old: u64, new: u64) -> Result<u64, u64> {
        self.interrupt();
        self.bits.compare_exchange_weak(old, new, Ordering::Relaxed, Ordering::Relaxed)
    }
}

impl fmt::Debug for Word {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.bits.fmt(f)
    }
}
