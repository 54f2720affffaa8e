//! Task 7.3: the order of two collisions that could happen in this step.

use std::cmp::Ordering;

use hard_discs::Candidate;

/// Compares two candidates. The lesser is taken first.
///
/// - The earlier candidate comes first, whatever its kind.
/// - At *exactly* the same time, walls come before pairs: corners, then x walls, then y walls.
/// - Within a kind, the candidate with the lower first disc number comes first. If the first
///   numbers are equal, the lower second number decides.
///
/// Compare times exactly. With a tolerance ("times closer than 1e-10 are equal"), a = b and b = c
/// are possible while a < c, and a sort by such an order may do anything. Two zeros are the same time
/// even if one of them is −0.0, so [`f64::total_cmp`] is not the right comparison. No time is NaN.
///
/// Book: chapter 7, *The earliest first*.
#[inline]
pub fn order(a: &Candidate, b: &Candidate) -> Ordering {
    todo!("task 7.3: which of two candidates comes first")
}
