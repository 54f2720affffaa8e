//! Tasks 8.1 and 8.2: the pairs of each worker.

use hard_disc_ranks::{Deal, Job, Part};

/// Deals the pairs of blocks to `workers` workers, whose blocks are chosen by [`offsets`].
pub fn deal_out(workers: usize) -> Deal {
    Deal { workers, offsets: offsets(workers) }
}

/// Returns the jobs of `worker`, one for each distance d from 0 to W / 2, in this order.
///
/// W is the number of workers. The pairs of blocks at distance d are on a diagonal of the matrix of
/// blocks. (Where the diagonal leaves the matrix, it continues on the other side.) The diagonal has
/// W pairs, and each worker does one of them:
///
/// 1. Find two offsets p and q with q ≡ p + d modulo W. Take the first such p.
/// 2. The job of worker k is the pair of its blocks k + p and k + q, modulo W. The lesser block is
///    the row.
///
/// All workers use the same pattern, shifted by their numbers k, so no two workers have the same
/// job.
///
/// If W is even, one diagonal is shorter. Its pairs, at distance W / 2, are opposite each other in
/// a ring of all blocks. There are only W / 2 such pairs, and the rule above gives each of them to
/// two workers. The worker with k + p < k + q (both modulo W) does the first half of the row's
/// discs. The other worker does the second half. All workers then have the same number of pairs to
/// test.
///
/// Book: chapter 8, *Dealing out the pairs*.
pub fn jobs(deal: &Deal, worker: usize) -> Vec<Job> {
    let Deal { workers, offsets } = deal;
    todo!("task 8.2: a job on each diagonal")
}

/// Returns the distance between two blocks on the ring, measured the shorter way round.
pub fn distance(i: usize, j: usize, workers: usize) -> usize {
    let d = i.abs_diff(j) % workers;
    d.min(workers - d)
}

/// Returns the offsets of a worker's blocks. Every distance occurs between two of them.
///
/// W is the number of workers, `workers`. For every distance d from 1 to W / 2, the result contains
/// two offsets that are d apart. The adjacent blocks 0, 1, … W / 2 would be enough: for every d,
/// one of them is at distance d from block 0. But m blocks have m · (m − 1) / 2 pairs, so about √W
/// blocks may be enough. For W = 7, blocks 0, 1 and 3 are enough: 0 and 1 are 1 apart, 1 and 3 are
/// 2 apart, and 0 and 3 are 3 apart. Fewer blocks mean fewer bytes.
///
/// The rule: begin with 0. While a distance is missing, count for each of the offsets 1 … W − 1 how
/// many of the missing distances occur between it and the offsets chosen so far. Add the offset
/// with the highest count. If several offsets have this count, add the least of them. [`distance`]
/// returns the distance between two offsets.
///
/// (Finding the fewest blocks is a hard problem, known as difference bases. A few more blocks do no
/// harm here.)
///
/// Book: chapter 8, *Few blocks*.
pub fn offsets(workers: usize) -> Vec<usize> {
    todo!("task 8.1: few blocks that are every distance apart")
}
