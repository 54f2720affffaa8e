//! Task 8.12: which rank moves a disc, and where the disc is afterwards.

use common::hard::Disc;
use hard_disc_ranks::{Decisions, DiscWire};
use solution7::{Square, resolve};

/// The discs that this rank moves, as they are after the step. Each disc of the square is moved by
/// exactly one rank, though several may have it.
///
/// - A disc that is in a candidate of `decisions.taken` was taken here. Both discs of a pair are moved
///   here, own or ghost: lab 7's [`resolve`] carries out what was taken.
/// - A disc that is free flies straight, and is moved by the rank that owns it: `owns[slot]`.
/// - A disc that is neither was taken by another rank, which moves it. If this rank owned it, the
///   other rank sends it back, or to a third: leave it out.
///
/// `discs` are the discs of this rank, own and ghosts, in the order of `decisions.numbers`.
/// [`resolve`] finds a candidate's discs by their slots in this list: [`Decisions::local`] puts slots
/// instead of the numbers.
///
/// Return the moved discs with their numbers, in ascending order of these.
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
