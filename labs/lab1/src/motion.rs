//! Task 1.2: how a particle moves.

use common::Vec2;
use common::soft::{DT, Particle};

/// The most reflections that are done one by one.
const FEW: usize = 8;

/// Moves a particle for one time step under acceleration `a`, in a box of side `size`.
///
/// The velocity changes first, the position follows with the new velocity (symplectic Euler):
/// v += a dt, then x += v dt. Then the walls: see [`bounce`].
#[inline]
pub fn advance(particle: &mut Particle, a: Vec2, size: f64) {
    particle.vx += a.x * DT;
    particle.vy += a.y * DT;
    (particle.x, particle.vx) = bounce(particle.x + particle.vx * DT, particle.vx, size);
    (particle.y, particle.vy) = bounce(particle.y + particle.vy * DT, particle.vy, size);
}

/// Brings a coordinate `x` that may lie outside the walls back between 0 and `size`, and returns
/// it with its velocity.
///
/// - While x < 0 or x > `size`, x is reflected at that wall: x becomes −x or 2 `size` − x, and v
///   changes its sign. On the wall is inside.
/// - Most particles need none, a few one. A particle that is very fast, or a box that is very
///   small, may need millions: after `FEW` reflections, neither more nor fewer, say where it ends
///   without a loop. From there the path repeats itself every 2 `size`, and [`f64::rem_euclid`]
///   folds it; what then lies beyond `size` is on its way back. Each way has its own last digits,
///   and every lab must have the same ones.
///
/// Book: chapter 1, *Walls*.
#[inline]
pub fn bounce(x: f64, v: f64, size: f64) -> (f64, f64) {
    todo!("task 1.2: the move with its bounce")
}
