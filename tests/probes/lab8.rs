//! What is asked about lab 8: master and workers. The ranks without a master are in
//! `lab8_strips.rs`.

use common::Variant;
use common::hard::{Scene, Simulation};
use lab8::VARIANTS;
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;
use solution7::Hit;

use self::hard::state;
use self::ranks::on_all;
use crate::{Answers, Random};

#[path = "../oracle/src/ask.rs"]
mod ask;
#[path = "../lab8/given.rs"]
mod given;
#[path = "hard.rs"]
mod hard;
#[path = "../lab8/messages.rs"]
mod messages;
#[path = "../lab8/questions.rs"]
mod questions;
#[path = "ranks.rs"]
mod ranks;
#[path = "lab8_strips.rs"]
mod strips;

/// Asks everything about a task.
pub fn ask(task: &str, random: &mut Random, answers: &mut Answers) {
    match task {
        "8.1" => questions::blocks(random, &mut answers.told()),
        "8.2" => questions::dealt(random, &mut answers.told()),
        "8.3" => questions::searches(random, &mut answers.told()),
        "8.4" => ranks::each(&ranks::counts(random), |world| {
            messages::handed_out(world, random, &mut on_all(world, answers));
        }),
        "8.5" => ranks::each(&ranks::counts(random), |world| {
            messages::collected(world, random, &mut on_all(world, answers));
        }),
        "8.6" => {
            questions::told_discs(random, &mut answers.told());
            questions::updates(random, &mut answers.told());
        }
        "8.7" => steps(random, answers),
        "8.8" => questions::reaches(random, &mut answers.told()),
        "8.9" => questions::ghosts(random, &mut answers.told()),
        "8.10" => questions::certain(random, &mut answers.told()),
        "8.11" => questions::news(random, &mut answers.told()),
        "8.12" => questions::moves(random, &mut answers.told()),
        "8.13" => strips::steps(random, answers),
        _ => panic!("there is no task {task}"),
    }
}

/// `n` discs that fly up to 3, on so much of the square.
fn discs(random: &mut Random, n: u64, fraction: f64) -> Scene {
    hard::crowd(random, n, fraction, [0.5, 3.0])
}

/// Runs a variant on all ranks and tells every disc after some of the steps.
fn tell_run(
    world: &SimpleCommunicator,
    answers: &mut Answers,
    name: &str,
    parameters: &[(&str, f64)],
    scenes: &[(&str, Scene)],
) {
    let variant: &Variant<dyn Simulation> =
        VARIANTS.iter().find(|v| v.name == name).expect("the lab has the variant");
    let mut config = variant.config();
    for (parameter, value) in parameters {
        variant.set(&mut config, parameter, *value).expect("the variant has the parameter");
    }
    let mut simulation = (variant.build)(&config).expect("the variant can be built");
    for (scene_name, scene) in scenes {
        simulation.load(scene);
        for step in 1..=6 {
            simulation.step();
            if step % 2 == 0 {
                let mut discs = scene.discs().to_vec();
                simulation.read(0, &mut discs);
                for (number, disc) in discs.iter().enumerate().filter(|_| world.rank() == 0) {
                    let question = format!(
                        "{name} {parameters:?} on {} ranks, {scene_name}, {} discs, step {step}: x y vx vy and \
                         collisions of disc {number}",
                        world.size(),
                        scene.len()
                    );
                    answers.exact(&question, &state(disc));
                }
            }
        }
    }
}

/// Whole steps, which take all tasks before this one.
fn steps(random: &mut Random, answers: &mut Answers) {
    ranks::each(&ranks::counts(random), |world| {
        let [some, more] = [0; 2].map(|_| 40 + random.below(60) as u64);
        let scenes = [("dense", discs(random, some, 0.4)), ("thin", discs(random, more, 0.2))];
        tell_run(world, answers, "master-workers", &[], &scenes);
        tell_run(world, answers, "master-workers", &[("master-works", 1.0)], &scenes[..1]);
        tell_run(world, answers, "master-workers", &[("keep", 0.0)], &scenes[..1]);
        messages::quiet_steps(world, &mut on_all(world, answers));
        messages::shares(world, random, "master-workers", &mut on_all(world, answers));
        messages::long_run(world, "master-workers", &mut on_all(world, answers));
    });
}
