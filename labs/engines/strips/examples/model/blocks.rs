//! A scene divided into a block of rows for each rank.

use common::soft::{CUTOFF, DENSITY, DT};

/// Bytes of a particle in a message.
pub(crate) const WIRE: f64 = 40.0;

/// Mean speed towards a border, times the share ½ of the particles that fly in this direction.
///
/// Components of velocities are uniform in −1 … 1.
const FLOW: f64 = 0.25;

/// A scene on several ranks, in rows of bins.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Blocks {
    /// Number of ranks that have rows.
    pub(crate) active: f64,
    /// Number of particles of the fullest rank.
    pub(crate) largest: f64,
    /// Number of particles in a row.
    pub(crate) row: f64,
    /// Number of particles that cross a border in a step in one direction.
    pub(crate) crossing: f64,
}

impl Blocks {
    /// Divides a scene of `n` particles among `p` ranks, in rows of bins that are `bin` cutoffs
    /// high.
    pub(crate) fn new(n: f64, p: f64, bin: f64) -> Self {
        let side = (DENSITY * n).sqrt();
        let rows = (side / (bin * CUTOFF)).floor().max(1.0);
        let active = p.min(rows);
        let crossing = FLOW * DT * side / DENSITY;
        Self { active, largest: (rows / active).ceil() * n / rows, row: n / rows, crossing }
    }

    /// Returns the number of neighbours of a rank that is not at the edge.
    pub(crate) fn neighbours(&self) -> f64 {
        (self.active - 1.0).min(2.0)
    }

    /// Returns the number of borders between blocks, counted once for each of the two ranks.
    pub(crate) fn borders(&self) -> f64 {
        2.0 * (self.active - 1.0)
    }

    /// Returns the number of particles in border rows, counted once for every rank that needs them.
    pub(crate) fn copies(&self) -> f64 {
        self.borders() * self.row
    }
}
