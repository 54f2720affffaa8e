//! Error bounds for programs.

use common::soft::DT;

/// Greatest error of a correct program after one step.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Allowed {
    /// Bound of |Δx| and |Δy|.
    pub(crate) position: f64,
    /// Bound of |Δvx| and |Δvy|.
    pub(crate) velocity: f64,
}

impl Allowed {
    /// Returns the bounds for double precision. The errors of correct programs are below a
    /// thousandth of these bounds.
    pub(crate) fn in_double(a: f64) -> Self {
        Self { position: 1e-13 * (1.0 + 100.0 * DT * DT * a), velocity: 1e-12 * (1.0 + DT * a) }
    }
}
