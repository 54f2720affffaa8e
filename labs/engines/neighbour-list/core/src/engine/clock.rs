//! The time that each part of a step takes, by the clock of the thread that calls the engine.

use std::time::{Duration, Instant};

/// The parts of a step.
///
/// The first three parts occur only in steps with a new outer list. [`Inner`](Self::Inner) takes
/// time only if the inner list has expired.
#[derive(Clone, Copy)]
pub(super) enum Part {
    /// The speed limit, and the skin of a new list.
    Limits,
    /// Sorting the particles into cells.
    Sort,
    /// Collecting the pairs of the outer list.
    Outer,
    /// The inner list, and the outliers.
    Inner,
    /// The pairs of particles in two blocks.
    Across,
    /// The forces inside blocks, and the moves.
    Sweep,
}

/// The names of the parts, each as a counter.
const NAMES: [&str; 6] = [
    "speed limits, all threads [s]",
    "sort, all threads [s]",
    "outer lists, all threads [s]",
    "inner lists, all threads [s]",
    "between blocks, all threads [s]",
    "forces and moves, all threads [s]",
];

/// A stopwatch for the parts of a step. The default stands still.
#[derive(Clone, Copy, Default)]
pub(super) struct Clock {
    /// The end of the last part; `None` while the clock stands still.
    last: Option<Instant>,
    parts: [Duration; NAMES.len()],
}

impl Clock {
    /// Makes a clock that runs.
    pub(super) fn started() -> Self {
        Self { last: Some(Instant::now()), ..Self::default() }
    }

    /// Begins at zero, unless the clock stands still.
    pub(super) fn reset(&mut self) {
        self.parts = Default::default();
        self.resume();
    }

    /// Begins a step, unless the clock stands still: the time since the last part does not count.
    pub(super) fn resume(&mut self) {
        self.last = self.last.map(|_| Instant::now());
    }

    /// Ends `part` and begins the next part.
    pub(super) fn lap(&mut self, part: Part) {
        if let Some(last) = &mut self.last {
            let now = Instant::now();
            self.parts[part as usize] += now - std::mem::replace(last, now);
        }
    }

    /// Returns the seconds of each part times `threads`, with their names; empty if the clock
    /// stands still.
    pub(super) fn shown(&self, threads: usize) -> Vec<(&'static str, f64)> {
        let seconds = self.parts.map(|part| threads as f64 * part.as_secs_f64());
        let named = NAMES.into_iter().zip(seconds);
        named.filter(|_| self.last.is_some()).collect()
    }
}
