//! The exact end of a scene, with an estimate of its error.

use anyhow::{Result, anyhow};
use common::soft::{Particle, Scene};
use oracle::reference::{Fineness, exact};

/// The state of all particles at a time.
pub struct Reference {
    /// The particles, in id order.
    pub end: Vec<Particle>,
    /// Distance (rms) between two computations of the state, with different steps.
    pub error: f64,
}

/// Computes the reference of a scene at `time`, twice with different steps.
///
/// # Errors
/// The exact motion cannot be computed.
pub fn of(scene: &Scene, time: f64) -> Result<Reference> {
    let end = exact(scene, time, Fineness::FINE).map_err(|e| anyhow!(e))?;
    let check = exact(scene, time, Fineness::CHECK).map_err(|e| anyhow!(e))?;
    Ok(Reference { error: rms(&end, &check), end })
}

/// Returns the root mean square distance between two states of the same particles.
pub fn rms(a: &[Particle], b: &[Particle]) -> f64 {
    let sum: f64 = a.iter().zip(b).map(|(a, b)| a.to(b).norm_squared()).sum();
    (sum / a.len() as f64).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rms_is_a_distance() {
        let at = |x, y| Particle { x, y, ..Particle::default() };
        let off = rms(&[at(0.0, 0.0), at(1.0, 1.0)], &[at(3.0, 4.0), at(1.0, 1.0)]);
        assert!((off - 12.5_f64.sqrt()).abs() < 1e-15);
    }
}
