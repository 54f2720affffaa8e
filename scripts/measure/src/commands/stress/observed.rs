//! Measurements of a program in the scenes of a trial, and the figures for the table.

use common::soft::{CUTOFF, DT, Particle, Scene};
use oracle::energy;
use serde::{Deserialize, Serialize};

use super::method::Method;
use super::scenes::SPEEDS;
use super::trials::{Observable, Trial};

/// Measurements of a program in a trial.
#[derive(Default)]
pub(super) struct Observed {
    /// The last state of each scene.
    ends: Vec<Vec<Particle>>,
    /// The results of head-on pairs.
    pub(super) met: Vec<Met>,
    /// Greatest distance of a particle from its place after the method's step.
    off: f64,
    /// A description of the first step that differs from the method's.
    pub(super) wrong: Option<String>,
}

/// The results of head-on pairs of one speed.
#[derive(Clone, Copy, Debug, Deserialize, Serialize)]
pub(super) struct Met {
    #[serde(rename = "relative_speed")]
    pub(super) speed: u32,
    /// Greatest change of a pair's energy, as a share of the energy.
    #[serde(rename = "worst_gain")]
    pub(super) worst: f64,
    /// Mean change of a pair's energy, as a share of the energy.
    #[serde(rename = "mean_gain")]
    pub(super) mean: f64,
    /// Share of the pairs that passed through each other.
    #[serde(rename = "share_through")]
    pub(super) through: f64,
}

impl Observed {
    /// Adds the states of a scene.
    ///
    /// # Errors
    /// A state is not possible with any method; the text describes it.
    pub(super) fn add(
        &mut self,
        method: Method,
        trial: &Trial,
        scene: &Scene,
        frames: Vec<Vec<Particle>>,
    ) -> Result<(), String> {
        frames.iter().try_for_each(|frame| expect_sound(scene, frame))?;
        if trial.every == 1 && trial.observable != Observable::Inside {
            match follow(method, scene, &frames) {
                Ok(way) => self.off = self.off.max(way),
                Err(why) => self.wrong = self.wrong.take().or(Some(why)),
            }
        }
        if let Observable::HeadOn { phases } = trial.observable {
            self.met = pairs_met(scene, &frames, phases, trial.stretch * DT);
        }
        self.ends.extend(frames.into_iter().next_back());
        Ok(())
    }

    /// Returns a figure for each column of the trial.
    pub(super) fn figures(&self, trial: &Trial) -> Vec<f64> {
        match trial.observable {
            Observable::HeadOn { .. } => {
                let through = self.met.iter().find(|met| met.through > 0.0);
                let through = f64::from(through.map_or(0, |met| met.speed));
                vec![self.worst(1, 5), self.worst(6, 10), self.worst(11, 20), through]
            }
            Observable::Energy => {
                let mut most = 0.0;
                for (scene, end) in trial.scenes.iter().zip(&self.ends) {
                    let before = energy(scene.particles()).max(1e-300);
                    most = furthest(most, energy(end) / before - 1.0);
                }
                vec![most]
            }
            Observable::Off => vec![self.off / CUTOFF],
            Observable::Shifted => vec![shift(&trial.scenes, &self.ends) / CUTOFF],
            Observable::Inside => vec![0.0],
        }
    }

    /// Returns the greatest change of a pair's energy at these speeds.
    fn worst(&self, from: u32, to: u32) -> f64 {
        let of = self.met.iter().filter(|met| (from..=to).contains(&met.speed));
        of.map(|met| met.worst.abs()).fold(0.0, f64::max)
    }
}

fn furthest(a: f64, b: f64) -> f64 {
    if b.is_nan() || b.abs() > a.abs() { b } else { a }
}

fn state(p: &Particle) -> String {
    format!("({}, {}), velocity ({}, {})", p.x, p.y, p.vx, p.vy)
}

/// Checks that a state is possible with some method.
fn expect_sound(scene: &Scene, frame: &[Particle]) -> Result<(), String> {
    let size = scene.size();
    for (id, p) in frame.iter().enumerate() {
        if ![p.x, p.y, p.vx, p.vy].iter().all(|number| number.is_finite()) {
            return Err(format!("particle {id} is at {}", state(p)));
        }
        if ![p.x, p.y].iter().all(|x| (0.0..=size).contains(x)) {
            return Err(format!(
                "particle {id} is at ({}, {}), outside the box of {size}",
                p.x, p.y
            ));
        }
    }
    Ok(())
}

/// Compares each step with the method's step from the same state. Returns the greatest distance.
///
/// An error describes the step that differs.
fn follow(method: Method, scene: &Scene, frames: &[Vec<Particle>]) -> Result<f64, String> {
    let allowed = method.allowed();
    let mut worst: f64 = 0.0;
    let mut before = scene.particles();
    for (step, after) in frames.iter().enumerate() {
        let expected = method.step(scene.size(), before);
        for (id, (found, expected)) in after.iter().zip(expected).enumerate() {
            let Some((expected, a)) = expected else { continue };
            let Some(off) = allowed.distance(scene.size(), found, &expected, a) else {
                let found = state(found);
                let expected = state(&expected);
                return Err(format!(
                    "particle {id}, step {step}: {found}; the method goes to {expected}"
                ));
            };
            worst = worst.max(off);
        }
        before = after;
    }
    Ok(worst)
}

/// Measures the pairs of a head-on scene, speed by speed. The time between two of the `frames` is
/// `dt`.
fn pairs_met(scene: &Scene, frames: &[Vec<Particle>], phases: u32, dt: f64) -> Vec<Met> {
    let Some(end) = frames.last() else { return Vec::new() };
    let mut met = Vec::new();
    for (row, speed) in SPEEDS.enumerate() {
        let mut worst = 0.0;
        let mut sum = 0.0;
        let mut through = 0;
        for phase in 0..phases as usize {
            let first = 2 * (row * phases as usize + phase);
            let pair = first..first + 2;
            let gain = energy(&end[pair.clone()]) / energy(&scene.particles()[pair]) - 1.0;
            worst = furthest(worst, gain);
            sum += gain;
            through += u32::from(passed(frames, first, scene.size(), dt));
        }
        let pairs = f64::from(phases);
        met.push(Met { speed, worst, mean: sum / pairs, through: f64::from(through) / pairs });
    }
    met
}

/// Whether a pair in the middle of the box changed sides before either particle could reach a wall.
///
/// Later changes do not count, because a particle that is thrown back fast enough changes sides at
/// the wall.
fn passed(frames: &[Vec<Particle>], first: usize, size: f64, dt: f64) -> bool {
    let mut way = 0.0;
    for frame in frames {
        let [a, b] = [frame[first], frame[first + 1]];
        way += a.vx.abs().max(b.vx.abs()) * dt;
        if way > 0.4 * size {
            return false;
        }
        if a.x > b.x {
            return true;
        }
    }
    false
}

/// Returns the greatest difference between the ends of two scenes whose starts differ by an offset
/// only.
fn shift(scenes: &[Scene], ends: &[Vec<Particle>]) -> f64 {
    let [far, near] = [0, 1].map(|scene| scenes[scene].particles()[0]);
    let offset = ((far.x - near.x).round(), (far.y - near.y).round());
    let pairs = ends[0].iter().zip(&ends[1]);
    pairs.map(|(a, b)| (a.x - offset.0 - b.x).hypot(a.y - offset.1 - b.y)).fold(0.0, furthest)
}
