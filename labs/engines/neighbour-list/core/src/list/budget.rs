//! The life of a list of pairs, and the costs of building and using the list.
//!
//! Costs are in nanoseconds on the machine of the book. They affect only the speed, and they are
//! constants, so that a run can be repeated exactly.

use common::soft::CUTOFF;

use crate::kernels::Primitives;

/// The skin of a list, and the part of the skin that particles have used up since the list was
/// built.
pub struct Budget {
    /// The list contains every pair that was within the cutoff plus this length.
    pub skin: f64,
    /// The greatest distance that a particle may have moved since the list was built; infinite if
    /// there is no list.
    pub displacement: f64,
}

impl Default for Budget {
    fn default() -> Self {
        Self { skin: 0.0, displacement: f64::INFINITY }
    }
}

impl Budget {
    /// Returns the budget of a list that is built now.
    pub fn of(skin: f64) -> Self {
        Self { skin, displacement: 0.0 }
    }

    /// Whether the list may lack a pair that touches.
    pub fn has_expired<P: Primitives>(&self) -> bool {
        P::expired(self.displacement, self.skin)
    }
}

/// Returns the number of steps that an inner list should last. `None` if steps without an inner
/// list are cheaper.
///
/// The outer list contains the pairs within the cutoff plus `skin`, and no particle moves further
/// than `displacement` in a step.
pub fn lasting(skin: f64, displacement: f64) -> Option<f64> {
    let share = |steps: f64| {
        let reach = CUTOFF + 2.0 * (steps - 1.0) * displacement;
        1.0 / steps + (reach / (CUTOFF + skin)).powi(2)
    };
    let steps = (2..12).map(f64::from).min_by(|a, b| share(*a).total_cmp(&share(*b)))?;
    (share(steps) < 0.9).then_some(steps)
}

/// Cost of sorting a particle and of starting its search for pairs, in nanoseconds.
pub const REBUILD: f64 = 16.0;
/// Cost of testing a pair for the list, in nanoseconds.
pub const TESTED: f64 = 0.45;
/// Cost of reading an entry of the list in a step, in nanoseconds.
pub const LISTED: f64 = 0.65;
