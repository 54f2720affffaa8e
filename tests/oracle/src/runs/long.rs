//! Questions about long runs, in which chaos hides errors of single particles.

use common::soft::{
    Averages, CUTOFF, FrameFormat, FrameWriter, Particle, Scene, Simulation, Statistics,
};

use super::Runs;
use super::states::{States, read};
use crate::official::{OFFICIAL_SHA256, sha256};
use crate::{Ask, Model, energy, scenes};

impl Runs {
    /// Asks for a free run on the official scene. Its positions must agree with the model's to 10⁻⁹
    /// until step 200. Later, chaos has amplified the differences too much.
    pub fn free_run(&self, ask: &mut impl Ask) {
        let scene = scenes::official();
        let of_run = scene.clone();
        let found =
            move |engine: &mut dyn Simulation| States::of_run(engine, &of_run, 200, 0).numbers();
        let question = format!(
            "{}: x y vx vy of each particle after each step. Positions must be within 1e-9 of the model's positions",
            self.question(&scene, 200)
        );
        ask.judge(
            &question,
            || self.run(found),
            |found| {
                let mut rest = found;
                beside_the_model(&scene, &States::split(&mut rest, scene.len(), 200)?)
            },
        );
    }

    /// Asks for the official run, n = 1000 and seed 1, in the official format. The output must
    /// equal the reference program's byte for byte.
    pub fn official_bytes(&self, ask: &mut impl Ask) {
        let found = || self.run(official_digest);
        let question = format!(
            "{}, official scene, n = 1000, seed 1: sha256 of the output, one number for each of its bytes",
            self.name()
        );
        ask.judge(&question, found, |found| {
            let digest: String = found.iter().map(|byte| format!("{:02x}", *byte as u8)).collect();
            if digest == OFFICIAL_SHA256 {
                return Ok(());
            }
            Err(format!(
                "the official output differs from the output of the reference program (the sha256 of your output is \
                 {digest}). The other tests of the task name the first wrong particle. If all of these tests pass, \
                 only last digits differ"
            ))
        });
    }

    /// Asks for the statistics of the second half of the official run, and for its energy drift.
    /// Both must be in the ranges of correct programs.
    pub fn long_statistics(&self, ask: &mut impl Ask) {
        let name = self.name();
        let found = move |engine: &mut dyn Simulation| {
            let scene = scenes::official();
            engine.load(&scene);
            let steps: Vec<Statistics> = (0..1000)
                .map(|_| {
                    engine.step();
                    statistics(engine, &name)
                })
                .collect();
            let a = Averages::of(scene.len(), &steps[500..]).expect("the run has 500 steps");
            let end = States::of(&read(engine, scene.len())).numbers();
            [vec![a.neighbours, a.absmin, a.absavg], end].concat()
        };
        let question = format!(
            "{}, official scene, steps 501 to 1000: (1) neighbours per particle, (2) absmin, (3) absavg, (4) x y vx \
             vy of each particle at the end",
            self.name()
        );
        ask.judge(&question, || self.clone().statistics().run(found), right_averages);
    }

    /// Asks for the statistics of each of `steps` steps. They must equal the statistics of the
    /// model's state before the step: counts exactly, distances to 10⁻¹².
    pub fn statistics_of_each_step(&self, ask: &mut impl Ask, scene: &Scene, steps: usize) {
        let (of_run, name) = (scene.clone(), self.name());
        let found = move |engine: &mut dyn Simulation| {
            engine.load(&of_run);
            let mut numbers = Vec::new();
            for _ in 0..steps {
                engine.step();
                let s = statistics(engine, &name);
                numbers.extend([s.dmin, s.davg, s.navg as f64]);
                numbers.extend(States::of(&read(engine, of_run.len())).numbers());
            }
            numbers
        };
        let question = format!(
            "{}: for each step, (1) dmin, davg and navg, (2) x y vx vy of each particle after the step",
            self.question(scene, steps)
        );
        ask.judge(
            &question,
            || self.clone().statistics().run(found),
            |found| {
                let mut rest = found;
                let mut before = scene.particles().to_vec();
                for step in 1..=steps {
                    let Some((own, more)) = rest.split_at_checked(3) else {
                        return Err("the run is not complete".into());
                    };
                    right_statistics(own, &before)
                        .map_err(|words| format!("step {step}: {words}"))?;
                    rest = more;
                    before = States::split(&mut rest, scene.len(), 1)?.state(0);
                }
                Ok(())
            },
        );
    }
}

