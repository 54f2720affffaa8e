//! Questions about whole runs: their deviations from the exact motion, and their orders of
//! convergence.

use common::soft::{CUTOFF, DT, Particle, Scene};
use integrators::Watched;
use lab12::first_fall;
use oracle::reference::{Fineness, exact};
use oracle::{Ask, Random};

use super::{farthest, variant};

/// Calls task 12.4, so that an unsolved starter stops at the `todo!` of task 12.4.
pub(crate) fn starts_with_the_fall() {
    let falling = Watched { value: 0.0, slope: -1.0 };
    first_fall(falling, falling, 1.0, &mut |_| falling);
}

/// Returns two particles, 0.8 cutoffs apart, that approach so slowly that they stay in contact
/// through an official step.
pub(crate) fn in_contact() -> Scene {
    let at = |side: f64| Particle {
        x: 0.05 + 0.4 * side * CUTOFF,
        y: 0.05,
        vx: -0.05 * side,
        ..Particle::default()
    };
    Scene::new(0.1, vec![at(-1.0), at(1.0)]).expect("the scene is valid")
}

/// Returns the particles after `steps` official steps of a variant, each divided into `parts`
/// parts.
pub(crate) fn end_of(name: &str, parts: f64, scene: &Scene, steps: usize) -> Vec<Particle> {
    let task = match name {
        "rk4" => "12.2",
        "rk4-located" => "12.4",
        _ => "12.1",
    };
    let scene = scene.clone();
    variant(task, name).set("divide", parts).run(move |engine| {
        engine.load(&scene);
        (0..steps).for_each(|_| engine.step());
        let mut end = vec![Particle::default(); scene.len()];
        engine.read(0, &mut end);
        end
    })
}

/// Returns x and y of each particle.
fn positions(particles: &[Particle]) -> Vec<f64> {
    particles.iter().flat_map(|p| [p.x, p.y]).collect()
}

/// Returns the deviation of each of several runs from the exact motion after `steps` official
/// steps. Each run answers with the positions of all particles.
fn errors(found: &[f64], scene: &Scene, steps: u32) -> Result<Vec<f64>, String> {
    let right = exact(scene, f64::from(steps) * DT, Fineness::FINE)?;
    let runs = found.chunks(2 * scene.len());
    let error = |run: &[f64]| {
        let (places, _) = run.as_chunks();
        let end: Vec<Particle> =
            places.iter().map(|&[x, y]| Particle { x, y, ..Particle::default() }).collect();
        farthest(&end, &right)
    };
    Ok(runs.map(error).collect())
}

fn order_in_contact(ask: &mut impl Ask, name: &str, order: f64) {
    let scene = in_contact();
    let question = format!(
        "variant {name}, two particles in contact: x and y of each particle (1) after an official step in 4 parts, \
         (2) after an official step in 8 parts"
    );
    let end = |parts| positions(&end_of(name, parts, &scene, 1));
    ask.judge(
        &question,
        || [end(4.0), end(8.0)].concat(),
        |found| {
            let [four, eight] = errors(found, &scene, 1)?[..] else {
                return Err("the runs are not complete".into());
            };
            let found = (four / eight).log2();
            if (order - 0.4..order + 0.8).contains(&found) {
                return Ok(());
            }
            Err(format!(
                "the errors {four:e} and {eight:e} are of order {found:.2}, but must be of order {order}"
            ))
        },
    );
}

pub(crate) fn orders(_: &mut Random, ask: &mut impl Ask) {
    order_in_contact(ask, "velocity-verlet", 2.0);
    order_in_contact(ask, "pefrl", 4.0);
}

pub(crate) fn order(_: &mut Random, ask: &mut impl Ask) {
    order_in_contact(ask, "rk4", 4.0);
}

/// Asks about two particles that come together from outside the cutoff, one of them after a
/// reflection. An event that is not located reduces the order of convergence.
pub(crate) fn across_the_cutoff(_: &mut Random, ask: &mut impl Ask) {
    starts_with_the_fall();
    let particles = vec![
        Particle { x: 0.05, y: 0.0003, vx: 0.9, vy: -0.4, id: 0 },
        Particle { x: 0.0612, y: 0.0011, vx: -1.1, vy: 0.1, id: 1 },
    ];
    let scene = Scene::new(0.1, particles).expect("the scene is valid");
    let question = "two particles that come into reach, one of them after a collision with a wall: x and y of each \
                    particle after 16 official steps, (1) with rk4-located in 1 part, (2) with rk4-located in 8 \
                    parts, (3) with rk4 in 8 parts";
    let runs = [("rk4-located", 1.0), ("rk4-located", 8.0), ("rk4", 8.0)];
    let found = || runs.iter().flat_map(|run| positions(&end_of(run.0, run.1, &scene, 16)));
    ask.judge(question, || found().collect(), |found| {
        let [coarse, fine, plain] = errors(found, &scene, 16)?[..] else {
            return Err("the runs are not complete".into());
        };
        let order = (coarse / fine).log2() / 3.0;
        if order.is_nan() || order <= 3.4 {
            return Err(format!("the errors {coarse:e} and {fine:e} are of order {order:.2}, but must be of order 4"));
        }
        if fine >= 0.05 * plain {
            return Err(format!(
                "the error is {fine:e}, but must be far smaller than {plain:e}, the error of rk4 without located \
                 events"));
        }
        Ok(())
    });
}

pub(crate) fn exact_motion(_: &mut Random, ask: &mut impl Ask) {
    starts_with_the_fall();
    let scene = Scene::official(300, 4).expect("the scene is valid");
    let question = "300 particles, seed 4: x and y of each particle after 100 official steps of rk4-located, (1) in \
                    10 parts, (2) in 40 parts";
    let found = || [10.0, 40.0].map(|parts| positions(&end_of("rk4-located", parts, &scene, 100)));
    ask.judge(
        question,
        || found().concat(),
        |found| {
            let [coarse, fine] = errors(found, &scene, 100)?[..] else {
                return Err("the runs are not complete".into());
            };
            if fine >= 5e-9 || fine.is_nan() {
                return Err(format!(
                    "in 40 parts, a particle is {fine:e} away from its position in the exact motion"
                ));
            }
            if fine >= 0.01 * coarse {
                return Err(format!(
                    "with steps that are four times shorter, the error is {fine:e} instead of {coarse:e}: it must \
                     shrink to less than a hundredth"
                ));
            }
            Ok(())
        },
    );
}
