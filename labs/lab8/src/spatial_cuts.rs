//! Task 8.13: a step without a master.

use hard_disc_ranks::{Deciding, Seen, SpatialCuts, walls_of};
use solution7::Lab7;

use crate::certain::take_certain;
use crate::ghosts::ghosts_for;
use crate::moves::move_on;
use crate::news::{hear, news_for};

/// Decides together with the partners, starting with the state of `engine.decisions`.
///
/// Repeat in rounds:
///
/// 1. Take the candidates that are certain ([`take_certain`]).
/// 2. Add up the news of all ranks ([`SpatialCuts::add_up`]): the candidates in `front`, and the taken
///    candidates that have not been reported yet. (`front` is empty only if no candidate is open.) If
///    the sum is zero, return. All ranks get the same sum, so all ranks return in the same round.
/// 3. Make the news for each partner ([`news_for`]). From now on, all taken candidates count as reported.
///    Exchange the news ([`SpatialCuts::exchange`], with no work during the exchange). Take in the news
///    of all partners at once ([`hear`]).
///
/// In every round, the earliest open candidate of all ranks is taken or dropped, so the rounds end.
/// Usually there are two to five rounds. In a crowd there may be a hundred, because a decision
/// waits for a decision across the cut, which waits for a decision on this side.
///
/// All ranks call this together, even ranks without partners or candidates.
///
/// Book: chapter 8, *Deciding together*.
fn decide<T: Deciding>(engine: &mut SpatialCuts<T>, partners: &[usize]) {
    todo!("task 8.13: decide together")
}

/// Computes one step.
///
/// 1. Agree once on the `range` of this step ([`SpatialCuts::range`]). It determines the partners of
///    this rank: [`Strips::partners`] within `range.furthest`.
/// 2. Send ghosts to the partners ([`ghosts_for`], [`SpatialCuts::exchange`]). While they travel,
///    find the wall collisions of the rank's own discs ([`walls_of`] by the rules of [`Lab7`]). The
///    owner of a ghost finds the ghost's wall collisions. Nothing in `engine` can be borrowed
///    during an exchange, so [take](std::mem::take) `own` out, and put it back afterwards.
/// 3. Combine the rank's own discs and the ghosts ([`SpatialCuts::see`]), and find the pairs
///    ([`SpatialCuts::find`]). This also starts the decisions, and takes the certain candidates at
///    once.
/// 4. Decide the other candidates ([`decide`]).
/// 5. Move the discs ([`move_on`], of `engine.seen`), and count the candidates taken
///    (`engine.tally.taken`). Send each disc to the rank whose strip now contains it
///    ([`SpatialCuts::bring`]).
///
/// All ranks call this together.
///
/// Book: chapter 8, *A step without a master*.
///
/// [`Strips::partners`]: hard_disc_ranks::Strips::partners
pub(crate) fn step<T: Deciding>(engine: &mut SpatialCuts<T>) {
    todo!("task 8.13b: a step without a master")
}
