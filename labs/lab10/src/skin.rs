//! How far a neighbour list should look, and when it is worn out.

use std::f64::consts::PI;

use common::soft::CUTOFF;

/// Whether a neighbour list must be rebuilt before the next forces.
///
/// It holds every pair that was within cutoff + `skin` when it was built. Since then no particle
/// has moved further than the square root of `moved_squared` from where it stood. The list may be
/// used as long as no pair that it lacks can be within the cutoff. Two particles can move towards
/// each other, both as far as that.
///
/// Book: chapter 10, *A list that lasts*.
pub fn worn_out(moved_squared: f64, skin: f64) -> bool {
    todo!("task 10.3: when the list is worn out")
}

/// The skin, in units of length, that makes a step cheapest.
///
/// - `density`: particles per area where particles are.
/// - `speed`: how far a particle goes in a step, the fastest that the list is made for.
///
/// A wide skin makes long lists, a narrow one many rebuilds. With reach R = cutoff + skin a
/// particle has π R² `density` neighbours. Each pair is listed once, so the particle's share is
/// half of them; each costs [`LISTED`] at every step. A rebuild costs [`REBUILD`] and [`TESTED`] for
/// half of the 9 R² `density` particles in the cells around, and it is due every
/// skin / (2 `speed`) steps, but never more often than each step. Try skins of 0.05, 0.1, …
/// 3 cutoffs; of equal ones take the narrowest.
///
/// Book: chapter 10, *How thick a skin*.
pub fn best_skin(density: f64, speed: f64) -> f64 {
    todo!("task 10.4: the cheapest skin")
}

/// What it costs to sort a particle and to begin looking for its pairs, in nanoseconds on the machine
/// of the book. Costs decide nothing but speed, and they are constants, so that a run repeats.
pub const REBUILD: f64 = 16.0;
/// What it costs to test a pair for the list.
pub const TESTED: f64 = 0.45;
/// What it costs to look at an entry of the list in a step.
pub const LISTED: f64 = 0.65;
