//! The move of many particles at once.

/// Moves one coordinate of consecutive particles by one step: `v += a * dt`, then `x += v * dt`.
///
/// Use this order of operations, so that the last digit is right too.
///
/// The walls are at 0 and at `size`. Returns whether any particle is now outside. The function does not
/// reflect particles: its caller reflects them if the result is true.
///
/// `v` and `a` are at least as long as `x`. Do not change their entries beyond the length of `x`.
///
/// Book: chapter 10, *Eight at a time, or not*.
#[inline(always)]
pub fn drift(x: &mut [f64], v: &mut [f64], a: &[f64], dt: f64, size: f64) -> bool {
    todo!("task 10.1: the move without branches")
}
