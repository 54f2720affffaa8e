//! The constants of the model. Lengths, masses and times have no unit.

/// Area of the box per particle: a box for n particles has side √(0.0005 n).
pub const DENSITY: f64 = 0.0005;

/// Mass of a particle.
pub const MASS: f64 = 0.01;

/// Greatest distance at which two particles exert a force on each other.
pub const CUTOFF: f64 = 0.01;

/// Distance below which the force no longer grows.
pub const MIN_R: f64 = CUTOFF / 100.0;

/// The time step.
pub const DT: f64 = 0.0005;
