//! The vector kernels: loops that the compiler translates for several processors.
//!
//! They are plain loops over short arrays. [`pulp::Arch::dispatch`] has each kernel compiled three
//! times: for any processor, for AVX2 and for AVX-512. The version is chosen when the program runs.
//! So a program also runs on a processor older than the one that it was built on, and uses all
//! features of a newer one. The compiler never fuses a multiplication with an addition here and
//! never exchanges lanes, so all versions give the same bits.
//!
//! A kernel is a type whose [`pulp::NullaryFnOnce::call`] is always inlined. A closure would be
//! shorter. However, the compiler may translate a closure into a separate function for any
//! processor, and call this function from all three versions. Look for `zmm` in the machine code
//! before you trust a kernel.

mod contacts;
mod primitives;
mod select;
mod signs;

use common::soft::{CUTOFF, MASS, MIN_R};

pub use contacts::Contacts;
pub use primitives::Primitives;
pub use select::{Pair, Positions, ROOM, make_room, pack};
pub use signs::{AnyProcessor, EIGHT, Kernel, Signs, dispatch};

/// Returns the larger of two numbers, in one instruction; `b` if `a` is NaN.
#[inline(always)]
pub fn larger(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

/// Returns the factor of the pair acceleration at squared distance `r2` ≤ cutoff².
///
/// The operations are exactly those of [`solution1::pair_acceleration`].
#[inline(always)]
pub fn coefficient(r2: f64) -> f64 {
    let r2 = larger(r2, MIN_R * MIN_R);
    let r = r2.sqrt();
    (1.0 - CUTOFF / r) / r2 / MASS
}
