//! Task 8.3: a worker's search.

use common::hard::Disc;
use hard_disc_ranks::Job;
use solution5::Cut;
use solution7::{Candidate, look_along};

/// Looks at the pairs of a job: appends those that collide in this step to `list`, and returns how
/// many it has looked at.
///
/// `discs` has an entry for every disc of the scene; only the blocks of this worker need to be
/// filled. [`Cut::block`] says which discs block k has: `blocks.block(k)`.
///
/// - On the diagonal, `row` = `column`: each pair of the block once, the lower number first.
/// - Elsewhere: each disc of the [`Part`](hard_disc_ranks::Part) of block `row` ([`Part::of`](hard_disc_ranks::Part::of))
///   with each disc of block `column`. Blocks are in the order of numbers, so the disc of the row
///   is the lower one.
///
/// [`look_along`] of lab 7 looks at the pairs of one disc with a range of discs of higher numbers.
///
/// Book: chapter 8, *Dealing out the pairs*.
pub fn search_job(
    discs: &[Disc],
    blocks: &Cut,
    job: &Job,
    radius: f64,
    list: &mut Vec<Candidate>,
) -> u64 {
    todo!("task 8.3: the pairs of a job")
}
