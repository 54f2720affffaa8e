//! Task 1.1: the force between two particles.

use common::Vec2;
use common::soft::{CUTOFF, MASS, MIN_R, Observer};

/// The acceleration that a neighbour causes, or `None` if it is too far away to be felt.
///
/// `d` is the vector from the particle to its neighbour. With r² = |d|²:
///
/// - r² > cutoff²: none. At exactly the cutoff there is one (of zero).
/// - Below [`MIN_R`] the force grows no more: r² counts as at least `MIN_R²`. The vector `d`
///   itself stays as it is, so two particles at one position exert no force on each other.
/// - The acceleration is `coef * d` with `coef = (1 - CUTOFF / r) / r² / MASS`: negative, away
///   from the neighbour.
///
/// Write the formula just so. The graders compare bits, and floating-point numbers do not forgive
/// `(r - CUTOFF) / (r * r² * MASS)`, which is the same only on paper.
///
/// Book: chapter 1, *The force of a pair*.
#[inline]
pub fn pair_acceleration(d: Vec2) -> Option<Vec2> {
    todo!("task 1.1: the force of a pair")
}

/// Adds to acceleration `a` what the neighbour at `d` causes, and tells the observer.
#[inline]
pub fn add_pair<O: Observer>(a: &mut Vec2, d: Vec2, observer: &mut O) {
    if let Some(pair) = pair_acceleration(d) {
        *a += pair;
        observer.seen(d.norm_squared());
    }
}
