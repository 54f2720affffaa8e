//! Task 1.1: the force between two particles.

use common::Vec2;
use common::soft::{CUTOFF, MASS, MIN_R, Observer};

/// Returns the acceleration that a neighbour causes, or `None` if the neighbour is beyond the
/// cutoff.
///
/// `d` is the vector from the particle to its neighbour. With r² = |d|²:
///
/// - If r² > cutoff², the result is `None`. At exactly the cutoff, the result is an acceleration of
///   zero.
/// - Below [`MIN_R`] the force stops growing: if r² is less than `MIN_R²`, use `MIN_R²` instead. Do
///   not change the vector `d`, so that two particles at the same position exert no force on each
///   other.
/// - The acceleration is `coef * d` with `coef = (1 - CUTOFF / r) / r² / MASS`. `coef` is negative, so
///   the acceleration points away from the neighbour.
///
/// Use exactly this order of operations, because the graders compare bits.
/// `(r - CUTOFF) / (r * r² * MASS)` is the same only on paper.
///
/// Book: chapter 1, *The force of a pair*.
#[inline]
pub fn pair_acceleration(d: Vec2) -> Option<Vec2> {
    todo!("task 1.1: the force of a pair")
}

/// Adds to `a` the acceleration that the neighbour at `d` causes.
///
/// Reports a pair within the cutoff to `observer`. An [`Observer`] collects statistics while forces
/// are computed; the observer of a run without statistics does nothing.
#[inline]
pub fn add_pair<O: Observer>(a: &mut Vec2, d: Vec2, observer: &mut O) {
    if let Some(pair) = pair_acceleration(d) {
        *a += pair;
        observer.seen(d.norm_squared());
    }
}
