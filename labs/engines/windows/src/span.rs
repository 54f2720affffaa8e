//! The steps of a window, and the box.

use common::soft::CUTOFF;

/// The steps of a window and the box that its particles are in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Span {
    /// Steps in the window.
    pub steps: u32,
    /// Length of a step.
    pub dt: f64,
    /// Side of the box.
    pub size: f64,
}

impl Span {
    /// Time from the start of the window to its end.
    pub fn whole(&self) -> f64 {
        f64::from(self.steps) * self.dt
    }

    /// More than the sum of roundings of a position in the window.
    pub fn rounding(&self) -> f64 {
        1e-9 * CUTOFF + 2.0 * f64::from(self.steps + 4) * f64::EPSILON * self.size
    }

    /// Time from the first forces of the window to the last.
    pub(crate) fn forces(&self) -> f64 {
        f64::from(self.steps - 1) * self.dt
    }
}
