//! How far a grading is: a bar on a terminal, a line for each submission anywhere else.

use std::fmt::Display;
use std::sync::{Mutex, PoisonError};
use std::time::Duration;

use indicatif::{ProgressBar, ProgressStyle};

use crate::escape::line;
use lab_kit::progress::progress;

/// Seconds that go by, on a terminal, until the solution is built.
pub(crate) fn clock() -> ProgressBar {
    let clock = progress(0);
    if let Ok(style) = ProgressStyle::with_template("{spinner} {elapsed}") {
        clock.set_style(style);
    }
    clock.enable_steady_tick(Duration::from_secs(1));
    clock
}

/// Says on stderr what is done.
pub(crate) struct Progress {
    /// What is done to each.
    what: &'static str,
    of: usize,
    done: Mutex<usize>,
    bar: ProgressBar,
}

impl Progress {
    /// Begins with `of` submissions, of which nothing is left to do for `done`.
    pub(crate) fn begin(what: &'static str, of: usize, done: usize) -> Self {
        let bar = progress(of as u64).with_position(done as u64).with_message(what);
        bar.tick();
        Self { what, of, done: Mutex::new(done), bar }
    }

    /// One more is done, and this came of it.
    pub(crate) fn done(&self, name: &str, said: impl Display) {
        // Held while it is written: lines come in the order of their numbers.
        let mut done = self.done.lock().unwrap_or_else(PoisonError::into_inner);
        *done += 1;
        self.bar.inc(1);
        if self.bar.is_hidden() {
            eprintln!("{}, {} of {}: {}: {said}", self.what, *done, self.of, line(name));
        }
    }

    /// Nothing is left to do.
    pub(crate) fn end(self) {
        self.bar.finish_and_clear();
    }
}
