//! Errors against the exact motion, compared with the errors of the official step.

use common::soft::{CUTOFF, DT, Particle, Scene, Simulation};
use oracle::contest::{Kind, STEPS};
use oracle::reference::{Fineness, exact};
use oracle::{Ask, Model, Random, Table};

use super::entry;

/// Greatest error, as a multiple of the official step's.
const ALLOWED: f64 = 2.0;

/// Error that is always allowed, because the official step may have no error: a millionth of a
/// cutoff.
const LEAST: f64 = 1e-6 * CUTOFF;

/// Asks for the error after [`STEPS`] official steps of `n` particles of a drawn scene.
pub(crate) fn error(random: &mut Random, ask: &mut impl Ask, kind: Kind, n: usize) {
    let seed = random.bits() as u32 | 1;
    let scene = kind.scene(n, seed);
    let of_run = scene.clone();
    let question = format!(
        "{}, {n} particles of kind '{}', seed {seed}, {STEPS} official steps: x and y of each particle",
        entry().name(),
        kind.name()
    );
    let found = move |engine: &mut dyn Simulation| end(engine, &of_run, STEPS);
    ask.judge(
        &question,
        || entry().run(found),
        |found| judged(found, &scene, STEPS, &kind.exact_end(&scene, seed)?),
    );
}

/// Asks for the errors on small scenes, one after the other through one engine.
pub(crate) fn small_scenes(random: &mut Random, ask: &mut impl Ask) {
    const FEW: u64 = 20;
    let mut all = Vec::new();
    for n in [40, 1, 2, 17, 3] {
        all.push(oracle::scenes::spread(random, n, 12.0 * CUTOFF, 1.0));
    }
    let of_run = all.clone();
    let question = format!(
        "{}, scenes of 40, 1, 2, 17 and 3 particles through one engine, {FEW} official steps each: x and y of each \
         particle",
        entry().name()
    );
    let found = move |engine: &mut dyn Simulation| {
        of_run.iter().flat_map(|scene| end(engine, scene, FEW)).collect()
    };
    ask.judge(
        &question,
        || entry().run(found),
        |found: &[f64]| {
            let mut rest = found;
            for scene in &all {
                let Some((own, others)) = rest.split_at_checked(2 * scene.len()) else {
                    return Err("the run is not complete".into());
                };
                rest = others;
                let right = exact(scene, FEW as f64 * DT, Fineness::FINE)?;
                judged(own, scene, FEW, &right)
                    .map_err(|words| format!("{} particles: {words}", scene.len()))?;
            }
            Ok(())
        },
    );
}

/// Shows scenes that can be checked by hand.
pub(crate) fn meetings(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let at = |x: f64, y: f64, vx: f64| Particle {
            x: x * CUTOFF,
            y: y * CUTOFF,
            vx,
            ..Particle::default()
        };
        let mut table = Table::new(["scene", "x before", "v", "x after", "second x after"]);
        for (name, particles) in [
            ("alone", vec![at(3.0, 5.0, 1.0)]),
            ("a wall", vec![at(3.0, 5.0, -1.0)]),
            ("two far apart", vec![at(3.0, 5.0, 0.4), at(9.0, 9.0, 0.0)]),
            ("two head on", vec![at(3.0, 5.0, 0.4), at(7.0, 5.0, -0.4)]),
            ("one hits another", vec![at(3.0, 5.0, 0.2), at(4.5, 5.0, 0.0)]),
        ] {
            let v = particles[0].vx;
            let scene = Scene::new(10.0 * CUTOFF, particles).expect("all are in the box");
            let of_run = scene.clone();
            let found = entry().run(move |engine| end(engine, &of_run, STEPS));
            let x: Vec<String> =
                found.chunks(2).map(|at| format!("{:.1}", at[0] / CUTOFF)).collect();
            let second = x.get(1).map_or("", |x| x);
            table.row([&name, &"3.0", &format!("{v:.1}"), &x[0], &second]);
        }
        table.to_string()
    });
}

/// Runs a scene and returns x and y of each particle. A particle that the engine does not write is
/// NaN.
pub(crate) fn end(engine: &mut dyn Simulation, scene: &Scene, steps: u64) -> Vec<f64> {
    engine.load(scene);
    engine.run(steps);
    positions(engine, scene.len())
}

/// Returns x and y of each of `n` particles of an engine.
pub(crate) fn positions(engine: &dyn Simulation, n: usize) -> Vec<f64> {
    let unwritten = Particle { x: f64::NAN, y: f64::NAN, ..Particle::default() };
    let mut state = vec![unwritten; n];
    engine.read(0, &mut state);
    state.iter().flat_map(|p| [p.x, p.y]).collect()
}

/// Compares the error of positions with the error of the official step.
fn judged(found: &[f64], scene: &Scene, steps: u64, right: &[Particle]) -> Result<(), String> {
    if found.len() != 2 * scene.len() {
        return Err("the run is not complete".into());
    }
    let mut model = Model::new(scene);
    (0..steps).for_each(|_| model.step());
    let official = rms(right, |id| (model.particles[id].x, model.particles[id].y));
    let own = rms(right, |id| (found[2 * id], found[2 * id + 1]));
    if own <= ALLOWED * official + LEAST {
        return Ok(());
    }
    Err(format!(
        "the error (rms) is {own:.3e}, and the error of the official step is {official:.3e}"
    ))
}

/// Returns the root of the mean squared distance from the right positions.
fn rms(right: &[Particle], position: impl Fn(usize) -> (f64, f64)) -> f64 {
    let squared = |right: &Particle| {
        let (x, y) = position(right.id as usize);
        (x - right.x).powi(2) + (y - right.y).powi(2)
    };
    (right.iter().map(squared).sum::<f64>() / right.len().max(1) as f64).sqrt()
}
