//! Scenes that are handed to the labs' programs as files.

use std::f64::consts::PI;
use std::fs;
use std::path::Path;

use anyhow::{Context, Result};
use common::soft::{CUTOFF, FrameFormat, FrameWriter, Particle, Scene};

/// Writes a scene as the labs read it, with all digits.
pub fn write_scene(path: &Path, scene: &Scene) -> Result<()> {
    let mut text = Vec::new();
    let mut writer = FrameWriter::new(&mut text, FrameFormat::Full, scene.len(), scene.size())?;
    writer.particles(scene.particles())?;
    fs::write(path, text).with_context(|| format!("cannot write {}", path.display()))
}

/// The official scene of seed 1 in a box of another size: on average so many `neighbours` stand
/// in the area of a cutoff disc, and the velocities are the same.
pub fn spread(n: usize, neighbours: f64) -> Result<Scene> {
    let official = Scene::official(n as u64, 1)?;
    let size = (n as f64 * PI / neighbours).sqrt() * CUTOFF;
    let wider = size / official.size();
    let move_apart =
        |p: &Particle| Particle { x: (p.x * wider).min(size), y: (p.y * wider).min(size), ..*p };
    Ok(Scene::new(size, official.particles().iter().map(move_apart).collect())?)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_spread_scene_has_the_neighbours_asked_for() {
        for neighbours in [1e-8, 0.3, 61.0] {
            let scene = spread(400, neighbours).unwrap();
            let per_area = 400.0 / (scene.size() * scene.size());
            let found = per_area * PI * CUTOFF * CUTOFF;
            assert!((found - neighbours).abs() < 1e-9 * neighbours, "{found}");
        }
    }
}
