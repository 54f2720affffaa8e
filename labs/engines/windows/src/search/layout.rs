//! How a window is laid out.

use std::f64::consts::PI;

use common::soft::CUTOFF;
use neighbour_list::{LISTED, REBUILD, TESTED};

use crate::span::Span;

/// How a window is laid out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Layout {
    pub(crate) span: Span,
    /// Pairs whose reference paths come within cutoff + `margin` are computed.
    pub(crate) margin: f64,
    /// How far the fastest particle goes in the window.
    pub(crate) reach: f64,
}

impl Layout {
    /// How close reference paths come that are computed.
    pub(crate) fn near(&self) -> f64 {
        let margin = if self.span.steps == 1 { 0.0 } else { self.margin };
        CUTOFF + self.span.rounding() + margin
    }

    /// How close they come that are computed or watched.
    pub(crate) fn watched(&self) -> f64 {
        self.near() + ASIDE
    }

    /// How far beyond the cutoff a list has to look that has all these pairs in `windows` such windows.
    pub(crate) fn skin(&self, windows: f64) -> f64 {
        self.watched() - CUTOFF + 2.0 * windows * self.reach
    }

    /// How far both of a pair may be off their paths together without touching unseen.
    pub(crate) fn slack(&self) -> f64 {
        self.margin + ASIDE
    }

    /// For how many windows a list should last, where there are `density` particles per area: it costs
    /// to build one, and to look through a long one.
    pub(crate) fn lasting(&self, density: f64) -> f64 {
        let cost = |windows: f64| {
            let area = (CUTOFF + self.skin(windows)).powi(2) * density;
            (REBUILD + 4.5 * TESTED * area) / windows + 0.5 * PI * LISTED * area
        };
        let all = (1..=LONGEST).map(f64::from);
        all.min_by(|a, b| cost(*a).total_cmp(&cost(*b))).unwrap_or(1.0)
    }
}

/// How much further apart than pairs that are computed those may stay that are watched.
const ASIDE: f64 = 0.1 * CUTOFF;
/// The most windows that a list is made for.
const LONGEST: u32 = 16;
