//! Where a particle goes in a window if no other pushes it, and how close two come.

use common::soft::{CUTOFF, Particle};
use solution10::kernels::larger;

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

    /// Whether free flight may touch a wall before the window ends: then the
    /// particle must be computed step by step.
    ///
    /// What counts is where it would be at the end of the window, not where it is now; a particle
    /// that ends within [`Span::rounding`] of a wall counts too.
    ///
    /// Book: chapter 11, *Walls out of reach*.
    #[inline(always)]
    pub fn meets_wall(&self, x: f64, y: f64, vx: f64, vy: f64) -> bool {
        // task 11.5: walls within the window
        let (end_x, end_y) = (x + vx * self.whole(), y + vy * self.whole());
        let (least, most) = (self.rounding(), self.size - self.rounding());
        // Not the other way round: a number that is NaN meets the wall.
        !((end_x >= least) & (end_x <= most) & (end_y >= least) & (end_y <= most))
        // end 11.5
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
    // task 11.2: the closest approach of two paths
    let t = -(dx * wx + dy * wy) / (wx * wx + wy * wy);
    let t = larger(t, 0.0);
    let t = if t < span { t } else { span };
    let (x, y) = (dx + t * wx, dy + t * wy);
    x * x + y * y
    // end 11.2
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

/// Whether a particle with a `deviation` from its reference path may have come near a particle that the search
/// did not list for it. The search listed all pairs within cutoff + `margin`; the other particle
/// of an unlisted pair may be off its own path, too, and is asked about itself if it is off by more.
///
/// Book: chapter 11, *A margin that is checked*.
#[inline(always)]
pub fn too_far_off(deviation: f64, margin: f64) -> bool {
    // task 11.4: whether the margin held
    2.0 * deviation > margin
    // end 11.4
}
