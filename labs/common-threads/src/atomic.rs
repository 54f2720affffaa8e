//! A number that says with each operation what it promises about other memory.

use std::fmt;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use crate::Memory;

/// An [`AtomicU64`] that a test can put into a [`Memory`].
///
/// `load(Relaxed)` and `store(…, Relaxed)` promise nothing about other memory. A thread whose `load(Acquire)` reads what a
/// `store(…, Release)` wrote sees all that the other thread had written before that.
#[derive(Default)]
pub struct Atomic {
    bits: AtomicU64,
    watched: Option<(Arc<Memory>, usize)>,
}

impl Atomic {
    /// A number that begins with `bits`.
    pub fn new(bits: u64) -> Self {
        Self { bits: AtomicU64::new(bits), watched: None }
    }

    /// A number in a memory that a test looks into, called `name` there.
    pub fn watched(bits: u64, memory: &Arc<Memory>, name: &'static str) -> Self {
        let location = memory.location(name, bits);
        Self { bits: AtomicU64::new(bits), watched: Some((Arc::clone(memory), location)) }
    }

    /// The number, as this thread may see it.
    ///
    /// # Panics
    /// `ordering` is [`Ordering::Release`] or [`Ordering::AcqRel`], which a load does not have.
    #[inline]
    pub fn load(&self, ordering: Ordering) -> u64 {
        let bits = self.bits.load(ordering);
        self.watched.as_ref().map_or(bits, |(memory, location)| memory.load(*location, ordering))
    }

    /// Replaces the number.
    ///
    /// # Panics
    /// `ordering` is [`Ordering::Acquire`] or [`Ordering::AcqRel`], which a store does not have.
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
