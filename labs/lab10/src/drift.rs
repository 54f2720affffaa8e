//! The move of many particles at once.

/// Moves one coordinate of consecutive particles by one step: `v += a dt`, then `x += v dt`. Returns
/// whether any of them is now outside the walls, at 0 and at `size`; the caller then reflects
/// them one by one.
///
/// `v` and `a` are at least as long as `x`; what they hold beyond its length stays as it is.
///
/// Book: chapter 10, *Eight at a time, or not*.
#[inline(always)]
pub fn drift(x: &mut [f64], v: &mut [f64], a: &[f64], dt: f64, size: f64) -> bool {
    todo!("task 10.1: the move without branches")
}
