//! The loops of tasks 10.1, 10.2 and 10.4 alone, without an engine.
//!
//! You can inspect the machine code of these functions, and time them as programs (`lab10-alone`).
//!
//! Book: chapter 10, *Is it vector code?*.

use common::soft::Simulation;
use common::{Variant, bitwise};
use neighbour_list_alone::DRAWN;
use neighbour_list_core::kernels::{Pair, Positions, ROOM};

use crate::Tasks;
use crate::drift::drift;
use crate::filter::filter;

/// The programs of `lab10-alone`.
///
/// A step of each program is one pass of a loop over all particles. The particles do not move.
pub static ALONE: &[Variant<dyn Simulation>] = &[
    bitwise(
        "drift",
        "task 10.1 alone: particles at rest, moved",
        &[],
        neighbour_list_alone::drift::<Tasks>,
    ),
    bitwise("plain", "the same move without walls", &[], neighbour_list_alone::plain),
    bitwise(
        "collect",
        "task 10.2 alone: the neighbours of each particle among a few",
        &[DRAWN],
        neighbour_list_alone::collect::<Tasks>,
    ),
    bitwise(
        "filter",
        "task 10.4 alone: which pairs are near, of one for each particle",
        &[DRAWN],
        neighbour_list_alone::filter::<Tasks>,
    ),
];

/// Calls [`drift`]. The function is not inlined, so that its machine code can be found.
#[inline(never)]
pub fn drift_alone(x: &mut [f64], v: &mut [f64], a: &[f64], dt: f64, size: f64) -> bool {
    drift(x, v, a, dt, size)
}

/// Calls [`filter`]. The function is not inlined, so that its machine code can be found.
#[inline(never)]
pub fn filter_alone(
    pairs: &[Pair],
    positions: Positions<'_>,
    squared: f64,
    near: &mut [Pair; ROOM],
) -> usize {
    filter(pairs, positions, squared, near)
}
