//! Arithmetic without branches.

use common::soft::{CUTOFF, MASS, MIN_R};

/// The larger of two numbers, in one instruction; `b` if `a` is NaN.
#[inline(always)]
pub fn larger(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

/// The factor of the pair acceleration at squared distance `r2` ≤ cutoff², with the very
/// operations of [`solution1::pair_acceleration`].
#[inline(always)]
pub fn coefficient(r2: f64) -> f64 {
    let r2 = larger(r2, MIN_R * MIN_R);
    let r = r2.sqrt();
    (1.0 - CUTOFF / r) / r2 / MASS
}
