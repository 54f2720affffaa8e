//! Loops of tasks 10.1 and 10.4 as functions of their own, whose machine code one can look at. No engine
//! calls them.
//!
//! Book: chapter 10, *Is it vector code?*.

use neighbour_list_core::Positions;
use neighbour_list_core::kernels::{Pair, ROOM};

use crate::drift::drift;
use crate::filter::filter;

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
