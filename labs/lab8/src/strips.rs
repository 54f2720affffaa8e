//! Task 8.8: the strips that a disc reaches, and the rank that tests a pair.

use hard_disc_ranks::{DiscWire, Reach, Strips};
use solution7::{Window, span};

/// Returns the ranks whose strips overlap the swept box of a disc.
///
/// The disc can touch nothing outside these strips in this step. `reach` is the distance that the
/// box extends beyond the path of the centre.
///
/// Lab 7's [`span`] returns the box along y, from `low` to `high`, for the whole step:
/// [`Window::STEP`]. The strips between these two ends are adjacent.
///
/// Book: chapter 8, *Strips and ghosts*.
pub fn reached(strips: &Strips, disc: &DiscWire, reach: f64) -> Reach {
    todo!("task 8.8: which strips a box reaches")
}

/// Whether `rank` is the rank that tests a pair of discs.
///
/// `a` and `b` are the strips that the two discs reach. Of the ranks that have both discs, exactly
/// one tests the pair. No rank needs a message to know which rank this is. If the discs reach no
/// strip in common, they cannot meet, and no rank tests the pair.
///
/// A pair that meets at a cut is known on both sides of it. Lab 7 has the same problem with a pair
/// whose boxes share several rows of cells. The answer is the same: of the strips that both discs
/// reach, take the lowest.
///
/// Book: chapter 8, *One rank looks at a pair*.
#[inline]
pub fn looks_at(rank: usize, a: Reach, b: Reach) -> bool {
    todo!("task 8.8b: one rank looks at a pair")
}
