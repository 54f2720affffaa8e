//! What a program may be off.

use common::soft::DT;

/// How far a correct program may be off after one step.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Allowed {
    /// |Δx| and |Δy| at most.
    pub(crate) position: f64,
    /// |Δvx| and |Δvy| at most.
    pub(crate) velocity: f64,
}

impl Allowed {
    /// Double precision: correct programs stay below a thousandth of it.
    pub(crate) fn in_double(a: f64) -> Self {
        Self { position: 1e-13 * (1.0 + 100.0 * DT * DT * a), velocity: 1e-12 * (1.0 + DT * a) }
    }
}
