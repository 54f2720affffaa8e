//! Task 6.7: a rank's share of a scene that no rank holds.

use common::soft::{CounterParticles, Particle};
use solution2::Grid;

use crate::{Cuts, balanced};

/// Calls a function with each particle of a scene, one after the other, as often as it is asked to:
/// `replay(&mut |particle| n += 1)` counts them.
pub type Replay<'a> = &'a dyn Fn(&mut dyn FnMut(Particle));

/// The cuts of a scene and the particles of `rank`'s block, from a scene that comes one particle
/// after the other.
///
/// No rank may keep the whole scene, and the cuts are not known before the particles of all rows
/// are counted. So replay the scene twice: first count the particles in each row of `grid`, and cut
/// the rows ([`balanced`]); then keep the particles of the own block. Every rank finds the same
/// cuts, without a message.
///
/// Book: chapter 6, *A scene that no rank holds*.
pub fn keep_share(grid: &Grid, ranks: usize, rank: usize, replay: Replay) -> (Cuts, Vec<Particle>) {
    todo!("task 6.7: each rank keeps its share")
}

/// The same from a scene that knows where each of its particles stands: no particle is made that
/// is not kept. Time and memory grow with the share and with the number of rows.
pub fn make_share(
    grid: &Grid,
    ranks: usize,
    rank: usize,
    scene: &CounterParticles,
) -> (Cuts, Vec<Particle>) {
    let row_of_bins = |row: usize| grid.row(scene.y(row));
    let mut counts = vec![0; grid.rows()];
    for row in 0..scene.rows() {
        counts[row_of_bins(row)] += scene.count_in(row..row + 1) as u64;
    }
    let cuts = balanced(&counts, ranks);
    let block = cuts.block(rank);
    // Both kinds of rows count from the bottom, so those of the block follow one another.
    let below = |end: usize| (0..scene.rows()).take_while(|&row| row_of_bins(row) < end).count();
    let rows = below(block.start)..below(block.end);
    let mut share = Vec::with_capacity(scene.count_in(rows.clone()));
    share.extend(scene.in_rows(rows));
    (cuts, share)
}
