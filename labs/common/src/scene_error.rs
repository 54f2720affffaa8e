//! The common checks of scenes of particles and scenes of discs, and the errors of these checks.

use std::ops::RangeInclusive;

use thiserror::Error;

/// The reason why numbers do not make a valid scene. Some variants contain the word `particle` or
/// `disc`.
#[derive(Debug, Error, PartialEq)]
pub enum SceneError {
    /// The scene is empty.
    #[error("a scene needs at least one {0}")]
    Empty(&'static str),
    /// The scene has more particles or discs than ids can count.
    #[error("a scene holds at most {MOST} {0}s, not {1}")]
    TooMany(&'static str, u64),
    /// The machine has too little memory for the particles or discs.
    #[error("not enough memory for {1} {0}s")]
    Memory(&'static str, u64),
    /// The seed is 0. In the original program, seed 0 means «random», a run that cannot be
    /// repeated.
    #[error("seed 0 is refused: a run must be repeatable, so choose 1 or more")]
    SeedZero,
    /// A length is not positive and finite.
    #[error("{name} must be positive and finite, not {value}")]
    Length {
        /// The name of the length, such as `the radius r`.
        name: &'static str,
        /// The value of the length.
        value: f64,
    },
    /// A single disc does not fit into the square.
    #[error("a disc of radius r = {radius} does not fit into a square of side L = {side}")]
    TooWide {
        /// The radius.
        radius: f64,
        /// The side.
        side: f64,
    },
    /// A coordinate or velocity is infinite or NaN.
    #[error("{what} {number}: {field} is {value}, not a finite number")]
    NotFinite {
        /// `particle` or `disc`.
        what: &'static str,
        /// The number of the particle or disc.
        number: usize,
        /// `x`, `y`, `vx` or `vy`.
        field: &'static str,
        /// The value of the field.
        value: f64,
    },
    /// A particle is outside the box.
    #[error("particle {number}: {field} = {value} lies outside the box, 0 to {size}")]
    OutsideBox {
        /// The particle's number.
        number: usize,
        /// `x` or `y`.
        field: &'static str,
        /// The value of the field.
        value: f64,
        /// Side of the box.
        size: f64,
    },
    /// A disc reaches beyond a wall.
    #[error(
        "disc {number}: {field} = {value} lies outside {least} to {most}, so it reaches beyond a wall"
    )]
    BeyondWall {
        /// The disc's number.
        number: usize,
        /// `x` or `y`.
        field: &'static str,
        /// The value of the field.
        value: f64,
        /// The least value, r.
        least: f64,
        /// The greatest value, L − r.
        most: f64,
    },
}

/// The greatest number of particles or discs in a scene. Ids are the original program's 32-bit
/// integers.
pub(crate) const MOST: usize = i32::MAX as usize;

pub(crate) fn check_count(what: &'static str, n: u64) -> Result<usize, SceneError> {
    match n {
        0 => Err(SceneError::Empty(what)),
        _ if n > MOST as u64 => Err(SceneError::TooMany(what, n)),
        _ => Ok(n as usize),
    }
}

pub(crate) fn check_length(name: &'static str, value: f64) -> Result<(), SceneError> {
    if value.is_finite() && value > 0.0 { Ok(()) } else { Err(SceneError::Length { name, value }) }
}

/// Checks that x, y, vx and vy of a `what` are finite, and that x and y are in `inside`.
///
/// If x or y is not in `inside`, the error is `outside(field, value)`.
pub(crate) fn check_body(
    what: &'static str,
    number: usize,
    [x, y, vx, vy]: [f64; 4],
    inside: RangeInclusive<f64>,
    outside: impl Fn(&'static str, f64) -> SceneError,
) -> Result<(), SceneError> {
    for (field, value) in [("x", x), ("y", y), ("vx", vx), ("vy", vy)] {
        if !value.is_finite() {
            return Err(SceneError::NotFinite { what, number, field, value });
        }
    }
    for (field, value) in [("x", x), ("y", y)] {
        if !inside.contains(&value) {
            return Err(outside(field, value));
        }
    }
    Ok(())
}
