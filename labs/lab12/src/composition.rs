//! Steps that are composed of drifts and kicks.

/// Particles that can drift and be kicked.
pub trait Motion {
    /// Moves all positions with their velocities for a time `dt`: `x += v * dt`. The walls reflect
    /// particles.
    fn drift(&mut self, dt: f64);

    /// Changes all velocities by the forces for a time `dt`: `v += a * dt`, with the forces at the
    /// current positions.
    fn kick(&mut self, dt: f64);
}

/// A step that is composed of drifts and kicks: a drift, a kick, a drift, a kick, …, a drift.
///
/// The numbers are fractions of the step. Some fractions are negative: these go back in time. The drifts
/// add up to 1, and the kicks add up to 1.
#[derive(Clone, Debug, PartialEq)]
pub struct Composition {
    /// The drifts. There is one more drift than there are kicks.
    pub drifts: Vec<f64>,
    /// The kicks.
    pub kicks: Vec<f64>,
}

/// The first drift of PEFRL.
pub const XI: f64 = 0.178_617_895_844_809_1;
/// The second kick of PEFRL.
pub const LAMBDA: f64 = -0.212_341_831_062_605_4;
/// The second drift of PEFRL.
pub const CHI: f64 = -0.066_264_582_669_818_5;

impl Composition {
    /// Returns the official step: a kick, then a drift.
    pub fn symplectic_euler() -> Self {
        Self { drifts: vec![0.0, 1.0], kicks: vec![1.0] }
    }

    /// Returns velocity Verlet: half a kick, a drift, half a kick.
    ///
    /// A composition always begins and ends with a drift. Here these two drifts are 0.
    ///
    /// Book: chapter 12, *Drifts and kicks*.
    pub fn velocity_verlet() -> Self {
        todo!("task 12.1b: velocity Verlet as drifts and kicks")
    }

    /// Returns PEFRL (Position Extended Forest-Ruth Like, by Omelyan, Mryglod and Folk 2002).
    ///
    /// It has five drifts and four kicks, and it is symmetric: the drifts are the same in reverse
    /// order, and so are the kicks. The first drift is [`XI`], the second drift is [`CHI`], and the
    /// second kick is [`LAMBDA`]. The remaining numbers follow from the symmetry, and from the rule
    /// that the drifts add up to 1 and the kicks add up to 1.
    ///
    /// Book: chapter 12, *Drifts and kicks*.
    pub fn pefrl() -> Self {
        todo!("task 12.1c: PEFRL from its three numbers")
    }

    /// Takes one step of length `dt`, in units of time.
    ///
    /// Drifts and kicks alternate, beginning with the first drift. Each takes its fraction of `dt`.
    ///
    /// Book: chapter 12, *Drifts and kicks*.
    pub fn step(&self, motion: &mut dyn Motion, dt: f64) {
        todo!("task 12.1: a step of drifts and kicks")
    }
}
