//! Windows of several steps, and what they count.

mod band;
mod ending;
mod missed;
mod opening;
mod verify;

pub(crate) use opening::Window;

use neighbour_list::engine;

/// What windows count.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct WindowCounts {
    /// Windows.
    pub(crate) windows: u64,
    /// Lists built for windows.
    pub(crate) lists: u64,
    /// Pairs looked at.
    pub(crate) tests: u64,
    /// Particles that flew freely through a window.
    pub(crate) flown: u64,
    /// Particles moved, one for each step of a particle in a group and one for each window of a
    /// free one.
    pub(crate) touched: u64,
    /// Particles computed again.
    pub(crate) repaired: u64,
    /// Windows redone with half the steps.
    pub(crate) redone: u64,
    /// Particles that might have reached a wall.
    pub(crate) walls: u64,
}

impl WindowCounts {
    /// With names, for a run of `n` particles through `steps` steps, some of them by the `plain`
    /// list.
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
