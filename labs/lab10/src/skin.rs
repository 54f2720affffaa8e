//! The skin of a neighbour list, and the test whether the list has expired.

use std::f64::consts::PI;

use common::soft::CUTOFF;
use neighbour_list_core::{LISTED, REBUILD, TESTED};

/// Whether a neighbour list has expired: it may then lack a pair within the cutoff.
///
/// - `displacement`: the greatest distance that a particle may have moved since the list was built, in
///   units of length; infinite if there is no list.
/// - `skin`: the list contains every pair that was within cutoff + `skin` when it was built.
///
/// Two particles can move towards each other, both by this displacement.
///
/// Book: chapter 10, *A list that lasts*.
pub fn expired(displacement: f64, skin: f64) -> bool {
    todo!("task 10.3: when the list has expired")
}

/// Returns the skin, in units of length, that makes a step cheapest.
///
/// The candidates are 0.05, 0.1, … 3 cutoffs. If several skins cost the same, the result is the
/// narrowest.
///
/// - `density`: particles per unit area in the part of the box that contains particles.
/// - `displacement`: the greatest distance that a particle moves in a step.
///
/// A wide skin makes lists long, and a narrow skin makes rebuilds frequent. From the book's
/// drawing, derive the cost in nanoseconds of a step for one particle:
///
/// - Each pair is listed once, and costs [`LISTED`] in each step.
/// - When the list has expired, a particle costs [`REBUILD`], plus [`TESTED`] for each pair test. Each pair
///   is tested once. The cells are squares of side cutoff + skin.
/// - A list lasts skin / (2 · displacement) steps, at least one. Do not round this to whole steps.
///
/// Book: chapter 10, *How thick a skin*.
pub fn best_skin(density: f64, displacement: f64) -> f64 {
    todo!("task 10.3b: the cheapest skin")
}
