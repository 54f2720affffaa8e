//! Task 13.5: strips of equal work.

use neighbour_list::LISTED;

/// The move of a particle, in nanoseconds on the machine of the book. Like lab 10's
/// [`LISTED`], it decides nothing but speed.
pub const MOVED: f64 = 2.0;

/// The cost of a step for a rank with `particles` particles and `pairs` listed pairs, in whole
/// nanoseconds, rounded up: [`MOVED`] for each particle and [`LISTED`] for each pair.
///
/// Book: chapter 13, *Balance*.
pub fn load(particles: usize, pairs: usize) -> u64 {
    // task 13.5: what a step costs
    (MOVED * particles as f64 + LISTED * pairs as f64).ceil() as u64
    // end 13.5
}

/// The cost of a step in each row of bins, as far as a rank can tell: its `load`, dealt out to its
/// rows in proportion to the particles in them, each share rounded down.
///
/// - `counts`: own particles in every row of the box; 0 in the rows of other ranks.
///
/// A rank without particles has nothing to deal out. Strips are cut by the sum over all ranks
/// ([`solution6::balanced`]). A clock would know the cost of a row better, but then
/// two runs would cut differently and give different bits.
///
/// Loads and counts are large: `load` times a count may not fit a `u64`.
///
/// Book: chapter 13, *Balance*.
pub fn weigh_rows(counts: &[u64], load: u64) -> Vec<u64> {
    // task 13.5b: what each row costs
    let all: u64 = counts.iter().sum();
    let share =
        |&count: &u64| (u128::from(load) * u128::from(count) / u128::from(all.max(1))) as u64;
    counts.iter().map(share).collect()
    // end 13.5b
}
