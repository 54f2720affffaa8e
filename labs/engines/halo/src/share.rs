//! Makes a rank's share of a scene that is too large for one rank.

use common::soft::{CounterParticles, Particle};
use solution2::Grid;

use crate::{Blocks, Cuts};

/// Returns the balanced blocks of a scene, and the particles of `rank`'s block.
///
/// The scene can compute the position of each particle separately, so this function makes only the
/// particles of the share. Time and memory grow with the share and with the number of rows.
pub fn make_share<T: Blocks>(
    grid: &Grid,
    ranks: usize,
    rank: usize,
    scene: &CounterParticles,
) -> (Cuts, Vec<Particle>) {
    let mut counts = vec![0; grid.rows()];
    for row in 0..scene.rows() {
        counts[grid.row(scene.y(row))] += scene.count_in(row..row + 1) as u64;
    }
    let cuts = T::balanced(&counts, ranks);
    let block = cuts.block(rank);
    let rows = rows_below(grid, scene, block.start)..rows_below(grid, scene, block.end);
    let mut share = Vec::with_capacity(scene.count_in(rows.clone()));
    share.extend(scene.in_rows(rows));
    (cuts, share)
}

/// Returns the number of rows of the scene's lattice that are below row `end` of bins. Both kinds
/// of rows are counted from the bottom.
fn rows_below(grid: &Grid, scene: &CounterParticles, end: usize) -> usize {
    (0..scene.rows()).take_while(|&row| grid.row(scene.y(row)) < end).count()
}
