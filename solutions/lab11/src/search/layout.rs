//! How a window is laid out.

use common::soft::CUTOFF;
use solution10::Bodies;

use crate::flight::Span;

/// How a window is laid out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Layout {
    pub(crate) span: Span,
    /// Pairs whose reference paths come within cutoff + `margin` are computed.
    pub(crate) margin: f64,
    /// Particles that go further than this in the window are looked after one by one; on a list
    /// there is none.
    pub(crate) reach: f64,
    /// On a list: how much beyond [`near`](Layout::near) pairs may stay that are watched.
    pub(crate) aside: f64,
}

impl Layout {
    /// How close reference paths come that are computed.
    pub(crate) fn near(&self) -> f64 {
        let margin = if self.span.steps == 1 { 0.0 } else { self.margin };
        CUTOFF + self.span.rounding() + margin
    }

    /// When particles are put into cells: halfway from the first forces of the window to the
    /// last. No particle is then further from there than half of its displacement.
    pub(crate) fn halfway(&self) -> f64 {
        0.5 * self.span.forces()
    }

    /// How close two particles are now if their free flights come so close, or close enough to be
    /// watched.
    pub(crate) fn within(&self) -> f64 {
        (self.near() + self.aside + 2.0 * self.reach) * (1.0 + 1e-12)
    }

    /// Length of a cell's side: particles that are not [special](Layout::is_special) and could
    /// meet are halfway in the same or in adjacent cells.
    pub(crate) fn side(&self) -> f64 {
        if self.span.steps == 1 { self.near() } else { self.near() + self.reach }
    }

    /// Whether a particle may leave the straight line or the adjacent cells.
    #[inline(always)]
    pub(crate) fn is_special(&self, bodies: &Bodies, i: usize) -> bool {
        let (vx, vy, fast) = (bodies.vx[i], bodies.vy[i], self.reach / self.span.whole());
        (vx * vx + vy * vy > fast * fast) | self.span.meets_wall(bodies.x[i], bodies.y[i], vx, vy)
    }
}
