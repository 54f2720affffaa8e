//! The move of many particles at once.

/// Moves one coordinate of a chunk of particles, `v += a dt`, `x += v dt`, and says whether any
/// of them is now outside the walls, at 0 and at `size`: then the chunk is looked at again, one by
/// one.
///
/// - `x`, `v`, `a`: places, velocities and accelerations along one axis; there are at least as many velocities and
///   accelerations as places.
/// - `dt`: the time step. `size`: the side of the box.
///
/// Book: chapter 10, *Eight at a time, or not*.
#[inline(always)]
pub fn drift(x: &mut [f64], v: &mut [f64], a: &[f64], dt: f64, size: f64) -> bool {
    todo!("task 10.1: the move without branches")
}
