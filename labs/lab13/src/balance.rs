//! Task 13.5: strips of equal work.

use neighbour_list::LISTED;

/// The cost of moving a particle, in nanoseconds on the book's machine.
///
/// It affects where strips are cut, and therefore the speed. The results differ only by rounding.
pub const MOVED: f64 = 2.0;

/// Returns the cost of a step for a rank with `particles` particles and `pairs` listed pairs.
///
/// The cost is [`MOVED`] for each particle and [`LISTED`] for each pair, in nanoseconds, rounded
/// up.
///
/// Book: chapter 13, *Balance*.
pub fn load(particles: usize, pairs: usize) -> u64 {
    todo!("task 13.5: what a step costs")
}

/// Estimates the cost of a step in each row of bins, in nanoseconds.
///
/// - `counts`: the number of the rank's particles in each row of the box, 0 in the rows of other
///   ranks.
/// - `load`: the cost of a step for the rank.
///
/// The rank's load is divided among its rows in proportion to the particles in them. Each share is
/// rounded down. If the rank has no particles, every share is 0.
///
/// The strips are cut according to these costs, summed over all ranks ([`solution6::balanced`]). A
/// clock would measure the cost of a row better, but two runs would then make different cuts and
/// yield different bits.
///
/// Loads and counts are large: the product of `load` and a count may exceed a `u64`.
///
/// Book: chapter 13, *Balance*.
pub fn weigh_rows(counts: &[u64], load: u64) -> Vec<u64> {
    todo!("task 13.5b: what each row costs")
}
