//! Task 8.12: who moves a disc, and where it is afterwards.

use solution7::{Square, resolve};

use common::hard::Disc;

use crate::{DiscWire, Docket};

/// The discs that this rank moves, at their places after the step: each disc of the square is moved
/// by exactly one rank, though several may have it.
///
/// - A disc that is in a candidate of `docket.taken` was taken here. Both discs of a pair are moved
///   here, own or ghost: lab 7's [`resolve`] carries out what was taken.
/// - A disc that is free flies straight, and is moved by the rank that owns it: `owns[place]`.
/// - A disc that is neither was taken elsewhere, and is moved there. If it was an own one it comes
///   back, or goes to somebody else: forget it.
///
/// `discs` are those that this rank has, own and ghosts, in the order of `docket.numbers`. Since a
/// place is not a number, the candidates must be renamed before [`resolve`] can use them:
/// [`Docket::local`].
///
/// Return the moved ones with their numbers, in ascending order of these.
///
/// Book: chapter 8, *Who moves a disc*.
pub fn move_on(
    discs: &mut [Disc],
    owns: &[bool],
    docket: &Docket,
    square: Square,
) -> Vec<DiscWire> {
    todo!("task 8.12: who moves a disc")
}
