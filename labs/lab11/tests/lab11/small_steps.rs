//! Questions about `substep`: small steps for particles in groups must equal small steps for all
//! particles.

use common::soft::Scene;
use oracle::{Ask, Random, scenes};

use super::variant;
use super::whole_runs::{counted, end, near_the_list, of_numbers, scattered, states};

pub(crate) fn small_steps(_: &mut Random, ask: &mut impl Ask) {
    let scene = scenes::official();
    let substep = variant("11.6", "substep").set("substeps", 10.0);
    let question =
        format!("{}, official scene: x y vx vy of each particle after 100 steps", substep.name());
    let found = || end(&substep, &scene, 100);
    ask.judge(&question, found, |found| near_the_list(found, &scene, 100, 10));
}

/// Asks for small steps of all particles. Before each step the comparison starts from the program's
/// own state.
pub(crate) fn small_steps_anywhere(_: &mut Random, ask: &mut impl Ask) {
    let mut all = scenes::edges();
    all.extend([scenes::official(), scenes::close_pairs()]);
    all.extend(scenes::fast());
    for (number, scene) in all.into_iter().enumerate() {
        let substep = variant("11.6", "substep");
        let question = format!(
            "{}, scene {number} with {} particles: x y vx vy of each particle after each of 3 steps",
            substep.name(),
            scene.len()
        );
        ask.judge(&question, || states(&substep, &scene, 3), |found| each_step(found, &scene));
    }
}

/// Checks that each of several steps equals ten small steps of all particles.
fn each_step(found: &[f64], scene: &Scene) -> Result<(), String> {
    let mut before = scene.clone();
    let states = found.chunks(4 * scene.len());
    if states.len() != 3 {
        return Err("the run is not complete".into());
    }
    for (step, state) in (1..).zip(states) {
        near_the_list(state, &before, 1, 10).map_err(|words| format!("step {step}: {words}"))?;
        before = Scene::new(scene.size(), of_numbers(state)).map_err(|error| error.to_string())?;
    }
    Ok(())
}

/// Asks about overlapping particles that push each other far, beyond any margin.
pub(crate) fn bent_paths(_: &mut Random, ask: &mut impl Ask) {
    let scene = scattered(1200, 0.6, 3);
    let substep = variant("11.6", "substep");
    let again = "share computed again";
    let question = format!("{}, 1,200 overlapping particles, 60 steps: {again}", substep.name());
    ask.judge(
        &question,
        || vec![counted(&substep, again, &scene, 60)],
        |found| match found {
            [again] if *again > 0.0 => Ok(()),
            _ => {
                Err("paths bend so far that they leave their margin, but nothing is computed again"
                    .into())
            }
        },
    );
    let question = format!(
        "{}, the same scene in three runs, (1) with windows that the engine chooses, (2) with windows of 1 step, (3) \
         with windows of 9 steps: x y vx vy of each particle at the end of each run",
        substep.name()
    );
    let windows = [0.0, 1.0, 9.0].map(|steps| substep.clone().set("window", steps));
    let found = || windows.iter().flat_map(|runs| end(runs, &scene, 60)).collect();
    ask.judge(&question, found, |found| {
        let runs: Vec<&[f64]> = found.chunks(4 * scene.len()).collect();
        let [own, one, nine] = runs[..] else { return Err("the runs are not complete".into()) };
        near_the_list(own, &scene, 60, 10)?;
        if own == one && own == nine {
            Ok(())
        } else {
            Err("windows of a different length gave different bits".into())
        }
    });
}
