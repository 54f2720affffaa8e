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

mod contacts;
mod primitives;
mod select;
mod signs;

use common::soft::{CUTOFF, MASS, MIN_R};

pub use contacts::Contacts;
pub use primitives::Primitives;
pub use select::{Pair, Positions, ROOM, make_room, pack};
pub use signs::{AnyProcessor, EIGHT, Kernel, Signs, dispatch};

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
