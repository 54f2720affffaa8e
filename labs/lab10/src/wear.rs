//! How worn a list of pairs is.

use crate::worn_out;

/// How much further than the cutoff a list looked when it was built, and how far its particles may
/// have gone since.
pub(crate) struct Wear {
    /// Every pair within the cutoff and the skin was listed.
    pub(crate) skin: f64,
    /// Nobody for whom it was made went further; infinite if there is no list.
    pub(crate) way: f64,
}

impl Default for Wear {
    fn default() -> Self {
        Self { skin: 0.0, way: f64::INFINITY }
    }
}

impl Wear {
    /// Of a list that is built now.
    pub(crate) fn of(skin: f64) -> Self {
        Self { skin, way: 0.0 }
    }

    /// Whether the list may lack a pair that touches before anybody has gone `ahead` further.
    pub(crate) fn is_out(&self, ahead: f64) -> bool {
        let way = self.way + ahead;
        worn_out(way * way, self.skin)
    }
}
