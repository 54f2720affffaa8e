//! Task 6.7: a rank's share of a scene that no rank holds.

use common::soft::Particle;
use halo::{Cuts, Replay};
use solution2::Grid;

use crate::balanced;

/// The cuts of a scene and the particles of `rank`'s block, from a scene that comes one particle
/// after the other.
///
/// `replay(&mut |particle| …)` calls the function with each particle, as often as it is asked to.
///
/// No rank may keep the whole scene, and the cuts are not known before the particles of all rows
/// are counted. So replay the scene twice: first count the particles in each row of `grid`, and cut
/// the rows ([`balanced`]); then keep the particles of the own block. Every rank finds the same
/// cuts, without a message.
///
/// Book: chapter 6, *A scene that no rank holds*.
pub fn keep_share(
    grid: &Grid,
    ranks: usize,
    rank: usize,
    replay: Replay<'_>,
) -> (Cuts, Vec<Particle>) {
    todo!("task 6.7: each rank keeps its share")
}
