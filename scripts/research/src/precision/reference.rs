//! The exact end of a scene, computed once and kept, with its own error.

use std::fs;
use std::path::PathBuf;

use anyhow::{Context, Result, anyhow};
use common::soft::{Particle, Scene};
use oracle::reference::{Fineness, exact};

use lab_kit::Kit;
use lab_kit::files::write_text;

/// Where all particles are at a time, and how far two computations of it differ (rms).
pub(super) struct Reference {
    pub(super) end: Vec<Particle>,
    pub(super) error: f64,
}

/// The reference of the official scene (n, seed) at `time`: from target/reference, or computed
/// twice with different steps and kept there.
pub(super) fn of(kit: &Kit, n: usize, seed: u32, time: f64) -> Result<Reference> {
    let path = file(kit, n, seed, time);
    if let Some(known) = fs::read_to_string(&path).ok().and_then(|text| read(&text, n)) {
        return Ok(known);
    }
    let scene = Scene::official(n as u64, seed)?;
    let end = exact(&scene, time, Fineness::FINE).map_err(|e| anyhow!(e))?;
    let check = exact(&scene, time, Fineness::CHECK).map_err(|e| anyhow!(e))?;
    let reference = Reference { error: rms(&end, &check), end };
    write_text(&path, &text(&reference)).context("the reference cannot be kept")?;
    Ok(reference)
}

fn file(kit: &Kit, n: usize, seed: u32, time: f64) -> PathBuf {
    kit.path(format!("target/reference/soft-{n}-{seed}-{time}.txt"))
}

/// A line with the error, then `x y vx vy` with all digits.
fn text(reference: &Reference) -> String {
    let lines = reference.end.iter().map(|p| format!("{} {} {} {}\n", p.x, p.y, p.vx, p.vy));
    format!("{}\n{}", reference.error, lines.collect::<String>())
}

fn read(text: &str, n: usize) -> Option<Reference> {
    let (first, rest) = text.split_once('\n')?;
    let end = particles(rest.lines())?;
    (end.len() == n).then_some(Reference { error: first.parse().ok()?, end })
}

/// Particles from lines `x y vx vy`, in id order.
pub(super) fn particles<'a>(lines: impl Iterator<Item = &'a str>) -> Option<Vec<Particle>> {
    lines
        .enumerate()
        .map(|(id, line)| {
            let numbers: Vec<f64> =
                line.split_whitespace().map(str::parse).collect::<Result<_, _>>().ok()?;
            let [x, y, vx, vy] = numbers[..] else { return None };
            Some(Particle { x, y, vx, vy, id: id as u32 })
        })
        .collect()
}

/// Root of the mean squared distance between two states of the same particles.
pub(super) fn rms(a: &[Particle], b: &[Particle]) -> f64 {
    let sum: f64 = a.iter().zip(b).map(|(a, b)| a.to(b).norm_squared()).sum();
    (sum / a.len() as f64).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_kept_is_read_back_to_the_bit() {
        let end = Scene::official(5, 1).unwrap().particles().to_vec();
        let known = read(&text(&Reference { end: end.clone(), error: 1.5e-13 }), 5).unwrap();
        assert_eq!((known.end, known.error), (end, 1.5e-13));
        assert!(read("0\n1 2 3 4\n", 2).is_none(), "a file cut short is no reference");
    }

    #[test]
    fn rms_is_a_distance() {
        let at = |x, y| Particle { x, y, ..Particle::default() };
        let off = rms(&[at(0.0, 0.0), at(1.0, 1.0)], &[at(3.0, 4.0), at(1.0, 1.0)]);
        assert!((off - 12.5_f64.sqrt()).abs() < 1e-15);
    }
}
