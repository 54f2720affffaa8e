//! What a figure means: fine, the method's own limit, or a mistake.

use common::soft::{CUTOFF, DT, Particle, Scene};
use oracle::energy;

use super::engine::{Answer, Asked};
use super::method::Method;
use super::scenes::SPEEDS;
use super::trials::{Column, Observable, Trial};
use serde::{Deserialize, Serialize};

/// A cell of the table.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(super) struct Cell {
    pub(super) trial: &'static str,
    pub(super) column: &'static str,
    pub(super) steps: u64,
    /// What was found; none if nothing was.
    pub(super) figure: Option<f64>,
    #[serde(flatten)]
    pub(super) verdict: Verdict,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "verdict", content = "why", rename_all = "lowercase")]
pub(super) enum Verdict {
    Passes,
    /// As bad as the method is, and no worse: the section that explains it.
    Limit(&'static str),
    /// The program cannot be asked for this, and why.
    Unable(&'static str),
    Fails(String),
}

/// What a speed did to its pairs.
#[derive(Clone, Copy, Debug, Deserialize, Serialize)]
pub(super) struct Met {
    #[serde(rename = "relative_speed")]
    pub(super) speed: u32,
    /// The worst change of a pair's energy, as a share of it, and the mean.
    #[serde(rename = "worst_gain")]
    pub(super) worst: f64,
    #[serde(rename = "mean_gain")]
    pub(super) mean: f64,
    /// The share of the pairs that passed through each other.
    #[serde(rename = "share_through")]
    pub(super) through: f64,
}

/// What runs scenes, and says that it goes through time by `method`, at a trial: a cell for each of its columns, and
/// what happened to pairs that met.
pub(super) fn judge(
    method: Method,
    run: impl Fn(&Asked) -> Answer,
    trial: &Trial,
) -> (Vec<Cell>, Vec<Met>) {
    let all = |verdict: Verdict| {
        let cell = |column| Cell::new(trial, column, None, verdict.clone());
        (trial.columns.iter().map(cell).collect(), Vec::new())
    };
    let (mut ends, mut met) = (Vec::new(), Vec::new());
    let mut off: f64 = 0.0;
    let mut wrong = None;
    for scene in &trial.scenes {
        let &Trial { steps, every, stretch, .. } = trial;
        let frames = match run(&Asked { scene, steps, every, stretch }) {
            Ok(Some(frames)) => frames,
            Ok(None) => return all(Verdict::Unable("its step is built in")),
            Err(why) => return all(Verdict::Fails(format!("{why:#}"))),
        };
        // Every observed step, the first and the last among them.
        if frames.len() as u64 != (steps - 1) / every + 1 {
            return all(Verdict::Fails(format!("it showed {} states", frames.len())));
        }
        if let Some(why) = frames.iter().find_map(|frame| unsound(scene, frame)) {
            return all(Verdict::Fails(why));
        }
        if every == 1 && trial.observable != Observable::Inside {
            match follow(method, scene, &frames) {
                Ok(way) => off = off.max(way),
                Err(why) => wrong = wrong.or(Some(why)),
            }
        }
        if let Observable::HeadOn { phases } = trial.observable {
            met = pairs_met(scene, &frames, phases, stretch * DT);
        }
        ends.extend(frames.into_iter().next_back());
    }
    let figures = figures(trial, &ends, &met, off);
    let cell = |(column, &figure): (&Column, &f64)| {
        let verdict = match (&wrong, column.section) {
            (Some(why), _) => Verdict::Fails(why.clone()),
            (None, _) if figure.abs() <= column.good => Verdict::Passes,
            (None, Some(section)) if figure.is_finite() => Verdict::Limit(section),
            (None, _) => Verdict::Fails(format!("{} is {figure:.1e}", column.head)),
        };
        Cell::new(trial, column, Some(figure), verdict)
    };
    (trial.columns.iter().zip(&figures).map(cell).collect(), met)
}

/// A figure for each column: from where the scenes ended, what happened to pairs that met, and how far a step was
/// off at most.
fn figures(trial: &Trial, ends: &[Vec<Particle>], met: &[Met], off: f64) -> Vec<f64> {
    match trial.observable {
        Observable::HeadOn { .. } => {
            let worst = |from, to| {
                let of = met.iter().filter(|met| (from..=to).contains(&met.speed));
                of.map(|met| met.worst.abs()).fold(0.0, f64::max)
            };
            let through = met.iter().find(|met| met.through > 0.0).map_or(0, |met| met.speed);
            vec![worst(1, 5), worst(6, 10), worst(11, 20), f64::from(through)]
        }
        Observable::Energy => {
            let change = |(scene, end): (&Scene, &Vec<Particle>)| {
                energy(end) / energy(scene.particles()).max(1e-300) - 1.0
            };
            vec![trial.scenes.iter().zip(ends).map(change).fold(0.0, furthest)]
        }
        Observable::Off => vec![off / CUTOFF],
        Observable::Shifted => vec![shift(&trial.scenes, ends) / CUTOFF],
        Observable::Inside => vec![0.0],
    }
}

impl Cell {
    fn new(trial: &Trial, column: &Column, figure: Option<f64>, verdict: Verdict) -> Self {
        Self { trial: trial.name, column: column.head, steps: trial.steps, figure, verdict }
    }
}

fn furthest(a: f64, b: f64) -> f64 {
    if b.is_nan() || b.abs() > a.abs() { b } else { a }
}

fn state(p: &Particle) -> String {
    format!("({}, {}), velocity ({}, {})", p.x, p.y, p.vx, p.vy)
}

/// What no method may do.
fn unsound(scene: &Scene, frame: &[Particle]) -> Option<String> {
    frame.iter().enumerate().find_map(|(id, p)| {
        let numbers = [p.x, p.y, p.vx, p.vy];
        if !numbers.iter().all(|number| number.is_finite()) {
            return Some(format!("particle {id} is at {}", state(p)));
        }
        let inside = |x: f64| (0.0..=scene.size()).contains(&x);
        (!inside(p.x) || !inside(p.y)).then(|| {
            format!("particle {id} is at ({}, {}), outside the box of {}", p.x, p.y, scene.size())
        })
    })
}

/// Compares each step with that of its method from where the program itself was. Returns how far it was
/// off at most, or what it did wrong.
fn follow(method: Method, scene: &Scene, frames: &[Vec<Particle>]) -> Result<f64, String> {
    let allowed = method.allowed();
    let mut worst: f64 = 0.0;
    let mut before = scene.particles();
    for (step, after) in frames.iter().enumerate() {
        let expected = method.step(scene.size(), before);
        for (id, (found, expected)) in after.iter().zip(expected).enumerate() {
            let Some((expected, a)) = expected else { continue };
            let speed = expected.vx.abs().max(expected.vy.abs()) + DT * a;
            // What rounding takes of a long way, and of a coordinate far from the corner.
            let digits = 1e-15 * (scene.size() + DT * speed);
            let [shift, change] = [DT * DT * a, DT * a];
            let position =
                allowed.position * (1.0 + 100.0 * shift) + digits + allowed.of_force * shift;
            let velocity = allowed.velocity * (1.0 + change) + 1e-15 * speed + digits / CUTOFF;
            let velocity = velocity + allowed.of_force * change;
            for (x, v, x_there, v_there) in [
                (found.x, found.vx, expected.x, expected.vx),
                (found.y, found.vy, expected.y, expected.vy),
            ] {
                let off = (x - x_there).abs();
                // A particle that ends on a wall may have been turned round already, or not yet.
                let at_wall = x_there <= position || scene.size() - x_there <= position;
                let turned = at_wall && (v + v_there).abs() <= velocity;
                if off > position || ((v - v_there).abs() > velocity && !turned) {
                    let (found, expected) = (state(found), state(&expected));
                    return Err(format!(
                        "particle {id}, step {step}: {found}; the method goes to {expected}"
                    ));
                }
                worst = worst.max(off);
            }
        }
        before = after;
    }
    Ok(worst)
}

/// What happened to the pairs of a head-on scene, speed by speed, in `frames` that are `dt` apart.
fn pairs_met(scene: &Scene, frames: &[Vec<Particle>], phases: u32, dt: f64) -> Vec<Met> {
    let Some(end) = frames.last() else { return Vec::new() };
    let per_speed = 2 * phases as usize;
    let all = scene.particles().chunks(per_speed).zip(end.chunks(per_speed)).zip(SPEEDS);
    all.enumerate()
        .map(|(row, ((start, end), speed))| {
            let pairs = start.chunks(2).zip(end.chunks(2));
            let gains: Vec<f64> =
                pairs.map(|(start, end)| energy(end) / energy(start) - 1.0).collect();
            let firsts = (0..phases as usize).map(|phase| row * per_speed + 2 * phase);
            let through = firsts.filter(|&first| passed(frames, first, scene.size(), dt)).count();
            Met {
                speed,
                worst: gains.iter().copied().fold(0.0, furthest),
                mean: gains.iter().sum::<f64>() / gains.len() as f64,
                through: through as f64 / gains.len() as f64,
            }
        })
        .collect()
}

/// Whether a pair in the middle of the box changed sides before either could have been at a wall:
/// a particle that is thrown back hard enough changes sides there.
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

/// How far apart the ends of two scenes are that differ in their starts by an offset only.
fn shift(scenes: &[Scene], ends: &[Vec<Particle>]) -> f64 {
    let first = |at: usize| scenes[at].particles()[0];
    let offset = ((first(0).x - first(1).x).round(), (first(0).y - first(1).y).round());
    let pairs = ends[0].iter().zip(&ends[1]);
    pairs.map(|(a, b)| (a.x - offset.0 - b.x).hypot(a.y - offset.1 - b.y)).fold(0.0, furthest)
}
