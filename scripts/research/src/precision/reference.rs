//! The exact end of a scene, computed once and kept, with its own error.

use std::fs;
use std::path::Path;

use anyhow::{Context, Result, anyhow};
use common::soft::{Particle, Scene};
use oracle::reference::{Fineness, exact};

use lab_kit::Kit;
use lab_kit::files::write_file;
use lab_measure::scene::read_frames;

/// Where all particles are at a time, and how far two computations of it differ (rms).
pub(crate) struct Reference {
    pub(crate) end: Vec<Particle>,
    pub(crate) error: f64,
}

/// The reference of the official scene (n, seed) at `time`: from target/reference, or computed
/// twice with different steps and kept there.
pub(crate) fn of(kit: &Kit, n: u64, seed: u32, time: f64) -> Result<Reference> {
    let path = kit.path(format!("target/reference/soft-{n}-{seed}-{time}.txt"));
    if let Ok(known) = read(&path, n) {
        return Ok(known);
    }
    let scene = Scene::official(n, seed)?;
    let end = exact(&scene, time, Fineness::FINE).map_err(|e| anyhow!(e))?;
    let check = exact(&scene, time, Fineness::CHECK).map_err(|e| anyhow!(e))?;
    let reference = Reference { error: rms(&end, &check), end };
    let lines = reference.end.iter().map(|p| format!("{} {} {} {}\n", p.x, p.y, p.vx, p.vy));
    let text = format!("{}\n{}", reference.error, lines.collect::<String>());
    write_file(&path, &text).context("the reference cannot be kept")?;
    Ok(reference)
}

/// A line with the error, then `x y vx vy` with all digits.
fn read(path: &Path, n: u64) -> Result<Reference> {
    let text = fs::read_to_string(path)?;
    let error = text.lines().next().context("an empty file")?.parse()?;
    let [end] = <[_; 1]>::try_from(read_frames(path, n as usize)?)
        .map_err(|frames| anyhow!("{} frames", frames.len()))?;
    Ok(Reference { end, error })
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
    fn what_is_kept_is_read_back_to_the_bit() {
        let folder = tempfile::tempdir().unwrap();
        let kit = Kit::at(folder.path());
        let computed = of(&kit, 5, 1, 1e-4).unwrap();
        let path = kit.path("target/reference/soft-5-1-0.0001.txt");
        let known = read(&path, 5).unwrap();
        assert_eq!((known.end, known.error), (computed.end, computed.error));
        fs::write(&path, "0\n1 2 3 4\n").unwrap();
        assert!(read(&path, 5).is_err(), "a file cut short is no reference");
    }

    #[test]
    fn rms_is_a_distance() {
        let at = |x, y| Particle { x, y, ..Particle::default() };
        let off = rms(&[at(0.0, 0.0), at(1.0, 1.0)], &[at(3.0, 4.0), at(1.0, 1.0)]);
        assert!((off - 12.5_f64.sqrt()).abs() < 1e-15);
    }
}
