//! Questions about the planner's decisions.

use std::f64::consts::{PI, SQRT_2};

use common::soft::{CUTOFF, DT, Particle, Scene};
use lab11::{LONGEST, Tasks, window_length};
use neighbour_list::Bodies;
use oracle::{Ask, Random, flags, scenes};
use windows::{Strategy, plan};

use super::variant;
use super::whole_runs::counted;

/// Asks for the lengths of windows: sparse and dense, slow and fast, from one step to the maximum.
pub(crate) fn lengths(random: &mut Random, ask: &mut impl Ask) {
    for case in 0..3000 {
        let mut density = random.magnitude(1e-6, 1e12);
        // A speed for which a window has this number of steps.
        let integer = 1.0 + random.below(49) as f64;
        let steps = [random.magnitude(1e-3, 1e3), random.between(1.0, 50.0), integer][case % 3];
        let mut speed = 0.14 / (steps * 2.0 * CUTOFF * SQRT_2 * DT * density);
        match case % 40 {
            0 => speed = 0.0,
            20 => density = 0.0,
            _ => {}
        }
        let question = format!(
            "{density:?} particles per unit area and a mean speed of {speed:?}: number of steps in a window"
        );
        let found = || vec![f64::from(window_length(density, speed))];
        ask.judge(&question, found, |found| right_length(found, density, speed));
    }
}

/// Checks that a window has the correct number of steps. Rounding may decide between two numbers.
fn right_length(found: &[f64], density: f64, speed: f64) -> Result<(), String> {
    let most = 0.14 / (2.0 * CUTOFF * SQRT_2 * speed * DT * density);
    let length = |steps: f64| steps.floor().clamp(1.0, f64::from(LONGEST));
    let right = [1.0 - 1e-12, 1.0 + 1e-12].map(|rounding| length(most * rounding));
    if right.iter().any(|right| found == [*right]) {
        return Ok(());
    }
    Err(format!("     found: {found:?}\n  expected: {}", right[0]))
}

/// Asks about particles three cutoffs apart. Their cells contain no other particles, and yet they
/// meet soon.
pub(crate) fn a_crystal(_: &mut Random, ask: &mut impl Ask) {
    let mut crystal = Bodies::default();
    for id in 0..2500 {
        let [x, y] = [id % 50, id / 50].map(|place| 3.0 * CUTOFF * f64::from(1 + place));
        crystal.push(Particle { x, y, vx: 1.0, vy: 0.0, id });
    }
    let question = "particles in a crystal, one on each nine square cutoffs: number of neighbours within the cutoff \
                    that the planner expects for a particle";
    let found = || vec![plan::<Tasks>(&crystal, 0, 1).neighbours];
    ask.judge(question, found, |found| match found {
        [neighbours] if (neighbours - PI / 9.0).abs() < 0.05 * PI / 9.0 => Ok(()),
        _ => Err(format!("     found: {found:?}\n  expected: {:.3}", PI / 9.0)),
    });
}

pub(crate) fn a_fast_particle(_: &mut Random, ask: &mut impl Ask) {
    let official = Scene::official(2000, 1).expect("the scene is valid");
    let mut bodies = Bodies::of(&official);
    bodies.x.iter_mut().chain(&mut bodies.y).for_each(|x| *x *= 4.0);
    let question = "(1) a nearly empty box, (2) the same box with one particle that crosses it within a window: for \
                    each box, 1 if the planner chooses windows, 0 if it chooses a list";
    let found = || {
        let empty = opens_windows(&bodies);
        bodies.vx[7] = 1000.0;
        flags(&[empty, opens_windows(&bodies)])
    };
    ask.exact(question, found, || vec![1.0, 0.0]);
}

fn opens_windows(bodies: &Bodies) -> bool {
    plan::<Tasks>(bodies, 0, 1).strategy != Strategy::List
}

/// Asks about 3,999 particles: two threads would have fewer than 2,000 particles each.
pub(crate) fn threads_that_pay(_: &mut Random, ask: &mut impl Ask) {
    for (n, threads) in [(3999, 8), (4000, 8), (10_000, 3)] {
        let question = format!("{n} particles, {threads} threads: number of threads that work");
        let found = || {
            variant("11.6", "planned").threads(threads).run(move |engine| {
                engine.load(&Scene::official(n, 1).expect("the scene is valid"));
                let plan = engine.plan().expect("the engine has a planner");
                let working = plan.split_whitespace().nth(1).expect("the plan is threads: 1 of 8");
                vec![working.parse().expect("a number of threads")]
            })
        };
        ask.exact(&question, found, || vec![(n as usize / 2000).clamp(1, threads) as f64]);
    }
}

/// Checks that all particles move at each step if the planner chooses a list.
pub(crate) fn steps_on_a_list(ask: &mut impl Ask) {
    let touched = "particles touched per particle and step";
    let question = format!("variant planned, official scene, 600 steps: {touched}");
    let runs = variant("11.6", "planned");
    let found = || vec![counted(&runs, touched, &scenes::official(), 600)];
    ask.exact(&question, found, || vec![1.0]);
}
