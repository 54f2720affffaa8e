//! What is asked about lab 2.
//!
//! Each task's own function is asked, in grids whose size is given and with particles that the
//! probe has put where they belong: a mistake in one task costs that task.

use common::soft::{CUTOFF, Scene};
use lab2::{BIN_SIZE, VARIANTS};

use self::model::acceleration_of_pair;
use self::soft::{Count, Engine};
use crate::{Answers, Random};

#[path = "../oracle/src/ask.rs"]
mod ask;
#[path = "../oracle/src/model.rs"]
mod model;
#[path = "../lab2/questions.rs"]
mod questions;
#[path = "soft.rs"]
mod soft;

/// Asks everything about a task.
pub fn ask(task: &str, random: &mut Random, answers: &mut Answers) {
    let mut told = answers.told();
    match task {
        "2.1" => {
            questions::grids(random, &mut told);
            questions::columns(random, &mut told);
        }
        "2.2" => questions::near(random, &mut told),
        "2.3" => questions::refills(random, &mut told),
        "2.4" => questions::nine_bins(random, &mut told),
        "2.5" => questions::leavers(random, &mut told),
        "2.6" => questions::lists(random, &mut told),
        "2.7" => {
            questions::forwards(random, &mut told);
            questions::looks(random, &mut told);
            drop(told);
            every_pair_once(random, answers);
        }
        "2.8" => questions::sorts(random, &mut told),
        "2.9" => {
            questions::sums(random, &mut told);
            drop(told);
            Engine::new(VARIANTS, "sorted", 1, &[]).memory(answers);
        }
        _ => panic!("there is no task {task}"),
    }
}

/// The forces need whole steps. Bins are two and three cutoffs wide: a grid with bins somewhat
/// too narrow still finds every pair.
fn every_pair_once(random: &mut Random, answers: &mut Answers) {
    for bin_size in [2.0, 3.0] {
        let mut engine = Engine::new(VARIANTS, "linked-list", 1, &[(BIN_SIZE, bin_size)]);
        let mut ask = |name: &str, scene: &Scene, steps| {
            let n = scene.len();
            let question = format!(
                "linked-list, bins of {bin_size} cutoffs, {name}: {n} particles, {steps} steps"
            );
            answers.steps(&question, &engine.run(scene, steps));
        };
        let [n, many] = [0; 2].map(|_| 100 + random.below(120));
        ask("10.3 cutoffs", &soft::spread(random, n, 10.3 * CUTOFF, 1.0), 8 + random.below(15));
        ask("a heap", &soft::heap(random), 1 + random.below(3));
        ask("a crowd", &soft::crowd(random, many, 6.9 * CUTOFF, 1.0), 1 + random.below(3));
        ask("pairs over edges", &soft::pairs_over_edges(random), 1);
    }
    let mut engine = Engine::counting(VARIANTS, "linked-list", 1, &[(BIN_SIZE, 2.0)]);
    let n = 200 + random.below(200);
    let scene = soft::spread(random, n, 15.3 * CUTOFF, 1.0);
    for statistics in engine.statistics(&scene, 1) {
        answers.close(&format!("dmin, davg, navg of {n} particles, pairs looked at"), &statistics);
    }
}
