//! Task 1.2: how a particle moves.

use common::Vec2;
use common::soft::{DT, Particle};

/// The greatest number of reflections that are computed one by one.
const MOST_REFLECTIONS: usize = 8;

/// Moves a particle for one time step under acceleration `a`, in a box of side `size`.
///
/// First the velocity changes: v += a dt. Then the position changes with the new velocity:
/// x += v dt (symplectic Euler). Last, the walls reflect the particle: see [`bounce`].
#[inline]
pub fn advance(particle: &mut Particle, a: Vec2, size: f64) {
    particle.vx += a.x * DT;
    particle.vy += a.y * DT;
    (particle.x, particle.vx) = bounce(particle.x + particle.vx * DT, particle.vx, size);
    (particle.y, particle.vy) = bounce(particle.y + particle.vy * DT, particle.vy, size);
}

/// Reflects a coordinate `x`, which may be outside the walls, until it is between 0 and `size`.
///
/// Returns the new coordinate and the new velocity along its axis.
///
/// - While x < 0 or x > `size`, reflect x at that wall: x becomes −x or 2 `size` − x, and v
///   changes its sign. A particle on a wall is inside.
/// - Most particles need no reflection, and a few need one. A very fast particle in a small box may
///   need millions. So after exactly `MOST_REFLECTIONS` reflections, compute the rest without a loop: the path
///   repeats every 2 `size`, and [`f64::rem_euclid`] folds it. If the folded coordinate is
///   beyond `size`, the particle is on its way back: reflect it again.
///
/// The loop and the fold have different rounding errors, and all labs must compute the same last
/// digits. Therefore the number `MOST_REFLECTIONS` is fixed.
///
/// Book: chapter 1, *Walls*.
#[inline]
pub fn bounce(x: f64, v: f64, size: f64) -> (f64, f64) {
    todo!("task 1.2: the move with its bounce")
}
