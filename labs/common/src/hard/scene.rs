//! Scenes of hard discs, which are checked when they are made.

use super::Disc;
use crate::SceneError;
use crate::scene_error::{self, check_body, check_length};

/// A square of side L with discs of radius r in it.
///
/// Every scene is valid: it has a disc, every number in it is finite, 0 < 2 r ≤ L, and every disc
/// is inside the walls, r ≤ x, y ≤ L − r. Discs may overlap each other. Labs rely on this and need
/// no checks.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    side: f64,
    radius: f64,
    discs: Vec<Disc>,
}

impl Scene {
    /// Checks `discs` of radius `radius` in a square of side `side`, and makes a scene.
    ///
    /// # Errors
    /// A [`SceneError`], which names the first disc that is not valid.
    pub fn new(side: f64, radius: f64, discs: Vec<Disc>) -> Result<Self, SceneError> {
        Self::check_square(side, radius)?;
        Self::check_count(discs.len() as u64)?;
        for (number, disc) in discs.iter().enumerate() {
            Self::check_disc(side, radius, number, disc)?;
        }
        Ok(Self { side, radius, discs })
    }

    pub(super) fn check_count(n: u64) -> Result<usize, SceneError> {
        scene_error::check_count("disc", n)
    }

    pub(super) fn check_square(side: f64, radius: f64) -> Result<(), SceneError> {
        check_length("the side L", side)?;
        check_length("the radius r", radius)?;
        if radius > side - radius {
            return Err(SceneError::TooWide { radius, side });
        }
        Ok(())
    }

    pub(super) fn check_disc(
        side: f64,
        radius: f64,
        number: usize,
        disc: &Disc,
    ) -> Result<(), SceneError> {
        let Disc { x, y, vx, vy, .. } = *disc;
        let least = radius;
        let most = side - radius;
        check_body("disc", number, [x, y, vx, vy], least..=most, |field, value| {
            SceneError::BeyondWall { number, field, value, least, most }
        })
    }

    /// Returns the side L of the square.
    pub fn side(&self) -> f64 {
        self.side
    }

    /// Returns the radius r of every disc.
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// Returns the discs in the order of their numbers.
    pub fn discs(&self) -> &[Disc] {
        &self.discs
    }

    /// Returns the number of discs, at least 1.
    #[expect(clippy::len_without_is_empty, reason = "a scene is never empty")]
    pub fn len(&self) -> usize {
        self.discs.len()
    }
}
