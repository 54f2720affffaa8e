//! The disc.

use crate::Vec2;

/// A disc: its centre, its velocity and the number of its collisions.
///
/// The number of the disc is its index in the scene. The radius is the same for all discs and
/// belongs to the scene.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C)]
pub struct Disc {
    /// Centre along x, in r ..= L − r.
    pub x: f64,
    /// Centre along y, in r ..= L − r.
    pub y: f64,
    /// Displacement along x in one step.
    pub vx: f64,
    /// Displacement along y in one step.
    pub vy: f64,
    /// Number of collisions with other discs since the start.
    pub pair_collisions: u32,
    /// Number of collisions with walls since the start. A corner counts once.
    pub wall_collisions: u32,
}

impl Disc {
    /// Makes a disc that has not collided yet.
    pub const fn new(x: f64, y: f64, vx: f64, vy: f64) -> Self {
        Self { x, y, vx, vy, pair_collisions: 0, wall_collisions: 0 }
    }

    /// Returns the centre.
    #[inline]
    pub fn position(&self) -> Vec2 {
        Vec2::new(self.x, self.y)
    }

    /// Returns the displacement in one step.
    #[inline]
    pub fn velocity(&self) -> Vec2 {
        Vec2::new(self.vx, self.vy)
    }
}
