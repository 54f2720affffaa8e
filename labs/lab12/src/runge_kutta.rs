//! The classical Runge-Kutta method.

use common::Vec2;

use integrators::State;

/// Returns the sum of the four slopes of a classical Runge-Kutta step, weighted 1, 2, 2, 1.
///
/// The step has the length `h` and begins at `start`. The caller divides the sum by six, and moves
/// along this mean slope for a time `h`.
///
/// A slope is the rate of change of a state. Its `at` is the rate of change of the positions: the
/// velocities. Its `v` is the rate of change of the velocities: the accelerations. The four slopes
/// are taken at:
///
/// 1. `start`;
/// 2. half a step from `start` along the first slope;
/// 3. half a step from `start` along the second slope;
/// 4. a whole step from `start` along the third slope.
///
/// [`State::along`] moves a state along a slope.
///
/// `accelerations(at, a)` computes the accelerations of all particles at the positions `at`. It
/// overwrites `a`, which must be as long as `at`. It is expensive, so call it only four times.
///
/// Book: chapter 12, *Runge-Kutta*.
pub fn slopes(start: &State, h: f64, accelerations: &mut dyn FnMut(&[Vec2], &mut [Vec2])) -> State {
    todo!("task 12.2: the slopes of a Runge-Kutta step")
}
