//! Discs in a square, checked once.

use thiserror::Error;

use super::Disc;

/// A square of side L with discs of radius r in it.
///
/// A scene that exists is sound: it has a disc, every number in it is finite, 0 < 2 r ≤ L, and
/// every disc lies inside the walls, r ≤ x, y ≤ L − r. Discs may overlap each other. Labs rely on
/// it and check nothing.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    side: f64,
    radius: f64,
    discs: Vec<Disc>,
}

/// Why discs, a side and a radius make no scene.
#[derive(Debug, Error, PartialEq)]
pub enum SceneError {
    /// No disc at all.
    #[error("a scene needs at least one disc")]
    Empty,
    /// More discs than numbers for them.
    #[error("a scene holds at most {most} discs, not {0}", most = Scene::MOST)]
    TooMany(u64),
    /// The machine has too little memory for the discs.
    #[error("not enough memory for {0} discs")]
    Memory(u64),
    /// The side is no positive finite number.
    #[error("the side L must be positive and finite, not {0}")]
    Side(f64),
    /// The radius is no positive finite number.
    #[error("the radius r must be positive and finite, not {0}")]
    Radius(f64),
    /// A single disc does not fit into the square.
    #[error("a disc of radius r = {radius} does not fit into a square of side L = {side}")]
    TooWide {
        /// The radius.
        radius: f64,
        /// The side.
        side: f64,
    },
    /// A coordinate or velocity is infinite or no number.
    #[error("disc {disc}: {field} is {value}, not a finite number")]
    NotFinite {
        /// The disc's number.
        disc: usize,
        /// `x`, `y`, `vx` or `vy`.
        field: &'static str,
        /// Its value.
        value: f64,
    },
    /// A disc that reaches beyond a wall.
    #[error(
        "disc {disc}: {field} = {value} lies outside {least} to {most}, so it reaches beyond a wall"
    )]
    Outside {
        /// The disc's number.
        disc: usize,
        /// `x` or `y`.
        field: &'static str,
        /// Its value.
        value: f64,
        /// The least value, r.
        least: f64,
        /// The greatest value, L − r.
        most: f64,
    },
}

impl Scene {
    /// The greatest number of discs.
    pub const MOST: usize = i32::MAX as usize;

    /// Checks `discs` of radius `radius` in a square of side `side`.
    ///
    /// # Errors
    /// See [`SceneError`], which names the first disc at fault.
    pub fn new(side: f64, radius: f64, discs: Vec<Disc>) -> Result<Self, SceneError> {
        Self::check_square(side, radius)?;
        Self::check_count(discs.len() as u64)?;
        for (number, disc) in discs.iter().enumerate() {
            Self::check_disc(side, radius, number, disc)?;
        }
        Ok(Self { side, radius, discs })
    }

    pub(super) fn check_count(n: u64) -> Result<usize, SceneError> {
        match n {
            0 => Err(SceneError::Empty),
            _ if n > Self::MOST as u64 => Err(SceneError::TooMany(n)),
            _ => Ok(n as usize),
        }
    }

    pub(super) fn check_square(side: f64, radius: f64) -> Result<(), SceneError> {
        let positive = |value: f64| value.is_finite() && value > 0.0;
        if !positive(side) {
            return Err(SceneError::Side(side));
        }
        if !positive(radius) {
            return Err(SceneError::Radius(radius));
        }
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
        for (field, value) in [("x", x), ("y", y), ("vx", vx), ("vy", vy)] {
            if !value.is_finite() {
                return Err(SceneError::NotFinite { disc: number, field, value });
            }
        }
        let (least, most) = (radius, side - radius);
        for (field, value) in [("x", x), ("y", y)] {
            if !(least..=most).contains(&value) {
                return Err(SceneError::Outside { disc: number, field, value, least, most });
            }
        }
        Ok(())
    }

    /// Side L of the square.
    pub fn side(&self) -> f64 {
        self.side
    }

    /// Radius r of every disc.
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// The discs in the order of their numbers.
    pub fn discs(&self) -> &[Disc] {
        &self.discs
    }

    /// Number of discs, at least 1.
    #[expect(clippy::len_without_is_empty, reason = "a scene is never empty")]
    pub fn len(&self) -> usize {
        self.discs.len()
    }
}
