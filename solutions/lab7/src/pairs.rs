//! Task 7.2: two discs.

use common::hard::Disc;
use hard_discs::{Candidate, Hit};

/// Returns the time λ at which discs a and b touch in this step, or `None` if they do not touch.
///
/// Assume that nothing else stops the discs first. Both discs have radius r = `radius`. Let d be
/// the vector from a to b. Let D be the velocity of b minus the velocity of a, so the vector at
/// time λ is d + λ D. Let s = d · D.
///
/// - If s ≥ 0, the discs do not approach each other. Return `None`, even if they overlap.
///   (Discs at the same position have s = 0, so the result for them is `None`.)
/// - Otherwise, if they overlap or touch already (|d|² ≤ 4 r²), they collide at once, at λ = 0.
/// - Otherwise, |d + λ D|² = 4 r² is a quadratic equation with Δ = 4 r² |D|² − (d × D)². If Δ ≤ 0,
///   the discs pass each other, or only graze. If Δ > 0, they first touch at the smaller root,
///   λ = (−s − √Δ) / |D|².
/// - They collide if λ < 1. At exactly 1 the step is over.
///
/// In this form, the root subtracts two numbers that may agree in nearly all their digits. Multiply
/// the numerator and the denominator by −s + √Δ. The root becomes λ = (|d|² − 4 r²) / (−s + √Δ),
/// which has no such subtraction.
///
/// **Every program of labs 7 to 9 calls this one function,** with a < b, so that all programs
/// compute the same bits.
///
/// Book: chapter 7, *Two discs*.
#[inline]
pub fn pair_time(a: &Disc, b: &Disc, radius: f64) -> Option<f64> {
    // task 7.2: two discs
    let d = b.position() - a.position();
    let velocity = b.velocity() - a.velocity();
    let s = d.dot(velocity);
    if s >= 0.0 {
        return None;
    }
    let (distance, reach) = (d.norm_squared(), 4.0 * radius * radius);
    if distance <= reach {
        return Some(0.0);
    }
    let cross = d.cross(velocity);
    let delta = reach * velocity.norm_squared() - cross * cross;
    if delta <= 0.0 {
        return None;
    }
    let time = (distance - reach) / (delta.sqrt() - s);
    (time < 1.0).then_some(time)
    // end 7.2
}

/// Returns the candidate of discs `a` and `b` (`a` < `b`), or `None` if they do not collide in this
/// step.
#[inline]
pub fn pair_hit(discs: &[Disc], a: u32, b: u32, radius: f64) -> Option<Candidate> {
    let time = pair_time(&discs[a as usize], &discs[b as usize], radius)?;
    Some(Candidate { time, hit: Hit::Pair(a, b) })
}
