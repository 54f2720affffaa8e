//! Task 8.9: which discs a partner needs copies of.

use hard_disc_ranks::{DiscWire, Strips};

use crate::strips::reached;

/// For each of `partners`, in their order, copies of those of the `own` discs whose swept boxes reach
/// its strip, in the order of `own`.
///
/// A disc that flies far may go to several partners. [`reached`] says to which; `reach` is its
/// argument. This rank itself is not among the partners.
///
/// Book: chapter 8, *Strips and ghosts*.
pub fn ghosts_for(
    partners: &[usize],
    own: &[DiscWire],
    strips: &Strips,
    reach: f64,
) -> Vec<Vec<DiscWire>> {
    let mut lists = vec![Vec::new(); partners.len()];
    // task 8.9: ghosts
    for disc in own {
        let reached = reached(strips, disc, reach);
        for (partner, list) in partners.iter().zip(&mut lists) {
            if reached.contains(*partner) {
                list.push(*disc);
            }
        }
    }
    // end 8.9
    lists
}
