//! The length of a window.

use std::f64::consts::SQRT_2;

use common::soft::{CUTOFF, DT};

/// The longest window, in steps.
pub const LONGEST: u32 = 48;
/// The number of other particles that a particle may sweep over in a window.
const SWEPT: f64 = 0.14;

/// Returns the number of steps of a window, at least 1 and at most [`LONGEST`].
///
/// - `density`: particles per unit area.
/// - `speed`: the mean speed of the particles.
///
/// With longer windows, the engine sorts and searches less often, but more particles meet in a window. In
/// each step, of length [`DT`], a particle sweeps over an area relative to the other particles. The area is
/// about 2 cutoffs times √2 times the particle's displacement. The result is the greatest number of steps
/// in which a particle sweeps over at most 0.14 (`SWEPT`) other particles.
///
/// In a box without motion, you would divide by zero. The result is then [`LONGEST`].
///
/// Book: chapter 11, *How long a window*.
pub fn window_length(density: f64, speed: f64) -> u32 {
    todo!("task 11.6: the length of a window")
}
