//! Task 7.1: a disc and the walls.

use common::hard::Disc;
use hard_discs::{Candidate, Hit, Square};

/// The collision of disc number `a` with the walls in this step, if nothing stops it before.
///
/// Along each axis for itself, with the centre in `square.least() ..= square.most()`:
///
/// - If the straight path ends below, x + vx < least, the time is λ = (least − x) / vx. If it ends
///   above, x + vx > most, it is λ = (most − x) / vx. Else this axis has no wall to hit.
/// - Rounding may have left the disc very slightly outside: clamp λ to 0 ..= 1. So a disc outside with vx = 0 hits
///   too: the quotient is infinite, and the clamp makes it 0 or 1.
/// - The earlier of the two axes counts. If both times are the same it is a corner, which is one
///   collision.
///
/// Book: chapter 7, *Walls*.
#[inline]
pub fn wall_hit(a: u32, disc: &Disc, square: Square) -> Option<Candidate> {
    todo!("task 7.1: the walls")
}
