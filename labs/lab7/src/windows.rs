//! Task 7.14: windows of time.

use hard_discs::{Square, Survey, expected_work};

/// What an entry costs (making and sorting it), in units of what a look at a pair costs, eight at a time.
const ENTRY: f64 = 60.0;

/// What it costs to ask a pair when it touches, in the same units.
const ASK: f64 = 10.0;

/// More windows than this are never worth their while.
const MOST_WINDOWS: usize = 4096;

/// Into how many windows to cut a step: the power of two, [`MOST_WINDOWS`] at most, that makes the least work.
///
/// More windows make shorter boxes, so pairs to look at fall as 1 / windows: two paths that cross
/// in space rarely cross at the same time. But every window makes all entries again. [`expected_work`]
/// tells how many entries and pairs there will be, and how many of the pairs are asked when they touch. A look at
/// a pair costs 1, asking it [`ASK`] more, an entry [`ENTRY`]. `crowding` says how many times as many pairs
/// there were in the last step as expected, since discs may crowd together: what is looked at and what is asked are both
/// multiplied by it.
///
/// Book: chapter 7, *Time windows*.
pub fn choose_windows(survey: &Survey, square: Square, crowding: f64) -> usize {
    todo!("task 7.14: how many windows")
}
