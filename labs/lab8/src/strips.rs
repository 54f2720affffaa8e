//! Task 8.8: which strips a disc can be found in, and which rank looks at a pair.

use hard_disc_ranks::{DiscWire, Reach, Strips};
use solution7::{Window, span};

/// The ranks in whose strips the swept box of a disc lies: where it can touch anything in this
/// step. `reach` is how far the box goes beyond the path of the centre.
///
/// Lab 7's [`span`] gives the box along y, from `low` to `high`, for the whole step: [`Window::STEP`]. Between
/// these two ends it lies in neighbouring strips.
///
/// Book: chapter 8, *Strips and ghosts*.
pub fn reached(strips: &Strips, disc: &DiscWire, reach: f64) -> Reach {
    todo!("task 8.8: which strips a box reaches")
}

/// Whether `rank` is the one that looks at the pair of discs that reach a and b. Of all ranks that
/// have both exactly one does, and none has to ask another. Discs that share no strip cannot meet: no rank looks
/// at such a pair.
///
/// A pair that meets at a cut is known on both sides of it. Lab 7 has the same problem with a pair
/// whose boxes share several rows of cells, and the same answer: of the strips that both discs reach,
/// the lowest.
///
/// Book: chapter 8, *One rank looks at a pair*.
#[inline]
pub fn looks_at(rank: usize, a: Reach, b: Reach) -> bool {
    todo!("task 8.8b: one rank looks at a pair")
}
