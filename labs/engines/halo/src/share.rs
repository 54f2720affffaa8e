//! A rank's share of a scene that no rank holds.

use common::soft::{CounterParticles, Particle};
use solution2::Grid;

use crate::{Blocks, Cuts};

/// The balanced cuts of a scene and the particles of `rank`'s block, from a scene that knows where each of its particles
/// stands: no particle is made that is not kept. Time and memory grow with the share and with the number of rows.
pub fn make_share<T: Blocks>(
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
    let cuts = T::balanced(&counts, ranks);
    let block = cuts.block(rank);
    // Both kinds of rows count from the bottom, so those of the block follow one another.
    let below = |end: usize| (0..scene.rows()).take_while(|&row| row_of_bins(row) < end).count();
    let rows = below(block.start)..below(block.end);
    let mut share = Vec::with_capacity(scene.count_in(rows.clone()));
    share.extend(scene.in_rows(rows));
    (cuts, share)
}
