//! An atomic number whose operations have an ordering.

use std::fmt;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use crate::Memory;

/// An [`AtomicU64`] that a test can put into a [`Memory`].
///
/// `load(Relaxed)` and `store(…, Relaxed)` guarantee nothing about other memory. If a `load(Acquire)`
/// reads the number of a `store(…, Release)`, its thread sees everything that the other thread had
/// written before the store.
#[derive(Default)]
pub struct Atomic {
    bits: AtomicU64,
    watched: Option<(Arc<Memory>, usize)>,
}

impl Atomic {
    /// Returns a number that begins as `bits`.
    pub fn new(bits: u64) -> Self {
        Self { bits: AtomicU64::new(bits), watched: None }
    }

    /// Returns a number in a memory that a test observes. It is called `name` there.
    pub fn watched(bits: u64, memory: &Arc<Memory>, name: &'static str) -> Self {
        let location = memory.location(name, bits);
        Self { bits: AtomicU64::new(bits), watched: Some((Arc::clone(memory), location)) }
    }

    /// Returns the number, as this thread may see it.
    ///
    /// # Panics
    /// If `ordering` is [`Ordering::Release`] or [`Ordering::AcqRel`], which a load cannot have.
    #[inline]
    pub fn load(&self, ordering: Ordering) -> u64 {
        let bits = self.bits.load(ordering);
        self.watched.as_ref().map_or(bits, |(memory, location)| memory.load(*location, ordering))
    }

    /// Replaces the number.
    ///
    /// # Panics
    /// If `ordering` is [`Ordering::Acquire`] or [`Ordering::AcqRel`], which a store cannot have.
    #[inline]
    pub fn store(&self, bits: u64, ordering: Ordering) {
        self.bits.store(bits, ordering);
        if let Some((memory, location)) = &self.watched {
            memory.store(*location, bits, ordering);
        }
    }
}

impl fmt::Debug for Atomic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.bits.fmt(f)
    }
}
