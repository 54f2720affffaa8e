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

mod arithmetic;
mod select;
mod signs;

pub use arithmetic::{coefficient, larger};
pub use select::{Pair, Places, ROOM, pack};
pub use signs::{AnyProcessor, EIGHT, Kernel, Signs, dispatch};
