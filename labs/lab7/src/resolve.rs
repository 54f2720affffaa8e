//! Tasks 7.5 and 7.6: what a collision does.

use common::Vec2;
use common::hard::Disc;
use hard_discs::{Hit, Square};

/// A disc that has collided in this step and ends beyond a wall waits at the wall instead.
///
/// It goes back along its own path until it is inside: along each axis where it is beyond a
/// wall `bound`, it takes the time (x − bound) / vx to get back. The longest of these times t
/// brings it inside along both axes: (x, y) −= t (vx, vy). The velocity stays, so the disc hits the
/// wall in the next step, at λ = 0.
///
/// Going back along one axis only would move the disc off its path.
///
/// A disc cannot have left more than a step ago. A time that is negative, beyond 2, or infinite
/// (where the velocity is 0) says that rounding, not travel, has put the disc very slightly outside: that axis does
/// not count.
///
/// Book: chapter 7, *Waiting at the wall*.
pub fn stop_at_wall(disc: &mut Disc, square: Square) {
    todo!("task 7.5: wait at the wall")
}

/// Disc hits a wall at `time` (a λ) and travels on for the rest of the step.
///
/// Move it to where it hits, by λ (vx, vy). Change the sign of vx at an x wall, of vy at a
/// y wall, of both in a corner. Then move it by (1 − λ) of its new
/// velocity; if that ends beyond a wall, it waits there ([`stop_at_wall`]). Count one wall
/// collision, also for a corner.
///
/// Book: chapter 7, *What a collision does*.
pub fn bounce(disc: &mut Disc, time: f64, hit: Hit, square: Square) {
    todo!("task 7.6: off a wall")
}

/// Discs a and b touch at `time` (a λ), exchange momentum and travel on for the rest of the step.
///
/// Move both to where they touch. Let n be the vector from a to b there and w the velocity of b
/// less that of a. Discs of equal mass exchange the components of their velocities along n:
/// a gains ((w · n) / |n|²) n, b loses it. The components across n stay.
///
/// Divide by the |n|² that you have, not by (2 r)², which it would be without rounding and overlaps.
/// If |n|² is 0 the impulse has no direction, and both velocities stay.
///
/// Then move both by (1 − λ) of their new velocities; a disc that ends beyond a wall waits there
/// ([`stop_at_wall`]). Count one pair collision for each.
///
/// Book: chapter 7, *What a collision does*.
pub fn collide(a: &mut Disc, b: &mut Disc, time: f64, square: Square) {
    todo!("task 7.6b: off each other")
}

/// Moves a disc along its velocity for a part of a step.
#[inline]
pub fn travel(disc: &mut Disc, time: f64) {
    disc.x += time * disc.vx;
    disc.y += time * disc.vy;
}

/// Gives a disc an impulse, which changes its velocity.
#[inline]
pub fn impulse(disc: &mut Disc, change: Vec2) {
    disc.vx += change.x;
    disc.vy += change.y;
}
