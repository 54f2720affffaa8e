//! Tasks 7.5 and 7.6: what a collision does.

use common::Vec2;
use common::hard::Disc;

use crate::{Candidate, Hit, Square};

/// A disc that has collided in this step and ends beyond a wall waits at the wall instead.
///
/// It goes back along its own path until it is inside: along each axis where it is beyond a
/// wall `bound`, it takes the time (x − bound) / vx to get back. The longest of these times t
/// brings it inside along both axes: (x, y) −= t (vx, vy). The velocity stays, so the disc hits the
/// wall in the next step, at λ = 0.
///
/// Going back along one axis only would move the disc off its path.
///
/// A disc cannot have left more than a step ago. A time beyond 2 (or infinite, where the velocity
/// is 0) says that rounding, not travel, has put the disc a hair outside: that axis does not count.
///
/// Book: chapter 7, *Waiting at the wall*.
pub fn stop_at_wall(disc: &mut Disc, square: Square) {
    todo!("task 7.5: wait at the wall")
}

/// Disc hits a wall at `time` (a λ) and travels on for the rest of the step.
///
/// Move it to where it hits, by λ (vx, vy). Turn round each component that a wall was hit along:
/// vx for an x wall, vy for a y wall, both in a corner. Then move it by (1 − λ) of its new
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
/// If |n|² is 0 there is no direction to push in, and both velocities stay.
///
/// Then move both by (1 − λ) of their new velocities; a disc that ends beyond a wall waits there
/// ([`stop_at_wall`]). Count one pair collision for each.
///
/// Book: chapter 7, *What a collision does*.
pub fn collide(a: &mut Disc, b: &mut Disc, time: f64, square: Square) {
    todo!("task 7.6b: off each other")
}

/// What a collision that was taken makes of its disc or its two, as they were at the start of the step.
pub fn outcome(candidate: &Candidate, discs: &[Disc], square: Square) -> (Disc, Option<Disc>) {
    let mut first = discs[candidate.hit.first() as usize];
    let mut second = candidate.hit.second().map(|b| discs[b as usize]);
    match &mut second {
        Some(second) => collide(&mut first, second, candidate.time, square),
        None => bounce(&mut first, candidate.time, candidate.hit, square),
    }
    (first, second)
}

/// Puts the discs of a collision back in their places.
pub fn put_back(hit: Hit, (first, second): (Disc, Option<Disc>), discs: &mut [Disc]) {
    discs[hit.first() as usize] = first;
    if let Some((b, second)) = hit.second().zip(second) {
        discs[b as usize] = second;
    }
}

/// Carries out the collisions that were taken, on discs as they were at the start of the step.
pub fn resolve(taken: &[Candidate], discs: &mut [Disc], square: Square) {
    for candidate in taken {
        put_back(candidate.hit, outcome(candidate, discs, square), discs);
    }
}

/// Moves a disc along its velocity for a part of a step.
#[inline]
pub fn travel(disc: &mut Disc, time: f64) {
    disc.x += time * disc.vx;
    disc.y += time * disc.vy;
}

/// Changes a velocity.
#[inline]
pub fn push(disc: &mut Disc, change: Vec2) {
    disc.vx += change.x;
    disc.vy += change.y;
}
