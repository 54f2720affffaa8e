//! The square that discs are in.

use common::hard::Scene;

/// The square and the radius.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Square {
    /// Side L of the square.
    pub side: f64,
    /// Radius r of every disc.
    pub radius: f64,
}

impl Square {
    /// The square of a scene.
    pub fn of(scene: &Scene) -> Self {
        Self { side: scene.side(), radius: scene.radius() }
    }

    /// The least coordinate of a centre: r.
    #[inline]
    pub fn least(&self) -> f64 {
        self.radius
    }

    /// The greatest coordinate of a centre: L − r.
    #[inline]
    pub fn most(&self) -> f64 {
        self.side - self.radius
    }
}