fn statistics(engine: &dyn Simulation, name: &str) -> Statistics {
    engine.statistics().unwrap_or_else(|| {
        panic!("{name}: the engine returns no statistics, although it was built with statistics")
    })
}

/// Checks that averages, and the energy at the end, are in the ranges of correct programs.
fn right_averages(found: &[f64]) -> Result<(), String> {
    let scene = scenes::official();
    let (averages, mut rest) = found.split_at_checked(3).ok_or("the run is not complete")?;
    let end = States::split(&mut rest, scene.len(), 1)?.state(0);
    let change = energy(&end) / energy(scene.particles()) - 1.0;
    for (name, value, least, greatest) in [
        ("neighbours per particle", averages[0], 0.088, 0.105),
        ("absmin", averages[1], 0.74, 0.87),
        ("absavg", averages[2], 0.953, 0.961),
        ("the relative change of the energy", change, -0.01, 0.09),
    ] {
        if !(least..=greatest).contains(&value) {
            return Err(format!("{name} is {value:.4}, but must be from {least} to {greatest}"));
        }
    }
    Ok(())
}

fn beside_the_model(scene: &Scene, states: &States) -> Result<(), String> {
    let mut model = Model::new(scene);
    for step in 1..=states.count() {
        model.step();
        for (found, expected) in states.state(step - 1).iter().zip(&model.particles) {
            let off = (found.x - expected.x).hypot(found.y - expected.y);
            if off.is_nan() || off > 1e-9 {
                let id = expected.id;
                return Err(format!(
                    "step {step}: particle {id} is {off:.1e} away from its position in the model"
                ));
            }
        }
    }
    Ok(())
}

/// Returns the digest of the official run's output, a number for each byte.
fn official_digest(engine: &mut dyn Simulation) -> Vec<f64> {
    let scene = scenes::official();
    engine.load(&scene);
    let mut file = Vec::new();
    let format = FrameFormat::Official;
    let mut frames = FrameWriter::new(&mut file, format, scene.len(), scene.size())
        .expect("bytes can be written to memory");
    for step in 0..1000 {
        engine.step();
        if step % 10 == 0 {
            let state = read(engine, scene.len());
            frames
                .particles(&state)
                .and_then(|()| frames.end_frame())
                .expect("bytes can be written to memory");
        }
    }
    let digest = sha256(&file);
    let byte =
        |at: usize| u8::from_str_radix(&digest[at..at + 2], 16).expect("the digest is hexadecimal");
    (0..digest.len()).step_by(2).map(|at| f64::from(byte(at))).collect()
}

/// Checks that dmin, davg and navg are right for the pairs of a state.
fn right_statistics(found: &[f64], before: &[Particle]) -> Result<(), String> {
    let right = statistics_of(before);
    for (k, (what, expected)) in [
        ("the least distance, dmin,", right.dmin),
        ("the sum of distances, davg,", right.davg),
        ("the number of ordered pairs within the cutoff, navg,", right.navg as f64),
    ]
    .into_iter()
    .enumerate()
    {
        if (found[k] - expected).abs() > 1e-12 * expected.abs().max(1.0) {
            return Err(format!("{what} is {}, but must be {expected}", found[k]));
        }
    }
    Ok(())
}

/// Returns the model's statistics of each of `steps` steps of a scene.
pub fn statistics_of_run(scene: &Scene, steps: usize) -> Vec<Statistics> {
    let mut model = Model::new(scene);
    let mut all = Vec::new();
    for _ in 0..steps {
        all.push(statistics_of(&model.particles));
        model.step();
    }
    all
}

/// Returns the statistics of the pairs of a state; pair tests are not counted.
fn statistics_of(particles: &[Particle]) -> Statistics {
    let mut seen = Statistics::default();
    for p in particles {
        for q in particles {
            let r2 = (q.x - p.x) * (q.x - p.x) + (q.y - p.y) * (q.y - p.y);
            if r2 > 0.0 && r2 <= CUTOFF * CUTOFF {
                let r = r2.sqrt() / CUTOFF;
                seen.dmin = seen.dmin.min(r);
                seen.davg += r;
                seen.navg += 1;
            }
        }
    }
    seen
}
