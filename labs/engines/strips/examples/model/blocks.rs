//! A scene cut into a block of rows for each rank.

use common::soft::{CUTOFF, DENSITY, DT};

/// Bytes of a particle in a message.
pub(crate) const WIRE: f64 = 40.0;

/// Mean speed of the particles that cross a border in one direction, times the half that fly in that direction:
/// components of velocities are uniform in −1 … 1.
const FLOW: f64 = 0.25;

/// A scene of `n` particles on `p` ranks, in rows of bins.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Blocks {
    /// Ranks that have rows.
    pub(crate) active: f64,
    /// Particles of the fullest rank.
    pub(crate) largest: f64,
    /// Particles of a row.
    pub(crate) row: f64,
    /// Particles that cross a border in a step in one direction.
    pub(crate) crossing: f64,
}

impl Blocks {
    /// Cuts the scene into rows of bins that are `bin` cutoffs high.
    pub(crate) fn new(n: f64, p: f64, bin: f64) -> Self {
        let side = (DENSITY * n).sqrt();
        let rows = (side / (bin * CUTOFF)).floor().max(1.0);
        let active = p.min(rows);
        let crossing = FLOW * DT * side / DENSITY;
        Self { active, largest: (rows / active).ceil() * n / rows, row: n / rows, crossing }
    }

    /// Returns the neighbours of a rank that has most of them.
    pub(crate) fn neighbours(&self) -> f64 {
        (self.active - 1.0).min(2.0)
    }

    /// Counts the borders between blocks, each for both of its ranks.
    pub(crate) fn borders(&self) -> f64 {
        2.0 * (self.active - 1.0)
    }

    /// Counts the particles of border rows, each once for every rank that needs it.
    pub(crate) fn copies(&self) -> f64 {
        self.borders() * self.row
    }
}
