//! What the engines ask of their user.

use common::Vec2;

use crate::state::State;

/// What a Runge-Kutta method asks for, and one that stops at events.
pub trait Rules: Send + Sync + 'static {
    /// Six times the slope that a step of length `h` from `start` follows as a whole.
    ///
    /// `accelerations(at, a)` writes the accelerations of all particles at positions `at` into `a`, which
    /// is as long, and overwrites what stands there.
    fn slopes(start: &State, h: f64, accelerations: &mut dyn FnMut(&[Vec2], &mut [Vec2])) -> State;

    /// The first moment from 0 to `h` at which a number falls through zero, if it does. `start` is its value and
    /// slope at 0, `end` at `h`, and `at` computes them anywhere between.
    fn first_fall(
        start: Watched,
        end: Watched,
        h: f64,
        at: &mut dyn FnMut(f64) -> Watched,
    ) -> Option<f64>;
}

/// An event function at some moment: a number that is at least 0 until the event, and its slope.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Watched {
    /// The number.
    pub value: f64,
    /// Its change per unit of time.
    pub slope: f64,
}
