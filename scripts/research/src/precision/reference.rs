//! The exact end of a scene, with its own error.

use anyhow::{Result, anyhow};
use common::soft::{Particle, Scene};
use oracle::reference::{Fineness, exact};

/// Where all particles are at a time, and how far two computations of it differ (rms).
pub(crate) struct Reference {
    pub(crate) end: Vec<Particle>,
    pub(crate) error: f64,
}

/// The reference of a scene at `time`, computed twice with different steps.
pub(crate) fn of(scene: &Scene, time: f64) -> Result<Reference> {
    let end = exact(scene, time, Fineness::FINE).map_err(|e| anyhow!(e))?;
    let check = exact(scene, time, Fineness::CHECK).map_err(|e| anyhow!(e))?;
    Ok(Reference { error: rms(&end, &check), end })
}

/// Root of the mean squared distance between two states of the same particles.
pub(crate) fn rms(a: &[Particle], b: &[Particle]) -> f64 {
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
