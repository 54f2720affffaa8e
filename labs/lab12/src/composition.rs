//! Steps that are put together from drifts and kicks.

/// Particles that can drift and be kicked.
pub trait Motion {
    /// Moves all positions with their velocities for a time `dt`: x += v dt, with the walls.
    fn drift(&mut self, dt: f64);

    /// Lets all velocities follow the forces for a time `dt`: v += a dt, with the forces at the
    /// positions of the particles now.
    fn kick(&mut self, dt: f64);
}

/// A way to take a step: a drift, a kick, a drift, a kick, …, a drift.
///
/// All are fractions of the step; some are negative and go back in time. The drifts add up to 1 and
/// so do the kicks.
#[derive(Clone, Debug, PartialEq)]
pub struct Composition {
    /// The drifts, one more than there are kicks.
    pub drifts: Vec<f64>,
    /// The kicks.
    pub kicks: Vec<f64>,
}

/// PEFRL's first drift.
pub const XI: f64 = 0.178_617_895_844_809_1;
/// PEFRL's second kick.
pub const LAMBDA: f64 = -0.212_341_831_062_605_4;
/// PEFRL's second drift.
pub const CHI: f64 = -0.066_264_582_669_818_5;

impl Composition {
    /// A kick, then a drift: the official step.
    pub fn symplectic_euler() -> Self {
        Self { drifts: vec![0.0, 1.0], kicks: vec![1.0] }
    }

    /// Velocity Verlet: half a kick, a drift, half a kick.
    ///
    /// A composition begins and ends with a drift. Where it should not, the drift is 0.
    ///
    /// Book: chapter 12, *Drifts and kicks*.
    pub fn velocity_verlet() -> Self {
        todo!("task 12.1b: velocity Verlet as drifts and kicks")
    }

    /// Position Extended Forest-Ruth Like (Omelyan, Mryglod and Folk 2002): five drifts and four
    /// kicks.
    ///
    /// It is symmetric: backwards its drifts are the same, and so are its kicks. The first drift is
    /// [`XI`], the second [`CHI`], the second kick [`LAMBDA`]; the other numbers follow.
    ///
    /// Book: chapter 12, *Drifts and kicks*.
    pub fn pefrl() -> Self {
        todo!("task 12.1c: PEFRL from its three numbers")
    }

    /// Takes one step of length `dt`, in units of time: drifts and kicks by turns, the first drift
    /// first, each for its fraction of `dt`.
    ///
    /// Book: chapter 12, *Drifts and kicks*.
    pub fn step(&self, motion: &mut dyn Motion, dt: f64) {
        todo!("task 12.1: a step of drifts and kicks")
    }
}
