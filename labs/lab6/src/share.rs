//! Task 6.7: a rank's share of a scene that is never in memory as a whole.

use common::soft::Particle;
use halo::{Cuts, Replay};
use solution2::Grid;

use crate::balanced;

/// Returns the cuts of a scene and the particles in `rank`'s block.
///
/// `replay` yields the scene one particle at a time: `replay(&mut |particle| …)` calls the function
/// with each particle. Every call draws the whole scene again, so call `replay` only twice.
///
/// No rank may keep the whole scene, nor a number for each of its particles. The cuts depend on the
/// particles of all rows. So replay the scene twice:
///
/// 1. Count the particles in each row of `grid`, and cut the rows ([`balanced`]).
/// 2. Keep the particles of the rank's block.
///
/// Every rank computes the same cuts, without a message.
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
