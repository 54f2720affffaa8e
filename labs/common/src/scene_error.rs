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
    /// A number is out of its range: the first at fault, and why.
    #[error("{0}")]
    Number(String),
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

/// Checks that x, y, vx and vy are finite, and that x and y are in `inside`, which is called `place`.
pub(crate) fn check_body(
    name: impl Fn() -> String,
    [x, y, vx, vy]: [f64; 4],
    inside: RangeInclusive<f64>,
    place: impl Fn() -> String,
) -> Result<(), SceneError> {
    for (field, value) in [("x", x), ("y", y), ("vx", vx), ("vy", vy)] {
        if !value.is_finite() {
            let fault = format!("{}: {field} is {value}, not a finite number", name());
            return Err(SceneError::Number(fault));
        }
    }
    for (field, value) in [("x", x), ("y", y)] {
        if !inside.contains(&value) {
            let fault = format!("{}: {field} = {value} lies outside {}", name(), place());
            return Err(SceneError::Number(fault));
        }
    }
    Ok(())
}
