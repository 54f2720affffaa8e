//! The functions of tasks 10.1 to 10.4, as the library's engine takes them.

use std::ops::Range;

use neighbour_list_core::Primitives;
use neighbour_list_core::kernels::{Pair, Positions, ROOM, Signs};

/// [`drift`](crate::drift), [`collect`](crate::collect), [`filter`](crate::filter),
/// [`expired`](crate::expired) and [`best_skin`](crate::best_skin) of this lab.
#[derive(Clone, Copy, Debug, Default)]
pub struct Tasks;

impl Primitives for Tasks {
    #[inline(always)]
    fn drift(x: &mut [f64], v: &mut [f64], a: &[f64], dt: f64, size: f64) -> bool {
        crate::drift(x, v, a, dt, size)
    }

    #[inline(always)]
    fn collect(
        list: &mut [Pair],
        len: usize,
        positions: Positions<'_>,
        i: usize,
        range: Range<usize>,
        reach: f64,
        signs: impl Signs,
    ) -> usize {
        crate::collect(list, len, positions, i, range, reach, signs)
    }

    #[inline(always)]
    fn filter(
        pairs: &[Pair],
        positions: Positions<'_>,
        squared: f64,
        near: &mut [Pair; ROOM],
    ) -> usize {
        crate::filter(pairs, positions, squared, near)
    }

    fn expired(displacement: f64, skin: f64) -> bool {
        crate::expired(displacement, skin)
    }

    fn best_skin(density: f64, displacement: f64) -> f64 {
        crate::best_skin(density, displacement)
    }
}
