//! Windows of several steps: opening, verification, repair and end.
//!
//! Start reading with `opening`: there every `band` searches and computes its groups. Then `verify`
//! finds the pairs that were missed, and `ending` moves the particles to the end of the window.

mod band;
mod ending;
mod missed;
mod opening;
mod verify;

pub(crate) use opening::Window;

use neighbour_list::engine;

/// Counters of windows.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct WindowCounts {
    /// Number of windows.
    pub(crate) windows: u64,
    /// Number of lists that were built for windows.
    pub(crate) lists: u64,
    /// Number of pairs that were tested.
    pub(crate) tests: u64,
    /// Number of particles that flew freely through a window.
    pub(crate) flown: u64,
    /// Number of moves: one for each step of a particle in a group, and one for each window of a
    /// free particle.
    pub(crate) touched: u64,
    /// Number of particles that were computed again.
    pub(crate) repaired: u64,
    /// Number of windows that were repeated with half the steps.
    pub(crate) redone: u64,
    /// Number of particles that might have reached a wall.
    pub(crate) walls: u64,
}

impl WindowCounts {
    /// Returns the counters with their names.
    ///
    /// `n` is the number of particles and `steps` the number of steps. `plain` counts the steps
    /// with a neighbour list.
    pub(crate) fn shown(
        &self,
        n: usize,
        steps: u64,
        plain: &engine::Counts,
    ) -> Vec<(&'static str, f64)> {
        let n = n as f64;
        let steps = steps as f64;
        let touched = self.touched as f64 + plain.steps as f64 * n;
        let windows = (self.windows as f64).max(1.0);
        vec![
            ("pair tests per particle and step", (self.tests + plain.tests) as f64 / (n * steps)),
            ("particles touched per particle and step", touched / (n * steps)),
            ("windows", self.windows as f64),
            ("windows redone", self.redone as f64),
            ("neighbour lists built", (self.lists + plain.rebuilds) as f64),
            ("share that flies freely through a window", self.flown as f64 / (n * windows)),
            ("share computed again", self.repaired as f64 / (n * windows)),
            ("share near walls", self.walls as f64 / (n * windows)),
        ]
    }
}
