//! The states of a run as numbers: x, y, vx, vy of each disc, and its collisions with discs and with
//! walls.

use common::hard::{Disc, Scene, Simulation};

use super::one_step;

/// Number of values per disc in a state.
const OF_A_DISC: usize = 6;

/// Returns the states after each of `steps` steps of a scene.
pub fn of_each_step(engine: &mut dyn Simulation, scene: &Scene, steps: usize) -> Vec<f64> {
    engine.load(scene);
    let mut numbers = Vec::new();
    for _ in 0..steps {
        engine.step();
        numbers.extend(read(engine, scene.len()).iter().flat_map(state));
    }
    numbers
}

/// Returns the state after `steps` single steps of a scene.
pub(super) fn of_end(engine: &mut dyn Simulation, scene: &Scene, steps: usize) -> Vec<f64> {
    engine.load(scene);
    (0..steps).for_each(|_| engine.step());
    read(engine, scene.len()).iter().flat_map(state).collect()
}

/// Returns the discs of each of `count` states of `n` discs.
///
/// # Errors
/// If `numbers` has the wrong length.
pub fn split(numbers: &[f64], n: usize, count: usize) -> Result<Vec<Vec<Disc>>, String> {
    if numbers.len() != OF_A_DISC * n * count {
        return Err("the run is not complete".into());
    }
    Ok(numbers.chunks_exact(OF_A_DISC * n).map(discs).collect())
}

/// Checks that every step of a run agrees with the model up to rounding. `numbers` contains the
/// states after each of `steps` steps, and the model restarts from the state before each step.
///
/// # Errors
/// If a step disagrees: its number, the disc and its collision.
pub fn follow(scene: &Scene, numbers: &[f64], steps: usize) -> Result<(), String> {
    let mut before = scene.discs().to_vec();
    for (step, after) in (1..).zip(split(numbers, scene.len(), steps)?) {
        if let Some(wrong) = one_step(&before, &after, scene) {
            return Err(format!("step {step}: {wrong}"));
        }
        before = after;
    }
    Ok(())
}

/// Returns x, y, vx, vy of a disc, and its collisions with discs and with walls.
pub fn state(disc: &Disc) -> [f64; 6] {
    let [met, hit] = [disc.pair_collisions, disc.wall_collisions].map(f64::from);
    [disc.x, disc.y, disc.vx, disc.vy, met, hit]
}

/// Returns the discs of an engine. Discs that the engine does not write stay visibly wrong.
fn read(engine: &dyn Simulation, n: usize) -> Vec<Disc> {
    let mut discs = vec![Disc::new(f64::NAN, f64::NAN, f64::NAN, f64::NAN); n];
    engine.read(0, &mut discs);
    discs
}

fn discs(numbers: &[f64]) -> Vec<Disc> {
    let disc = |v: &[f64]| Disc {
        pair_collisions: v[4] as u32,
        wall_collisions: v[5] as u32,
        ..Disc::new(v[0], v[1], v[2], v[3])
    };
    numbers.chunks_exact(OF_A_DISC).map(disc).collect()
}
