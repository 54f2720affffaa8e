//! How worn a list of pairs is.

use common::soft::CUTOFF;

use crate::skin::worn_out;

/// How much further than the cutoff a list looked when it was built, and how far its particles may
/// have gone since.
pub struct Wear {
    /// Every pair within the cutoff and the skin was listed.
    pub skin: f64,
    /// Nobody for whom it was made went further; infinite if there is no list.
    pub way: f64,
}

impl Default for Wear {
    fn default() -> Self {
        Self { skin: 0.0, way: f64::INFINITY }
    }
}

impl Wear {
    /// Of a list that is built now.
    pub fn of(skin: f64) -> Self {
        Self { skin, way: 0.0 }
    }

    /// Whether the list may lack a pair that touches before anybody has gone `ahead` further.
    pub fn is_out(&self, ahead: f64) -> bool {
        let way = self.way + ahead;
        worn_out(way * way, self.skin)
    }
}

/// Steps that a short list should last of a list that looks `skin` beyond the cutoff, if a step
/// takes nobody further than `way` and it has to look `ahead` by as much more; none if it is cheaper
/// to look at all pairs at each step.
pub(crate) fn lasting(skin: f64, way: f64, ahead: f64) -> Option<f64> {
    let share = |steps: f64| {
        let reach = CUTOFF + 2.0 * (ahead + (steps - 1.0) * way);
        1.0 / steps + (reach / (CUTOFF + skin)).powi(2)
    };
    let steps = (2..12).map(f64::from).min_by(|a, b| share(*a).total_cmp(&share(*b)))?;
    (share(steps) < 0.9).then_some(steps)
}
