//! A clock that a test can observe.

use std::cell::Cell;
use std::time::{Duration, Instant};

thread_local! {
    static STARTED: Cell<usize> = const { Cell::new(0) };
}

/// The time since its start. A test can count the stopwatches that a thread has started.
#[derive(Clone, Copy, Debug)]
pub struct Stopwatch(Instant);

impl Stopwatch {
    /// Starts a stopwatch, which reads the clock.
    #[inline]
    pub fn start() -> Self {
        STARTED.set(STARTED.get() + 1);
        Self(Instant::now())
    }

    /// Returns the time since the start.
    #[inline]
    pub fn elapsed(self) -> Duration {
        self.0.elapsed()
    }

    /// Returns the number of stopwatches that this thread has started.
    pub fn started() -> usize {
        STARTED.get()
    }
}
