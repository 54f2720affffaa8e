//! Scenes as a command line describes them, and the options and files that programs read.

use std::f64::consts::PI;
use std::path::Path;
use std::process::Command;
use std::sync::Arc;

use anyhow::Result;
use common::soft::{self, CUTOFF, Particle};
pub use oracle::{read_frames, write_scene};
use serde::{Deserialize, Serialize};

use lab_kit::files::write_file;

/// A scene to simulate. Random numbers have seed 1.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Scene {
    /// The official scene of `n` soft discs.
    Soft {
        /// Number of particles.
        n: usize,
    },
    /// The counter scene of `n` soft discs, in which each rank makes only its share.
    Counter {
        /// Number of particles.
        n: usize,
    },
    /// The official scene of `n` soft discs in a larger or smaller box.
    Spread {
        /// Number of particles.
        n: usize,
        /// Mean number of particles in the area of a cutoff disc.
        neighbours: f64,
    },
    /// A given scene of soft discs.
    #[serde(skip)]
    Given(Arc<soft::Scene>),
    /// Random hard discs.
    Hard {
        /// Number of discs.
        n: usize,
        /// Side of the square.
        side: f64,
        /// Radius of a disc.
        radius: f64,
        /// Least and greatest magnitude of a velocity component; `None` for the assignment's.
        #[serde(skip_serializing_if = "Option::is_none")]
        speeds: Option<(f64, f64)>,
        /// Side of the central square in which the discs begin; `None` for the whole square.
        #[serde(skip_serializing_if = "Option::is_none")]
        blob: Option<f64>,
    },
}

impl Scene {
    /// Makes the usual scene with `n` particles or discs, or with a default number.
    ///
    /// It has 100,000 soft discs, or the hard discs of the CS3210 report's comparisons: 10,000
    /// discs of radius 1 in a square of side 20,000.
    pub fn usual(n: Option<usize>, hard: bool) -> Self {
        match hard {
            true => Self::Hard {
                n: n.unwrap_or(10_000),
                side: 20_000.0,
                radius: 1.0,
                speeds: None,
                blob: None,
            },
            false => Self::Soft { n: n.unwrap_or(100_000) },
        }
    }

    /// Returns the number of particles or discs.
    pub fn n(&self) -> usize {
        match self {
            Self::Soft { n } | Self::Counter { n } | Self::Spread { n, .. } => *n,
            Self::Hard { n, .. } => *n,
            Self::Given(scene) => scene.len(),
        }
    }

    /// Changes the number of particles or discs.
    #[must_use]
    pub fn with_n(mut self, count: usize) -> Self {
        match &mut self {
            Self::Soft { n } | Self::Counter { n } | Self::Spread { n, .. } => *n = count,
            Self::Hard { n, .. } => *n = count,
            Self::Given(_) => {}
        }
        self
    }

    /// Makes the scene `factor` times as large, with the same density.
    ///
    /// The box of soft discs follows from their number. The square of hard discs grows with their
    /// number, and their speeds stay the same.
    #[must_use]
    pub fn times(mut self, factor: usize) -> Self {
        if let (Self::Hard { side, radius, speeds, .. }, 2..) = (&mut self, factor) {
            speeds.get_or_insert((*side / (8.0 * *radius), *side / 4.0));
            *side *= (factor as f64).sqrt();
        }
        let n = factor * self.n();
        self.with_n(n)
    }

    /// Appends the options to a command that make a program take `steps` steps of the scene.
    ///
    /// The function writes to `file` those parts of the scene that options cannot express.
    pub(crate) fn tell(&self, command: &mut Command, file: &Path, steps: u64) -> Result<()> {
        if let Self::Hard { n, side, radius, speeds, blob } = self {
            write_file(file, format!("{n} {side} {radius} {steps} perf\n"))?;
            command.args(["-s", "1"]);
            if let Some((least, most)) = speeds {
                command.args(["--speeds", &format!("{least},{most}")]);
            }
            if let Some(side) = blob {
                command.args(["--blob", &side.to_string()]);
            }
            command.arg(file);
            return Ok(());
        }
        command.args(["--steps", &steps.to_string()]);
        match self {
            Self::Spread { n, neighbours } => {
                give_scene(command, file, &spread(*n, *neighbours)?)?;
            }
            Self::Given(scene) => give_scene(command, file, scene)?,
            other => {
                command.args(["-s", "1", "-n", &other.n().to_string()]);
            }
        }
        if let Self::Counter { .. } = self {
            command.args(["--generator", "counter"]);
        }
        Ok(())
    }
}

/// Writes a scene to `file`, and appends the option that makes a program read this file.
fn give_scene(command: &mut Command, file: &Path, scene: &soft::Scene) -> Result<()> {
    write_scene(file, scene)?;
    command.arg("--scene").arg(file);
    Ok(())
}

/// Makes the official scene of seed 1 in a box of a different size, with the same velocities.
///
/// On average, `neighbours` particles are in the area of a cutoff disc.
fn spread(n: usize, neighbours: f64) -> Result<soft::Scene> {
    let official = soft::Scene::official(n as u64, 1)?;
    let size = (n as f64 * PI / neighbours).sqrt() * CUTOFF;
    let wider = size / official.size();
    let mut particles: Vec<Particle> = official.particles().to_vec();
    for particle in &mut particles {
        particle.x = (particle.x * wider).min(size);
        particle.y = (particle.y * wider).min(size);
    }
    Ok(soft::Scene::new(size, particles)?)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn four_scenes_are_as_crowded_as_one() {
        assert_eq!(Scene::usual(Some(7), false).times(4), Scene::usual(Some(28), false));
        assert_eq!(Scene::usual(Some(7), true).times(1), Scene::usual(Some(7), true));
        let speeds = Some((2500.0, 5000.0));
        let expected = Scene::Hard { n: 28, side: 40_000.0, radius: 1.0, speeds, blob: None };
        assert_eq!(Scene::usual(Some(7), true).times(4), expected);
    }

    #[test]
    fn a_spread_scene_has_the_neighbours_asked_for() {
        for neighbours in [1e-8, 0.3, 61.0] {
            let scene = spread(400, neighbours).unwrap();
            let found = 400.0 / (scene.size() * scene.size()) * PI * CUTOFF * CUTOFF;
            assert!((found - neighbours).abs() < 1e-9 * neighbours, "{found}");
        }
    }
}
