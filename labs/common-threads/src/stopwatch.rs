//! A clock that a test can see.

use std::cell::Cell;
use std::time::{Duration, Instant};

thread_local! {
    static STARTED: Cell<usize> = const { Cell::new(0) };
}

/// The time since its start. A test sees how often a thread reads the clock to start one.
#[derive(Clone, Copy, Debug)]
pub struct Stopwatch(Instant);

impl Stopwatch {
    /// Starts one: it reads the clock.
    #[inline]
    pub fn start() -> Self {
        STARTED.set(STARTED.get() + 1);
        Self(Instant::now())
    }

    /// The time since its start.
    #[inline]
    pub fn elapsed(self) -> Duration {
        self.0.elapsed()
    }

    /// The number of stopwatches that this thread has started so far.
    pub fn started() -> usize {
        STARTED.get()
    }
}
