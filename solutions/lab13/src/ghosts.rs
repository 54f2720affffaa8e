//! Task 13.3: ghosts, chosen when a list is made.

use std::ops::Range;

use neighbour_list::kernels::{Pair, Positions};

/// Returns the particles that a partner needs: indices into `y`, in ascending order.
///
/// A particle is needed if its distance from the partner's `strip` is at most `width`.
///
/// - `y`: the y coordinates of the rank's particles, in the engine's order. All these particles are
///   in the rank's own strip, before or after the partner's strip.
/// - `strip`: the partner's strip. An end of it may be infinite.
/// - `width`: a length, like `y` and `strip`.
///
/// The choice is made once, for all steps until the next list is made. The partner then knows each
/// chosen particle by its index in the message, so the messages contain nothing but positions.
///
/// Book: chapter 13, *What is sent when*.
pub fn choose(y: &[f64], strip: &Range<f64>, width: f64) -> Vec<u32> {
    // task 13.3: the particles that a partner needs
    let is_near = |y: f64| strip.start - y <= width && y - strip.end <= width;
    (0..).zip(y).filter(|(_, y)| is_near(**y)).map(|(index, _)| index).collect()
    // end 13.3
}

/// Returns the pairs of a particle of this rank and a ghost that are at most `reach` apart.
///
/// A pair is [index into `own`, index into `ghosts`]. The pairs must be in the order of the first
/// index. The order of pairs with the same first index must depend only on positions.
///
/// The other rank lists the same pair, with its own particle first. Each of the two ranks
/// accelerates only its own particle, so no force has to be sent.
///
/// Both lists hold thousands of particles, and most of these are far apart along x. Sort the ghosts
/// by x. For each of the rank's particles, look only at the ghosts from x − `reach` to x + `reach`.
///
/// Book: chapter 13, *Pairs across*.
pub fn pairs_across(own: Positions<'_>, ghosts: Positions<'_>, reach: f64) -> Vec<Pair> {
    // task 13.3b: pairs of own particles and ghosts
    let mut order: Vec<u32> = (0..ghosts.x.len() as u32).collect();
    let along = |ghost: u32| ghosts.x[ghost as usize];
    order.sort_unstable_by(|a, b| along(*a).total_cmp(&along(*b)).then(a.cmp(b)));
    let mut pairs = Vec::new();
    for (i, (x, y)) in (0..).zip(own.x.iter().zip(own.y)) {
        let first = order.partition_point(|ghost| along(*ghost) < x - reach);
        for &ghost in order[first..].iter().take_while(|ghost| along(**ghost) <= x + reach) {
            let (dx, dy) = (along(ghost) - x, ghosts.y[ghost as usize] - y);
            if dx * dx + dy * dy <= reach * reach {
                pairs.push([i, ghost]);
            }
        }
    }
    pairs
    // end 13.3b
}
