//! Task 8.3: the search of a worker.

use common::hard::Disc;
use hard_disc_ranks::Job;
use solution5::Cut;
use solution7::{Candidate, look_along};

/// Tests the pairs of a job, and returns their number. Appends the pairs that collide to `list`.
///
/// `discs` has an entry for every disc of the scene. Only the entries of this worker's blocks need
/// to be filled. [`Cut::block`] returns the discs of block k: `blocks.block(k)`.
///
/// - On the diagonal, where `row` = `column`, test each pair of the block once, the lower number
///   first.
/// - Elsewhere, `row` < `column`. Test each disc of the [`Part`](hard_disc_ranks::Part) of block
///   `row` (call [`Part::of`](hard_disc_ranks::Part::of)) with each disc of block `column`. Blocks
///   are in the order of disc numbers, so the disc of block `row` has the lower number.
///
/// [`look_along`] of lab 7 tests the pairs of one disc with a range of discs of higher numbers.
///
/// Book: chapter 8, *Dealing out the pairs*.
pub fn search_job(
    discs: &[Disc],
    blocks: &Cut,
    job: &Job,
    radius: f64,
    list: &mut Vec<Candidate>,
) -> u64 {
    // task 8.3: the pairs of a job
    let column = blocks.block(job.column);
    let mut tests = 0;
    for a in job.part.of(blocks.block(job.row)) {
        let partners = column.start.max(a + 1)..column.end;
        tests += partners.len() as u64;
        look_along(discs, a, partners, radius, list);
    }
    tests
    // end 8.3
}
