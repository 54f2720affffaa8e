//! Task 6.7: a rank's part of a scene that nobody holds.

use common::soft::{CounterParticles, Particle};
use solution2::Grid;

use crate::{Cuts, balanced};

/// A generator that shows a scene, one particle after the other, as often as it is asked to.
pub(super) type Show<'a> = &'a dyn Fn(&mut dyn FnMut(Particle));

/// The cuts of a scene and the particles of `rank`'s block, from a scene that can only be shown
/// one particle after the other.
///
/// Nobody may keep the whole scene, and nobody knows the cuts before all rows are counted. So let
/// it be shown twice: count the particles of each row of `grid`, make the cuts ([`balanced`]), then
/// keep those of the own block. Every rank finds the same cuts, without a message.
pub(super) fn keep_share(
    grid: &Grid,
    ranks: usize,
    rank: usize,
    show: Show,
) -> (Cuts, Vec<Particle>) {
    // task 6.7: each rank keeps its share
    let mut counts = vec![0; grid.rows()];
    show(&mut |particle| counts[grid.row(particle.y)] += 1);
    let cuts = balanced(&counts, ranks);
    let block = cuts.block(rank);
    let mut share = Vec::new();
    show(&mut |particle| {
        if block.contains(&grid.row(particle.y)) {
            share.push(particle);
        }
    });
    (cuts, share)
    // end 6.7
}

/// The same from a scene that knows where each of its particles stands: no particle is made that
/// is not kept. Time and memory grow with the share and with the number of rows.
pub(super) fn make_share(
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
