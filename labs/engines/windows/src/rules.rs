//! What the engine asks of its user.

use crate::span::Span;

/// The decisions on which a window rests.
///
/// Each errs on one side only: to say that two particles may meet, that a wall may be near, that a margin may have
/// broken, or that a window should be short, costs time and changes no bit of the result.
///
/// They are asked in the innermost loops: mark them `#[inline(always)]` where they are a few lines.
pub trait Rules: Send + 'static {
    /// Advances one coordinate `x` of particles in free flight by `steps` steps of length `dt`; `v` are as
    /// many velocities. The bits are those of `steps` times `x += v * dt`. No wall is near.
    fn fly(x: &mut [f64], v: &[f64], steps: u32, dt: f64);

    /// The square of the least distance between two points within time `span`, or less: they are
    /// (`dx`, `dy`) apart at its beginning, and the second moves with velocity (`wx`, `wy`) as seen by the
    /// first.
    fn closest_squared(dx: f64, dy: f64, wx: f64, wy: f64, span: f64) -> f64;

    /// The least number in the group of number `k`. In `parent` each number has one of its group that is
    /// not greater; the least has itself.
    fn root(parent: &mut [u32], k: u32) -> u32;

    /// Makes one group of the groups of `a` and `b`; they may be in one already.
    fn join(parent: &mut [u32], a: u32, b: u32);

    /// Whether a particle with this `deviation` from its free flight may have come within the cutoff of another
    /// one that is off by no more, if their free flights stay further apart than cutoff + `margin`. Both are
    /// lengths.
    fn too_far_off(deviation: f64, margin: f64) -> bool;

    /// Whether the free flight from (`x`, `y`) with velocity (`vx`, `vy`) may touch a wall within the window;
    /// so does one that ends within [`Span::rounding`] of a wall, and one that is no number.
    fn meets_wall(span: &Span, x: f64, y: f64, vx: f64, vy: f64) -> bool;

    /// How many official steps a window should have, at least 1, where there are `density` particles per
    /// area with this mean `speed`.
    fn window_length(density: f64, speed: f64) -> u32;
}
