//! How long a window should be.

use std::f64::consts::SQRT_2;

use common::soft::{CUTOFF, DT};

/// The longest window, in steps.
pub const LONGEST: u32 = 48;
/// Particles that one particle may sweep over in a window.
const SWEPT: f64 = 0.14;

/// How many steps a window should have, where there are `density` particles per area and their mean
/// speed is `speed`.
///
/// A longer window spares sorting and searching, but more particles meet in it. At each step, of
/// length [`DT`], a particle sweeps, relative to the other particles, an area of about 2 cutoffs times
/// √2 times its displacement. Take the most steps, at least 1 and at most [`LONGEST`], in which it
/// sweeps over no more than 0.14 (`SWEPT`) particles.
///
/// A box without motion gives 0/0 or x/0: then take [`LONGEST`].
///
/// Book: chapter 11, *How long a window*.
pub fn window_length(density: f64, speed: f64) -> u32 {
    todo!("task 11.6: how long a window")
}
