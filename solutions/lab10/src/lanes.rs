//! The vector kernels.
//!
//! They are plain loops over short arrays, compiled several times by
//! [`pulp::Arch::dispatch`]: for any processor, for AVX2 and for AVX-512. The one that runs is
//! chosen when it runs, so that a program built here neither crashes on an older processor nor
//! crawls on a newer one. The compiler never fuses a multiplication with an addition here, and
//! lanes do not mix: every version gives the same bits.
//!
//! A kernel is a type with a [`pulp::NullaryFnOnce::call`] that is always inlined. A closure would
//! be shorter, but the compiler may leave it a function of its own, translated for any processor,
//! and call that three times. Look for `zmm` in the program before you believe a kernel.

use common::soft::{CUTOFF, MASS, MIN_R};

/// The larger of two numbers, in one instruction; `b` if `a` is NaN.
#[inline(always)]
pub(crate) fn larger(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

/// The factor of the pair acceleration at squared distance `r2` ≤ cutoff², with the very
/// operations of [`solution1::pair_acceleration`].
#[inline(always)]
pub(crate) fn coefficient(r2: f64) -> f64 {
    let r2 = larger(r2, MIN_R * MIN_R);
    let r = r2.sqrt();
    (1.0 - CUTOFF / r) / r2 / MASS
}

/// Moves one coordinate of a chunk of particles, `v += a dt`, `x += v dt`, and says whether any
/// of them is now outside the walls, at 0 and at `size`: then the chunk is looked at again, one by
/// one. There are at least as many velocities and accelerations as places.
#[inline(always)]
pub fn drift(x: &mut [f64], v: &mut [f64], a: &[f64], dt: f64, size: f64) -> bool {
    // task 10.1: the move without branches
    let n = x.len();
    let (v, a) = (&mut v[..n], &a[..n]);
    let mut outside = false;
    for i in 0..n {
        v[i] += a[i] * dt;
        x[i] += v[i] * dt;
        outside |= (x[i] < 0.0) | (x[i] > size);
    }
    outside
    // end 10.1
}
