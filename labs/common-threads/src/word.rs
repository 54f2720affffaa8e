//! An atomic number that several threads change.

use std::fmt;
use std::sync::atomic::{AtomicU64, Ordering};

/// A function that is called between a thread's read and the write that relies on it, as if another
/// thread came in at that moment.
type Interruption = Box<dyn Fn(&AtomicU64) + Send + Sync>;

/// An [`AtomicU64`]: each operation is indivisible, but two operations together are not.
///
/// All operations are [`Ordering::Relaxed`]. The number itself is never torn or lost, but nothing is
/// guaranteed about other memory. This is enough for a sum that is read after a barrier.
#[derive(Default)]
pub struct Word {
    bits: AtomicU64,
    interruption: Option<Interruption>,
}

impl Word {
    /// Returns a word that begins as `bits`.
    pub fn new(bits: u64) -> Self {
        Self { bits: AtomicU64::new(bits), interruption: None }
    }

    /// Returns the same word with another thread's operation after each [`load`](Self::load) and before
    /// each [`compare_exchange`](Self::compare_exchange). With this operation, a test loses an update
    /// without luck.
    #[must_use]
    pub fn interrupted(mut self, by: impl Fn(&AtomicU64) + Send + Sync + 'static) -> Self {
        self.interruption = Some(Box::new(by));
        self
    }

    /// Returns the number.
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

    /// Replaces the number, even if another thread has changed it.
    pub fn store(&self, bits: u64) {
        self.bits.store(bits, Ordering::Relaxed);
    }

    /// Adds to the number.
    pub fn fetch_add(&self, addend: u64) {
        self.bits.fetch_add(addend, Ordering::Relaxed);
    }

    /// Replaces the number if `bits` is less.
    pub fn fetch_min(&self, bits: u64) {
        self.bits.fetch_min(bits, Ordering::Relaxed);
    }

    /// Replaces the number by `new` if the number still is `old`.
    ///
    /// # Errors
    /// The current number, if this number is no longer `old`. Nothing has changed then. The exchange
    /// may also fail if the number still is `old`.
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
