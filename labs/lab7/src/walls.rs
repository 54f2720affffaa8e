//! Task 7.1: a disc and the walls.

use common::hard::Disc;
use hard_discs::{Candidate, Hit, Square};

/// Returns the collision of disc number `a` with the walls in this step, or `None` if there is
/// none.
///
/// Assume that nothing else stops the disc first. The disc's centre must stay in
/// `square.least() ..= square.most()` along each axis. Look at each axis separately:
///
/// - If the straight path ends below `least` (x + vx < least), the time is λ = (least − x) / vx. If
///   it ends above `most` (x + vx > most), the time is λ = (most − x) / vx. Otherwise the disc hits
///   no wall along this axis.
/// - Rounding may have left the disc very slightly outside, so clamp λ to 0 ..= 1. A disc outside
///   with vx = 0 then hits the wall too: the quotient is infinite, and the clamp makes it 0 or 1.
/// - The earlier of the times along the two axes counts. If both times are equal, the disc hits a
///   corner, which is one collision.
///
/// Book: chapter 7, *Walls*.
#[inline]
pub fn wall_hit(a: u32, disc: &Disc, square: Square) -> Option<Candidate> {
    todo!("task 7.1: the walls")
}
