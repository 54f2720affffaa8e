//! Tasks 7.5 and 7.6: the effects of a collision.

use common::Vec2;
use common::hard::Disc;
use hard_discs::{Hit, Square};

/// Moves a disc that has ended beyond a wall back to the wall, where it waits.
///
/// The disc has collided in this step. It goes back along its own path until it is inside the
/// square:
///
/// - Along each axis where the disc is beyond a wall at `bound`, going back takes the time (x −
///   bound) / vx.
/// - The longer of these times, t, brings the disc inside along both axes: (x, y) −= t (vx, vy).
/// - The velocity stays the same, so the disc hits the wall in the next step, at λ = 0.
///
/// Going back along one axis only would move the disc off its path.
///
/// A disc cannot have left the square more than a step ago. If a time is negative, greater than 2,
/// or infinite (because the velocity is 0), the disc is very slightly outside because of rounding,
/// not because it travelled there. Ignore that axis.
///
/// Book: chapter 7, *Waiting at the wall*.
pub fn stop_at_wall(disc: &mut Disc, square: Square) {
    todo!("task 7.5: wait at the wall")
}

/// Lets a disc hit a wall at time λ = `time`, and travel on for the rest of the step.
///
/// 1. Move the disc to the point where it hits the wall, by λ (vx, vy).
/// 2. Change the sign of vx at an x wall, of vy at a y wall, and of both in a corner.
/// 3. Move the disc by (1 − λ) of its new velocity. If it ends beyond a wall, it waits there
///    ([`stop_at_wall`]).
/// 4. Count one wall collision, even for a corner.
///
/// Book: chapter 7, *What a collision does*.
pub fn bounce(disc: &mut Disc, time: f64, hit: Hit, square: Square) {
    todo!("task 7.6: off a wall")
}

/// Lets discs a and b collide at time λ = `time`, and travel on for the rest of the step.
///
/// 1. Move both discs to the point where they touch. Let n be the vector from a to b there, and w the
///    velocity of b minus the velocity of a.
/// 2. Discs of equal mass exchange the components of their velocities along n. The velocity of a gains
///    ((w · n) / |n|²) n, and the velocity of b loses it. The components across n stay the same. If
///    |n|² is 0, the impulse has no direction, and both velocities stay.
/// 3. Move both discs by (1 − λ) of their new velocities. A disc that ends beyond a wall waits there
///    ([`stop_at_wall`]).
/// 4. Count one pair collision for each disc.
///
/// Divide by the actual |n|². It differs from (2 r)² because of rounding and overlaps.
///
/// Book: chapter 7, *What a collision does*.
pub fn collide(a: &mut Disc, b: &mut Disc, time: f64, square: Square) {
    todo!("task 7.6b: off each other")
}

/// Moves a disc along its velocity for `time`, measured in steps.
#[inline]
pub fn travel(disc: &mut Disc, time: f64) {
    disc.x += time * disc.vx;
    disc.y += time * disc.vy;
}

/// Gives a disc an impulse: adds `change` to its velocity.
#[inline]
pub fn impulse(disc: &mut Disc, change: Vec2) {
    disc.vx += change.x;
    disc.vy += change.y;
}
