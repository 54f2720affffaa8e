//! Task 7.2: two discs.

use common::hard::Disc;
use hard_discs::{Candidate, Hit};

/// When discs a and b of radius `radius` touch in this step, if nothing stops them before.
///
/// Let d be the vector from a to b, D the velocity of b less that of a (so that after time λ the
/// vector is d + λ D), and s = d · D.
///
/// - s ≥ 0: they do not approach each other. None, even if they overlap.
/// - Else, if they overlap or touch already, |d|² ≤ 4 r², they collide at once, λ = 0. Discs at the same
///   position have s = 0.
/// - Else |d + λ D|² = 4 r² is a quadratic equation with Δ = 4 r² |D|² − (d × D)². If Δ ≤ 0 they
///   pass, or only graze. If Δ > 0 they touch first at the smaller root,
///   λ = (−s − √Δ) / |D|².
/// - They collide if λ < 1. At exactly 1 the step is over.
///
/// The root as printed subtracts two numbers that may agree in nearly all their digits. Multiply
/// above and below by −s + √Δ, and it becomes λ = (|d|² − 4 r²) / (−s + √Δ), which does not.
///
/// **This one function serves every program of labs 7 to 9,** called with a < b, so that all of
/// them see the same bits.
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

/// The candidate of discs number `a` < `b`, if there is one.
#[inline]
pub fn pair_hit(discs: &[Disc], a: u32, b: u32, radius: f64) -> Option<Candidate> {
    let time = pair_time(&discs[a as usize], &discs[b as usize], radius)?;
    Some(Candidate { time, hit: Hit::Pair(a, b) })
}
