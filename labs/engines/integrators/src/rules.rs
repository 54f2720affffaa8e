//! The decisions that the engines leave to their user.

use common::Vec2;

use crate::state::State;

/// The slope of a Runge-Kutta step, and the time of an event.
pub trait Rules: Send + Sync + 'static {
    /// Returns six times the slope that a step of length `h` from `start` follows.
    ///
    /// `accelerations(at, a)` overwrites `a` with the accelerations of all particles at positions
    /// `at`. Both slices have the same length.
    fn slopes(start: &State, h: f64, accelerations: &mut dyn FnMut(&[Vec2], &mut [Vec2])) -> State;

    /// Returns the first time from 0 to `h` at which a number falls through zero, or `None`.
    ///
    /// `start` contains the value and slope of the number at time 0, and `end` at time `h`. `at`
    /// computes both at any time between.
    fn first_fall(
        start: Watched,
        end: Watched,
        h: f64,
        at: &mut dyn FnMut(f64) -> Watched,
    ) -> Option<f64>;
}

/// An event function at some time: a number that is at least 0 until the event, and its slope.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Watched {
    /// The value of the function.
    pub value: f64,
    /// The change of the value per unit of time.
    pub slope: f64,
}
