//! Task 7.3: which of two collisions that could happen in this step comes first.

use std::cmp::Ordering;

use hard_discs::Candidate;

/// Which of two candidates is taken first.
///
/// - The earlier, whatever it is.
/// - At *exactly* the same time walls come before pairs: corners, then x walls, then y walls.
///   Among the same kind the lower first number, then the lower second number.
///
/// Compare times exactly. A tolerance («closer than 1e-10 is the same») makes an order in which
/// a = b and b = c but a < c, and a sort by it may do anything. Two zeros are the same time even if
/// one of them is −0.0, so [`f64::total_cmp`] is not the right comparison; no time is NaN.
///
/// Book: chapter 7, *The earliest first*.
#[inline]
pub fn order(a: &Candidate, b: &Candidate) -> Ordering {
    todo!("task 7.3: which of two candidates comes first")
}
