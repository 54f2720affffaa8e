//! The classical Runge-Kutta method.

use common::Vec2;

use integrators::State;

/// The four slopes of the classical Runge-Kutta method for a step of length `h` from `start`,
/// weighted 1, 2, 2, 1 and added up. A sixth of the sum is the slope that the step as a whole
/// follows; the caller goes a time `h` along it.
///
/// A slope is how fast a state changes: in its `at`, of positions, it has the velocity; in its `v`, of
/// velocities, the acceleration. The first slope is the one at `start`, the second the
/// one half a step along the first, the third half a step along the second, the fourth a whole step
/// along the third. Half a step and a whole one always begin at `start`: [`State::along`] takes them.
///
/// `accelerations(at, a)` writes the accelerations of all particles at positions `at` into `a`, which
/// is as long, and overwrites what stands there. It is dear: ask four times.
///
/// Book: chapter 12, *Runge-Kutta*.
pub fn slopes(start: &State, h: f64, accelerations: &mut dyn FnMut(&[Vec2], &mut [Vec2])) -> State {
    todo!("task 12.2: the slopes of a Runge-Kutta step")
}
