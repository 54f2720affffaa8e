//! Free flight: where a particle goes in a window if no force bends its path, how close two come, and
//! how far they may be off.

use neighbour_list::kernels::larger;
use windows::Span;

/// Advances one coordinate `x` of particles in free flight by `steps` steps of length `dt`; `v` are as
/// many velocities.
///
/// The result has the bits of step by step: each step adds `v * dt`, rounded once, to the position, and
/// that sum is rounded. But each particle is fetched from memory only once. No wall is near.
///
/// Book: chapter 11, *Free flight*.
#[inline(always)]
pub fn fly(x: &mut [f64], v: &[f64], steps: u32, dt: f64) {
    todo!("task 11.1: free flight")
}

/// The square of the least distance between two points within time `span`: they are (`dx`, `dy`)
/// apart at its beginning, and the second moves with velocity (`wx`, `wy`) as seen by the first.
///
/// - The distance vector at time t is d + t w. Its length is least at t = −(d·w) / (w·w).
/// - That may be before the beginning or after the end: t is clamped to 0 ..= `span`.
/// - Two points that move alike have w = 0 and t = 0/0 = NaN; their distance is |d| at any time.
///   `larger(t, 0.0)` is 0 if t is NaN: there needs to be no branch.
///
/// Book: chapter 11, *Which particles could meet*.
#[inline(always)]
pub fn closest_squared(dx: f64, dy: f64, wx: f64, wy: f64, span: f64) -> f64 {
    todo!("task 11.2: the closest approach of two paths")
}

/// Whether a particle with this `deviation` from its free flight, in units of length, may have come
/// within the cutoff of a particle that the search did not list for it.
///
/// The search listed all pairs whose free flights come within cutoff + `margin`. The other particle of
/// an unlisted pair may be off its path, too, by as much at most: this is asked of the one that is off
/// by more.
///
/// Book: chapter 11, *A margin that is checked*.
#[inline(always)]
pub fn too_far_off(deviation: f64, margin: f64) -> bool {
    todo!("task 11.4: whether the margin held")
}

/// Whether the free flight from (`x`, `y`) with velocity (`vx`, `vy`) may touch a wall, at 0 or at
/// `span.size`, before the window ends: then the particle is computed step by step.
///
/// What counts is where it would be at the end of the window, after [`Span::whole`], not where it is
/// now; a particle that ends within [`Span::rounding`] of a wall counts too, and so does a position that is
/// no number.
///
/// Book: chapter 11, *Walls out of reach*.
#[inline(always)]
pub fn meets_wall(span: &Span, x: f64, y: f64, vx: f64, vy: f64) -> bool {
    todo!("task 11.5: walls within the window")
}
