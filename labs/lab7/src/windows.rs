//! Task 7.14: windows of time.

use hard_discs::{Square, Survey, expected_work};

/// The cost of making and sorting an entry, in pair tests (eight tests run at a time).
const ENTRY: f64 = 60.0;

/// The cost of computing the time at which a pair touches, in pair tests.
const ASK: f64 = 10.0;

/// The greatest useful number of windows.
const MOST_WINDOWS: usize = 4096;

/// Returns the number of windows for which a step takes the least work.
///
/// The number is a power of two, and at most [`MOST_WINDOWS`]. With more windows, boxes are
/// shorter. The number of pairs to test falls as 1 / windows, because two paths that cross in space
/// rarely cross at the same time. But all entries must be made again for every window.
///
/// - [`expected_work`] returns the expected numbers of entries, of pairs to test, and of pairs
///   whose touching time is computed (`asked`).
/// - A pair test costs 1. Computing the touching time costs [`ASK`] more. An entry costs [`ENTRY`].
/// - Discs may crowd together. `crowding` is the number of pairs in the last step, divided by the
///   expected number. Multiply both numbers of pairs by it.
///
/// Book: chapter 7, *Time windows*.
pub fn choose_windows(survey: &Survey, square: Square, crowding: f64) -> usize {
    todo!("task 7.14: how many windows")
}
