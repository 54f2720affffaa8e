//! What is asked about lab 10: each decision of the engine by itself, and whole steps.

use lab10::VARIANTS;

use self::soft::Engine;
use crate::{Answers, Random};

#[path = "../oracle/src/ask.rs"]
mod ask;
#[path = "../lab10/questions.rs"]
mod questions;
#[path = "soft.rs"]
mod soft;

/// Asks everything about a task.
pub fn ask(task: &str, random: &mut Random, answers: &mut Answers) {
    match task {
        "10.1" => {
            questions::moves(random, &mut answers.told());
            questions::walls(random, &mut answers.told());
        }
        "10.2" => {
            questions::lists(random, &mut answers.told());
            questions::reaches(random, &mut answers.told());
        }
        "10.3" => {
            questions::expiry(random, &mut answers.told());
            questions::skins(random, &mut answers.told());
        }
        "10.4" => questions::near(random, &mut answers.told()),
        "10.5" => {
            questions::outer_lists(random, &mut answers.told());
            questions::inner_lists(random, &mut answers.told());
            questions::margins(random, &mut answers.told());
            questions::chosen_skins(random, &mut answers.told());
        }
        "10.6" => {
            questions::accelerations(random, &mut answers.told());
            runs(&[], random, answers);
            runs(&[("inner", 0.0)], random, answers);
            counts(random, answers);
        }
        _ => panic!("there is no task {task}"),
    }
}

/// Whole steps in a crowd, in a box with few neighbours, and of pairs over edges of cells.
fn runs(parameters: &[(&str, f64)], random: &mut Random, answers: &mut Answers) {
    let mut engine = Engine::new(VARIANTS, "serial-list", 1, parameters);
    let (n, size) = (200 + random.below(200), random.between(0.12, 0.17));
    let scenes = [
        soft::spread(random, n, size, 1.0),
        soft::spread(random, n, 1.0, 3.0),
        soft::pairs_over_edges(random),
        soft::heap(random),
    ];
    for (k, scene) in scenes.iter().enumerate() {
        let steps = 15 + random.below(30);
        let question = format!("scene {k} with {} particles, {steps} steps", scene.len());
        answers.steps(&question, &engine.run(scene, steps));
    }
}

/// How long lists last, and how many pairs are looked at.
fn counts(random: &mut Random, answers: &mut Answers) {
    use common::soft::{NoStatistics, Simulation};
    let mut engine = lab10::Engine::<NoStatistics>::new(0.0, true);
    let n = 1500 + random.below(1000);
    engine.load(&soft::spread(random, n, (0.0005 * n as f64).sqrt(), 1.0));
    let steps = 100 + random.below(40);
    engine.run(steps as u64);
    for (name, count) in engine.counters() {
        answers.close(&format!("serial-list, {n} particles, {steps} steps: {name}"), &[count]);
    }
}
