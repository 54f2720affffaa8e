//! How far a neighbour list should look, and when it has expired.

use std::f64::consts::PI;

use common::soft::CUTOFF;
use neighbour_list_core::{LISTED, REBUILD, TESTED};

/// Whether a neighbour list has expired: whether it may lack a pair that is within the cutoff.
///
/// - `displacement`: since the list was built no particle has gone further than this from where it was,
///   in units of length; infinite if there is no list.
/// - `skin`: the list holds every pair that was within cutoff + `skin` when it was built.
///
/// Two particles can move towards each other, both as far as that.
///
/// Book: chapter 10, *A list that lasts*.
pub fn expired(displacement: f64, skin: f64) -> bool {
    todo!("task 10.3: when the list has expired")
}

/// The skin, in units of length, that makes a step cheapest: of 0.05, 0.1, … 3 cutoffs; of equally cheap
/// ones the narrowest.
///
/// - `density`: particles per area where particles are.
/// - `displacement`: how far a particle goes in a step, the fastest that the list is made for.
///
/// A wide skin makes long lists, a narrow one many rebuilds. Derive from the book's drawing what a step costs a
/// particle, in nanoseconds: each pair is listed once, and costs [`LISTED`] in each step. When its list has
/// expired, a particle costs [`REBUILD`], and [`TESTED`] for each pair that is tested, once, in square cells as
/// wide as the list looks. A list lasts skin / (2 · displacement) steps, not rounded to whole steps, and never
/// less than one.
///
/// Book: chapter 10, *How thick a skin*.
pub fn best_skin(density: f64, displacement: f64) -> f64 {
    todo!("task 10.3b: the cheapest skin")
}
