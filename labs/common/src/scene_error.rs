//! What scenes of particles and of discs are checked for alike.

use std::ops::RangeInclusive;

use thiserror::Error;

/// Why numbers make no scene. A text is `particle` or `disc`, whichever the scene has.
#[derive(Debug, Error, PartialEq)]
pub enum SceneError {
    /// Nothing in it.
    #[error("a scene needs at least one {0}")]
    Empty(&'static str),
    /// More than there are numbers for them.
    #[error("a scene holds at most {MOST} {0}s, not {1}")]
    TooMany(&'static str, u64),
    /// The machine has too little memory for them.
    #[error("not enough memory for {1} {0}s")]
    Memory(&'static str, u64),
    /// The generator's seed 0 means «random» in the original program, a run that cannot be repeated.
    #[error("seed 0 is refused: a run must be repeatable, so choose 1 or more")]
    SeedZero,
    /// A length that is no positive finite number.
    #[error("{name} must be positive and finite, not {value}")]
    Length {
        /// Which: `the radius r`.
        name: &'static str,
        /// Its value.
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
    /// A coordinate or velocity is infinite or no number.
    #[error("{what} {number}: {field} is {value}, not a finite number")]
    NotFinite {
        /// `particle` or `disc`.
        what: &'static str,
        /// Its number.
        number: usize,
        /// `x`, `y`, `vx` or `vy`.
        field: &'static str,
        /// Its value.
        value: f64,
    },
    /// A particle outside the box.
    #[error("particle {number}: {field} = {value} lies outside the box, 0 to {size}")]
    OutsideBox {
        /// The particle's number.
        number: usize,
        /// `x` or `y`.
        field: &'static str,
        /// Its value.
        value: f64,
        /// Side of the box.
        size: f64,
    },
    /// A disc that reaches beyond a wall.
    #[error(
        "disc {number}: {field} = {value} lies outside {least} to {most}, so it reaches beyond a wall"
    )]
    BeyondWall {
        /// The disc's number.
        number: usize,
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

/// The most particles or discs of a scene: ids are the original program's 32-bit integers.
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

/// Checks that x, y, vx and vy of a `what` are finite, and that x and y are in `inside`; `outside` says of what field
/// and value they are not.
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
