//! A scene cut into a block of rows for each rank.

use common::soft::{CUTOFF, DENSITY, DT};

/// Bytes of a particle in a message.
pub(super) const WIRE: f64 = 40.0;

/// Mean speed across a border of those that cross it in one direction, times the half that fly in
/// that direction: components are even in −1 … 1.
const FLOW: f64 = 0.25;

/// A scene of `n` particles on `p` ranks, in rows of bins.
#[derive(Clone, Copy, Debug)]
pub(super) struct Blocks {
    /// Ranks that have rows.
    pub(super) active: f64,
    /// Particles of the fullest rank.
    pub(super) largest: f64,
    /// Particles of a row.
    pub(super) row: f64,
    /// Particles that cross a border in a step in one direction.
    pub(super) crossing: f64,
}

impl Blocks {
    /// Rows of bins `bin` cutoffs high.
    pub(super) fn new(n: f64, p: f64, bin: f64) -> Self {
        let side = (DENSITY * n).sqrt();
        let rows = (side / (bin * CUTOFF)).floor().max(1.0);
        let active = p.min(rows);
        let crossing = FLOW * DT * side / DENSITY;
        Self { active, largest: (rows / active).ceil() * n / rows, row: n / rows, crossing }
    }

    /// Neighbours of a rank that has most of them.
    pub(super) fn neighbours(&self) -> f64 {
        (self.active - 1.0).min(2.0)
    }

    /// Borders between blocks, each counted for both of its ranks.
    pub(super) fn borders(&self) -> f64 {
        2.0 * (self.active - 1.0)
    }

    /// Particles of border rows, each counted once for every rank that needs it.
    pub(super) fn copies(&self) -> f64 {
        self.borders() * self.row
    }
}
