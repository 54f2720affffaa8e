//! Task 8.12: the rank that moves a disc, and the disc after the step.

use common::hard::Disc;
use hard_disc_ranks::{Decisions, DiscWire};
use solution7::{Square, resolve};

/// Returns the discs that this rank moves, as they are after the step.
///
/// Exactly one rank moves each disc of the square, although several ranks may have it.
///
/// - A disc in a candidate of `decisions.taken` was taken here. This rank moves both discs of a
///   pair, even ghosts. Lab 7's [`resolve`] carries out the candidates that were taken.
/// - A free disc flies straight, and the rank that owns it moves it. This rank owns the disc if
///   `owns[slot]` is true.
/// - Any other disc was taken by another rank, which moves it. Leave the disc out, even if this
///   rank owns it: the other rank sends it to the right owner.
///
/// `discs` are the rank's own discs and the ghosts, in the order of `decisions.numbers`.
/// [`resolve`] finds the discs of a candidate by their slots in this list: [`Decisions::local`]
/// replaces the numbers with slots.
///
/// Return the moved discs with their numbers, in ascending order of the numbers.
///
/// Book: chapter 8, *One rank moves a disc*.
pub fn move_on(
    discs: &mut [Disc],
    owns: &[bool],
    decisions: &Decisions,
    square: Square,
) -> Vec<DiscWire> {
    todo!("task 8.12: which rank moves a disc")
}
