//! The steps of a window, and the box.

use common::soft::CUTOFF;

/// The steps of a window and the box that contains its particles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Span {
    /// Number of small steps in the window.
    pub steps: u32,
    /// Length of a small step.
    pub dt: f64,
    /// Side of the box.
    pub size: f64,
}

impl Span {
    /// Returns the time from the start of the window to its end.
    pub fn duration(&self) -> f64 {
        f64::from(self.steps) * self.dt
    }

    /// Returns an upper bound for the sum of all rounding errors of a position in the window.
    pub fn rounding(&self) -> f64 {
        1e-9 * CUTOFF + 2.0 * f64::from(self.steps + 4) * f64::EPSILON * self.size
    }

    /// Returns the time from the first force computation of the window to the last.
    pub(crate) fn forces(&self) -> f64 {
        f64::from(self.steps - 1) * self.dt
    }
}
