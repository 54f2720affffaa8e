//! How long a list of pairs lasts, and what it costs: in nanoseconds on the machine of the book. Costs decide nothing
//! but speed, and they are constants, so that a run repeats.

use common::soft::CUTOFF;

use crate::kernels::Primitives;

/// How much further than the cutoff a list looked when it was built, and how far its particles may
/// have gone since.
pub struct Budget {
    /// Every pair within the cutoff and the skin was listed.
    pub skin: f64,
    /// No particle that it was made for has gone further; infinite if there is no list.
    pub displacement: f64,
}

impl Default for Budget {
    fn default() -> Self {
        Self { skin: 0.0, displacement: f64::INFINITY }
    }
}

impl Budget {
    /// Of a list that is built now.
    pub fn of(skin: f64) -> Self {
        Self { skin, displacement: 0.0 }
    }

    /// Whether the list may lack a pair that touches.
    pub fn has_expired<P: Primitives>(&self) -> bool {
        P::expired(self.displacement, self.skin)
    }
}

/// Steps that the inner list should last of a list that looks `skin` beyond the cutoff, if a step
/// takes no particle further than `displacement`; none if it is cheaper to look at all pairs at each
/// step.
pub fn lasting(skin: f64, displacement: f64) -> Option<f64> {
    let share = |steps: f64| {
        let reach = CUTOFF + 2.0 * (steps - 1.0) * displacement;
        1.0 / steps + (reach / (CUTOFF + skin)).powi(2)
    };
    let steps = (2..12).map(f64::from).min_by(|a, b| share(*a).total_cmp(&share(*b)))?;
    (share(steps) < 0.9).then_some(steps)
}

/// To sort a particle and to begin looking for its pairs.
pub const REBUILD: f64 = 16.0;
/// To test a pair for the list.
pub const TESTED: f64 = 0.45;
/// To look at an entry of the list in a step.
pub const LISTED: f64 = 0.65;
