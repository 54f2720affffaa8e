//! Task 8.13: a step without a master.

use hard_disc_ranks::{Deciding, Seen, SpatialCuts, walls_of};
use solution7::Lab7;

use crate::certain::take_certain;
use crate::ghosts::ghosts_for;
use crate::moves::move_on;
use crate::news::{hear, news_for};

/// Decides together with the partners, starting from what `engine.decisions` knows.
///
/// In rounds:
///
/// 1. Take what is certain ([`take_certain`]).
/// 2. All ranks add up how much there is to tell: the candidates in `front`, which is empty only if
///    none is open, and the taken candidates that have not been told ([`SpatialCuts::add_up`]). If the sum
///    is zero, return. All ranks get the same sum, so all return in the same round.
/// 3. Make the news for each partner ([`news_for`]); from now on all taken candidates
///    count as told. Exchange the news ([`SpatialCuts::exchange`], with nothing to do beside), and hear
///    the news of all partners at once ([`hear`]).
///
/// In every round the earliest candidate that is open on any rank is taken or dropped, so the rounds
/// end: mostly after two to five; in a crowd, where a decision waits for one across the cut and
/// that for another back across it, after a hundred.
///
/// All ranks call it together, ranks without partners or candidates too.
///
/// Book: chapter 8, *Deciding together*.
fn decide<T: Deciding>(engine: &mut SpatialCuts<T>, partners: &[usize]) {
    // task 8.13: decide together
    loop {
        take_certain(&mut engine.decisions);
        let untold = engine.decisions.taken.len() - engine.decisions.told;
        if engine.add_up(engine.decisions.front.len() + untold) == 0 {
            return;
        }
        let news = partners.iter().map(|&partner| news_for(&engine.decisions, partner)).collect();
        engine.decisions.told = engine.decisions.taken.len();
        let (arrived, ()) = engine.exchange(partners, news, || ());
        hear(&mut engine.decisions, &arrived.concat());
    }
    // end 8.13
}

/// One step.
///
/// 1. Agree on the `range` of this step ([`SpatialCuts::range`]), from which the partners follow:
///    [`Strips::partners`] of this rank within `range.furthest`.
/// 2. Send ghosts to the partners ([`ghosts_for`], [`SpatialCuts::exchange`]), and while they travel
///    find the wall collisions of the own discs ([`walls_of`] by the rules of [`Lab7`]). The owner of a ghost finds
///    its wall collisions. While `engine` exchanges, nothing of it can be borrowed: [take](std::mem::take) `own` out, and
///    put it back.
/// 3. Put own discs and ghosts together ([`SpatialCuts::see`]), and find the pairs ([`SpatialCuts::find`]): this
///    starts the decisions and takes what is certain at once.
/// 4. Decide about the rest ([`decide`]).
/// 5. Move the discs ([`move_on`], of `engine.seen`), count what was taken (`engine.tally.taken`), and send each disc to
///    the rank in whose strip it is now ([`SpatialCuts::bring`]).
///
/// All ranks call it together.
///
/// Book: chapter 8, *A step without a master*.
///
/// [`Strips::partners`]: hard_disc_ranks::Strips::partners
pub(crate) fn step<T: Deciding>(engine: &mut SpatialCuts<T>) {
    // task 8.13b: a step without a master
    let range = engine.range();
    let partners = engine.strips.partners(engine.rank(), range.furthest);
    let ghosts = ghosts_for(&partners, &engine.own, &engine.strips, range.reach);
    let (own, square) = (std::mem::take(&mut engine.own), engine.square);
    let (arrived, walls) = engine.exchange(&partners, ghosts, || walls_of::<Lab7>(&own, square));
    engine.own = own;
    engine.see(&arrived, range);
    engine.find(walls);
    decide(engine, &partners);
    let Seen { discs, owns, .. } = &mut engine.seen;
    let moved = move_on(discs, owns, &engine.decisions, engine.square);
    engine.tally.taken(&engine.decisions.taken);
    engine.bring(&partners, moved);
    // end 8.13b
}
