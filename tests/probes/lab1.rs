//! What is asked about lab 1.

use common::soft::Scene;
use lab1::VARIANTS;

use self::model::{Model, acceleration_of_pair, fold, potential_of_pair};
use self::soft::{Count, crowd as anywhere};
use crate::{Answers, Random};

#[path = "../oracle/src/ask.rs"]
mod ask;
#[path = "../oracle/src/model.rs"]
mod model;
#[path = "../lab1/questions.rs"]
mod questions;
#[path = "soft.rs"]
mod soft;

/// Asks everything about a task.
pub fn ask(task: &str, random: &mut Random, answers: &mut Answers) {
    match task {
        "1.1" => questions::forces(random, &mut answers.told()),
        "1.2" => questions::bounces(random, &mut answers.told()),
        "1.3" => {
            runs(random, answers);
            questions::steps(random, &mut answers.told());
        }
        "1.4" => questions::tallies(random, &mut answers.told()),
        "1.5" => {
            questions::potentials(random, &mut answers.told());
            questions::energies(random, &mut answers.told());
        }
        _ => panic!("there is no task {task}"),
    }
}

/// Longer runs, of many particles that are mostly alone and of a few fast ones.
fn runs(random: &mut Random, answers: &mut Answers) {
    let mut engine = soft::Engine::new(VARIANTS, "all-pairs", 1, &[]);
    // First: memory that other scenes gave back would hide what is kept.
    engine.memory(answers);
    let mut ask = |name: &str, scene: &Scene, steps| {
        let question = format!("{name}: {} particles, number of steps {steps}", scene.len());
        answers.bits(&question, &engine.run(scene, steps));
    };
    for _ in 0..3 {
        ask("a heap", &soft::heap(random), 1 + random.below(3));
        let n = 5 + random.below(40);
        ask("fast ones", &soft::spread(random, n, 0.05, 300.0), 2 + random.below(3));
    }
    let n = 600 + random.below(800);
    ask("a wide box", &soft::spread(random, n, 0.7, 1.0), 60 + random.below(80));
    engine.memory(answers);
}
