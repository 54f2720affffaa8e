//! Free flight: where a particle goes in a window if no other pushes it, how close two come, and how
//! far they may be off.

use common::soft::{CUTOFF, Particle};
use neighbour_list::kernels::larger;

/// The reference path of a particle during a window.
///
/// Far from walls it is the free flight: a straight line. A particle that could reach a wall has
/// no straight line; for it we only say that it stays within `spread` of where it stands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Path {
    /// Place at the start of the window.
    pub x: f64,
    /// Place at the start of the window.
    pub y: f64,
    /// Velocity of the reference.
    pub wx: f64,
    /// Velocity of the reference.
    pub wy: f64,
    /// How far free flight may be from the reference.
    pub spread: f64,
}

/// What all paths of a window share.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Span {
    /// Steps in the window.
    pub steps: u32,
    /// Length of a step.
    pub dt: f64,
    /// Side of the box.
    pub size: f64,
}

/// Advances one coordinate `x` of particles in free flight by `steps` steps of length `dt`; `v` are as
/// many velocities.
///
/// The result has the bits of step by step: each step adds `v * dt`, rounded once, to the place, and
/// that sum is rounded. But each particle is fetched from memory only once. No wall is near.
///
/// Book: chapter 11, *Free flight*.
#[inline(always)]
pub fn fly(x: &mut [f64], v: &[f64], steps: u32, dt: f64) {
    todo!("task 11.1: free flight")
}

/// The square of the least distance between two points within time `span`: they are (`dx`, `dy`)
/// apart at its beginning, and the second moves with velocity (`wx`, `wy`) as seen by the first.
///
/// - The distance vector at time t is d + t w. Its length is least at t = −(d·w) / (w·w).
/// - That may be before the beginning or after the end: t is clamped to 0 ..= `span`.
/// - Two points that move alike have w = 0 and t = 0/0 = NaN; their distance is |d| at any time.
///   `larger(t, 0.0)` is 0 if t is NaN: there needs to be no branch.
///
/// Book: chapter 11, *Which particles could meet*.
#[inline(always)]
pub fn closest_squared(dx: f64, dy: f64, wx: f64, wy: f64, span: f64) -> f64 {
    todo!("task 11.2: the closest approach of two paths")
}

/// Whether a particle with this `deviation` from its free flight, in units of length, may have come
/// within the cutoff of a particle that the search did not list for it.
///
/// The search listed all pairs whose free flights come within cutoff + `margin`. The other particle of
/// an unlisted pair may be off its path, too, by as much at most: this is asked of the one that is off
/// by more.
///
/// Book: chapter 11, *A margin that is checked*.
#[inline(always)]
pub fn too_far_off(deviation: f64, margin: f64) -> bool {
    todo!("task 11.4: whether the margin held")
}

impl Span {
    /// Time from the first forces of the window to the last.
    pub fn forces(&self) -> f64 {
        f64::from(self.steps - 1) * self.dt
    }

    /// Time from the start of the window to its end.
    pub fn whole(&self) -> f64 {
        f64::from(self.steps) * self.dt
    }

    /// More than the sum of roundings of a place in the window.
    pub fn rounding(&self) -> f64 {
        1e-9 * CUTOFF + 2.0 * f64::from(self.steps + 4) * f64::EPSILON * self.size
    }

    /// Whether the free flight from (`x`, `y`) with velocity (`vx`, `vy`) may touch a wall, at 0 or at
    /// `size`, before the window ends: then the particle is computed step by step.
    ///
    /// What counts is where it would be at the end of the window, not where it is now; a particle
    /// that ends within [`Span::rounding`] of a wall counts too, and so does a place that is no number.
    ///
    /// Book: chapter 11, *Walls out of reach*.
    #[inline(always)]
    pub fn meets_wall(&self, x: f64, y: f64, vx: f64, vy: f64) -> bool {
        todo!("task 11.5: walls within the window")
    }

    /// The reference path of a particle.
    pub fn path(&self, p: &Particle) -> Path {
        if self.meets_wall(p.x, p.y, p.vx, p.vy) {
            // A reflection brings two points closer or leaves them as far apart as they were, so
            // no particle ends further from its start than it flies.
            let spread = p.vx.hypot(p.vy) * self.whole() * (1.0 + 1e-9) + self.rounding();
            Path { x: p.x, y: p.y, wx: 0.0, wy: 0.0, spread }
        } else {
            Path { x: p.x, y: p.y, wx: p.vx, wy: p.vy, spread: 0.0 }
        }
    }
}

impl Path {
    /// Whether two particles could touch within time `span`, if each of them leaves its reference
    /// by no more than its spread and both together by `slack` beyond.
    pub fn may_touch(&self, other: &Self, span: f64, slack: f64) -> bool {
        let (dx, dy) = (other.x - self.x, other.y - self.y);
        let reach = CUTOFF + self.spread + other.spread + slack;
        closest_squared(dx, dy, other.wx - self.wx, other.wy - self.wy, span) <= reach * reach
    }
}
