//! Tasks 8.1 and 8.2: which worker looks at which pairs.

use hard_disc_ranks::{Deal, Job, Part};

/// A deal to a number of workers, by [`offsets`].
pub fn deal_out(workers: usize) -> Deal {
    Deal { workers, offsets: offsets(workers) }
}

/// The jobs of `worker`, one for each distance d = 0 … W / 2, in this order.
///
/// The pairs of blocks at a distance d lie on a diagonal of the matrix of blocks (from where it
/// leaves the matrix it goes on from the other side). The diagonal has W of them, and each
/// worker does one: among the offsets there are two, p and q, with q ≡ p + d modulo W. Take the
/// first such p. The worker's blocks k + p and k + q, modulo W, are its job of this distance;
/// the lesser is the row. Since all workers are the same pattern turned, no two have the same
/// job.
///
/// One diagonal is shorter. If W is even, the blocks at distance W / 2 lie opposite each other on
/// the ring: there are W / 2 such pairs only, and the rule above gives each of them to two
/// workers. Let the one with k + p < k + q (modulo W) do the first half of the row's discs, the
/// other the second half. Then all workers have the same number of pairs to look at.
///
/// Book: chapter 8, *Dealing out the pairs*.
pub fn jobs(deal: &Deal, worker: usize) -> Vec<Job> {
    let Deal { workers, offsets } = deal;
    todo!("task 8.2: a job on each diagonal")
}

/// The distance of two blocks on the ring, the shorter way round.
pub fn distance(i: usize, j: usize, workers: usize) -> usize {
    let d = i.abs_diff(j) % workers;
    d.min(workers - d)
}

/// Which blocks a worker should have, so that for every distance 0 … W / 2 two of them are so far
/// apart; as few as a simple rule finds.
///
/// W / 2 + 1 neighbours, 0, 1, … W / 2, would do: 0 is at every distance from one of them. But q
/// blocks have q (q − 1) / 2 pairs, so some √W blocks may do. For W = 7 they are 0, 1, 3:
/// 0 and 1 are 1 apart, 1 and 3 are 2, 0 and 3 are 3. Fewer blocks are fewer bytes.
///
/// The rule: begin with 0. Until no distance is missing, add the offset, among 1 … W − 1, that
/// makes the most missing distances with the offsets that are there; of several that make as many,
/// the least. [`distance`] measures.
///
/// (To find the fewest is a hard problem, that of difference bases; a few more do no harm here.)
///
/// Book: chapter 8, *Few blocks*.
pub fn offsets(workers: usize) -> Vec<usize> {
    todo!("task 8.1: few blocks that are every distance apart")
}
