//! The reference path of a particle in a window: its path if no force bends it.

use common::soft::{CUTOFF, Particle};

use crate::rules::Rules;
use crate::span::Span;

/// The reference path of a particle in a window.
///
/// Far from walls it is the free flight, a straight line. For a particle that could reach a wall,
/// the reference is the point where it starts, and the particle stays within `spread` of this
/// point.
pub(crate) struct Path {
    /// Position at the start of the window.
    pub(crate) x: f64,
    pub(crate) y: f64,
    /// Velocity along x on the reference path.
    pub(crate) wx: f64,
    pub(crate) wy: f64,
    /// Greatest distance between free flight and the reference.
    pub(crate) spread: f64,
}

impl Span {
    /// Returns the reference path of a particle.
    pub(crate) fn path<R: Rules>(&self, p: &Particle) -> Path {
        if R::meets_wall(self, p.x, p.y, p.vx, p.vy) {
            // A reflection never increases the distance between two points. So no particle ends
            // further from its start than its path is long.
            let spread = p.vx.hypot(p.vy) * self.duration() * (1.0 + 1e-9) + self.rounding();
            Path { x: p.x, y: p.y, wx: 0.0, wy: 0.0, spread }
        } else {
            Path { x: p.x, y: p.y, wx: p.vx, wy: p.vy, spread: 0.0 }
        }
    }
}

impl Path {
    /// Whether two particles could touch within time `span`.
    ///
    /// Each particle deviates from its reference by at most its spread, plus a part of `slack`.
    /// Both parts together are at most `slack`.
    pub(crate) fn may_touch<R: Rules>(&self, other: &Self, span: f64, slack: f64) -> bool {
        let dx = other.x - self.x;
        let dy = other.y - self.y;
        let reach = CUTOFF + self.spread + other.spread + slack;
        R::closest_squared(dx, dy, other.wx - self.wx, other.wy - self.wy, span) <= reach * reach
    }
}
