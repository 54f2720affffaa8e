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
    // task 12.2: the slopes of a Runge-Kutta step
    let n = start.at.len();
    let mut sum = State { at: vec![Vec2::ZERO; n], v: vec![Vec2::ZERO; n] };
    let mut stage = start.clone();
    let mut a = vec![Vec2::ZERO; n];
    // How much each slope weighs, and how far along it the next one is looked for.
    for (weight, next) in [(1.0, 0.5), (2.0, 0.5), (2.0, 1.0), (1.0, 0.0)] {
        accelerations(&stage.at, &mut a);
        // `State::along` is shorter, and a fifth slower: each stage is a new one, in new memory.
        for (i, &a) in a.iter().enumerate() {
            sum.at[i] += weight * stage.v[i];
            sum.v[i] += weight * a;
            stage.at[i] = start.at[i] + (next * h) * stage.v[i];
            stage.v[i] = start.v[i] + (next * h) * a;
        }
    }
    sum
    // end 12.2
}
