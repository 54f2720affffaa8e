//! Runs that must have the same result.

use common::soft::CUTOFF;
use oracle::contest::{Kind, STEPS};
use oracle::{Ask, Random};

use super::entry;
use super::errors::{end, positions};

/// Greatest distance between the same particle in two runs, in cutoffs. Chaos enlarges rounding.
const ROUNDING: f64 = 1e-6;

/// Asks for three runs of one scene.
pub(crate) fn two_runs(random: &mut Random, ask: &mut impl Ask) {
    let scene = Kind::Official.scene(1000, random.bits() as u32 | 1);
    let other = Kind::Crowd.scene(300, 5);
    let [twice, once] = [scene.clone(), scene];
    let question = format!(
        "{}, 1,000 particles, {STEPS} official steps, with another scene in between: x and y of each particle, for \
         each of three runs",
        entry().name()
    );
    let found = || {
        let mut all = entry().run(move |engine| {
            let first = end(engine, &twice, STEPS);
            end(engine, &other, 3);
            [first, end(engine, &twice, STEPS)].concat()
        });
        all.extend(entry().run(move |engine| end(engine, &once, STEPS)));
        all
    };
    ask.judge(&question, found, |found| alike(found, 3));
}

/// Asks for single steps, and for the same steps in a row.
pub(crate) fn steps_in_a_row(random: &mut Random, ask: &mut impl Ask) {
    let scene = Kind::Official.scene(500, random.bits() as u32 | 1);
    let question = format!(
        "{}, 500 particles, {STEPS} official steps with a read after each step, and then the same steps with one read \
         after the last: x and y of each particle at the end, for both runs",
        entry().name()
    );
    let found = || {
        entry().run(move |engine| {
            engine.load(&scene);
            let mut single = Vec::new();
            for _ in 0..STEPS {
                engine.step();
                single = positions(engine, scene.len());
            }
            [single, end(engine, &scene, STEPS)].concat()
        })
    };
    ask.judge(&question, found, |found| alike(found, 2));
}

/// Checks that several runs ended in the same state.
fn alike(found: &[f64], runs: usize) -> Result<(), String> {
    let mut runs = found.chunks((found.len() / runs).max(1));
    let first = runs.next().unwrap_or_default();
    for run in runs {
        for (number, (a, b)) in first.chunks(2).zip(run.chunks(2)).enumerate() {
            let off = (a[0] - b[0]).hypot(a[1] - b[1]) / CUTOFF;
            if off.is_nan() || off > ROUNDING {
                return Err(format!("particle {number} is {off:.1e} cutoffs apart in two runs"));
            }
        }
    }
    Ok(())
}
