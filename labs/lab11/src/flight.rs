//! Free flight: the path of a particle in a window if no force bends it.
//!
//! The tasks compute the path, the least distance of two paths, and the deviation that is allowed.

use neighbour_list::kernels::larger;
use windows::Span;

/// Advances `x`, one coordinate of each particle in free flight, by `steps` steps of length `dt`.
///
/// `v` contains the velocity of each particle along this coordinate. No wall is near.
///
/// The result must be, bit for bit, the result of single steps. Each step rounds the product
/// `v * dt` once, adds it to the position, and rounds the sum. But fetch each particle from memory
/// only once.
///
/// Book: chapter 11, *Free flight*.
#[inline(always)]
pub fn fly(x: &mut [f64], v: &[f64], steps: u32, dt: f64) {
    todo!("task 11.1: free flight")
}

/// Returns the square of the least distance between two points within the time `span`.
///
/// At the beginning, the second point is at (`dx`, `dy`) as seen from the first, and moves with velocity
/// (`wx`, `wy`) as seen from the first.
///
/// - The distance vector at time t is d + t w. Its length is least at t = −(d·w) / (w·w).
/// - This time may be before the beginning or after the end, so clamp t to 0 ..= `span`.
/// - Two points with the same velocity have w = 0 and t = 0/0 = NaN. Their distance is |d| at any time.
///   `larger(t, 0.0)` is 0 if t is NaN, so you need no branch.
///
/// Book: chapter 11, *Which particles could meet*.
#[inline(always)]
pub fn closest_squared(dx: f64, dy: f64, wx: f64, wy: f64, span: f64) -> f64 {
    todo!("task 11.2: the closest approach of two paths")
}

/// Whether a particle may have come within the cutoff of a particle that is not in its list.
///
/// - `deviation`: the distance of the particle from its free flight, in units of length.
/// - `margin`: the search listed all pairs whose free flights come within cutoff + `margin`.
///
/// The other particle of an unlisted pair may also be off its path, by at most the same distance,
/// because the engine calls this function for the particle with the greater deviation.
///
/// Book: chapter 11, *A margin that is checked*.
#[inline(always)]
pub fn too_far_off(deviation: f64, margin: f64) -> bool {
    todo!("task 11.4: the check of the margin")
}

/// Whether the free flight from (`x`, `y`) with velocity (`vx`, `vy`) may touch a wall in the window.
///
/// The walls are at 0 and at `span.size`. If the result is true, the engine computes the particle step by
/// step.
///
/// Check the position at the end of the window, after [`Span::whole`], and not the position now. A
/// particle that ends within [`Span::rounding`] of a wall touches it, and so does a particle whose position
/// is NaN.
///
/// Book: chapter 11, *Walls out of reach*.
#[inline(always)]
pub fn meets_wall(span: &Span, x: f64, y: f64, vx: f64, vy: f64) -> bool {
    todo!("task 11.5: walls within the window")
}
