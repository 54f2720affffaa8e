//! Loops of tasks 10.1, 10.2 and 10.4 alone, without an engine: as functions whose machine code one can look at, and
//! as programs that one can time, in `lab10-alone`.
//!
//! Book: chapter 10, *Is it vector code?*.

use common::soft::Simulation;
use common::{Variant, bitwise};
use neighbour_list_alone::DRAWN;
use neighbour_list_core::kernels::{Pair, Positions, ROOM};

use crate::Tasks;
use crate::drift::drift;
use crate::filter::filter;

/// The programs of `lab10-alone`: a step of each is one pass of a loop over all particles, which stay where they are.
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

/// [`drift`], not inlined.
#[inline(never)]
pub fn drift_alone(x: &mut [f64], v: &mut [f64], a: &[f64], dt: f64, size: f64) -> bool {
    drift(x, v, a, dt, size)
}

/// [`filter`], not inlined.
#[inline(never)]
pub fn filter_alone(
    pairs: &[Pair],
    positions: Positions<'_>,
    squared: f64,
    near: &mut [Pair; ROOM],
) -> usize {
    filter(pairs, positions, squared, near)
}
