//! The dimensions of a window: its steps, and the distances that a search depends on.

use std::f64::consts::PI;

use common::soft::CUTOFF;
use neighbour_list::{LISTED, REBUILD, TESTED};

use crate::span::Span;

/// The dimensions of a window.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Layout {
    pub(crate) span: Span,
    /// Pairs whose reference paths come within cutoff + `margin` are computed.
    pub(crate) margin: f64,
    /// The distance that the fastest particle goes in the window.
    pub(crate) reach: f64,
}

impl Layout {
    /// Returns the distance between two reference paths up to which their pair is computed.
    pub(crate) fn near(&self) -> f64 {
        let margin = if self.span.steps == 1 { 0.0 } else { self.margin };
        CUTOFF + self.span.rounding() + margin
    }

    /// Returns the distance between two reference paths up to which their pair is computed or
    /// watched.
    pub(crate) fn watched(&self) -> f64 {
        self.near() + WATCHED_MARGIN
    }

    /// Returns the skin of a list that contains all computed and watched pairs of `windows` such
    /// windows.
    pub(crate) fn skin(&self, windows: f64) -> f64 {
        self.watched() - CUTOFF + 2.0 * windows * self.reach
    }

    /// Returns the sum of deviations up to which the particles of an unwatched pair cannot touch.
    pub(crate) fn slack(&self) -> f64 {
        self.margin + WATCHED_MARGIN
    }

    /// Returns the number of windows that a list should last, for `density` particles per unit
    /// area.
    ///
    /// A list for few windows must be built often, and a list for many windows costs more in each
    /// of them.
    pub(crate) fn lasting(&self, density: f64) -> f64 {
        let cost = |windows: f64| {
            let area = (CUTOFF + self.skin(windows)).powi(2) * density;
            (REBUILD + 4.5 * TESTED * area) / windows + 0.5 * PI * LISTED * area
        };
        let all = (1..=LONGEST).map(f64::from);
        all.min_by(|a, b| cost(*a).total_cmp(&cost(*b))).unwrap_or(1.0)
    }
}

/// The distance beyond [`Layout::near`] within which pairs are watched.
const WATCHED_MARGIN: f64 = 0.1 * CUTOFF;
/// The greatest number of windows that a list is made for.
const LONGEST: u32 = 16;
