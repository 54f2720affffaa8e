//! Task 8.9: the discs that a partner needs as ghosts.

use hard_disc_ranks::{DiscWire, Strips};

use crate::strips::reached;

/// Returns one list for each of `partners`, with copies of the discs that reach the partner's
/// strip.
///
/// A disc of `own` reaches a strip if its swept box does. [`reached`] returns the strips that a
/// disc reaches; pass `reach` on to it. A disc that flies far may reach several partners. Lists are
/// in the order of `partners`, and each list is in the order of `own`. This rank is not among the
/// partners.
///
/// Book: chapter 8, *Strips and ghosts*.
pub fn ghosts_for(
    partners: &[usize],
    own: &[DiscWire],
    strips: &Strips,
    reach: f64,
) -> Vec<Vec<DiscWire>> {
    let mut lists = vec![Vec::new(); partners.len()];
    todo!("task 8.9: ghosts");
    lists
}
