//! What is asked about lab 13.

use common::soft::CUTOFF;
use lab13::VARIANTS;
use mpi::traits::*;

use self::ranks::on_all;
use self::soft::Engine;
use crate::{Answers, Random};

#[path = "../oracle/src/ask.rs"]
mod ask;
#[path = "../lab13/questions.rs"]
mod questions;
#[path = "ranks.rs"]
mod ranks;
#[path = "soft.rs"]
mod soft;

/// Asks everything about a task.
pub fn ask(task: &str, random: &mut Random, answers: &mut Answers) {
    match task {
        "13.1" => {
            questions::widths(random, &mut answers.told(), false);
            questions::lasting(random, &mut answers.told());
        }
        "13.2" => questions::neighbours(random, &mut answers.told()),
        "13.3" => {
            questions::ghosts(random, &mut answers.told());
            questions::across(random, &mut answers.told());
        }
        "13.4" => ranks::each(&ranks::counts(random), |world| {
            questions::exchanges(world, random, &mut on_all(world, answers));
        }),
        "13.5" => questions::loads(random, &mut answers.told()),
        "13.6" => steps(random, answers),
        "13.7" => {
            questions::widths(random, &mut answers.told(), true);
            questions::depths(random, &mut answers.told());
        }
        "13.8" => epochs(random, answers),
        _ => panic!("there is no task {task}"),
    }
}

/// First what the ranks say to expired lists, then whole steps, which take all other tasks.
fn steps(random: &mut Random, answers: &mut Answers) {
    ranks::each(&ranks::counts(random), |world| {
        let (rank, ranks) = (world.rank() as usize, world.size() as usize);
        questions::renewals(world, random, &mut on_all(world, answers));
        let [n, many] = [0; 2].map(|_| 150 + random.below(120));
        let dense = soft::spread(random, n, 12.5 * CUTOFF, 1.0);
        let crowd = soft::crowd(random, many, 12.5 * CUTOFF, 1.0);
        let all = [("some", &dense, 4 + random.below(5)), ("a crowd", &crowd, 1)];
        for (variant, threads) in [("strips", 1), ("strips-threads", 2)] {
            let mut engine = Engine::new(VARIANTS, variant, threads, &[]);
            for (name, scene, steps) in all {
                let run = engine.run(scene, steps);
                if rank == 0 {
                    let question = format!("{variant} on {ranks} ranks, {name}, {steps} steps");
                    answers.steps(&question, &run);
                }
            }
        }
    });
}

/// First how many steps are right, by one rank and by all, then whole steps, which take tasks 13.2, 13.5 and
/// 13.7.
fn epochs(random: &mut Random, answers: &mut Answers) {
    ranks::each(&ranks::counts(random), |world| {
        let (rank, ranks) = (world.rank() as usize, world.size() as usize);
        questions::rights(random, &mut on_all(world, answers));
        questions::confirmations(world, random, &mut on_all(world, answers));
        let (n, steps) = (150 + random.below(100), 6 + random.below(6));
        let dense = soft::spread(random, n, 12.5 * CUTOFF, 1.0);
        let mut engine = Engine::new(VARIANTS, "strips-deep", 1, &[]);
        let run = engine.run(&dense, steps);
        if rank == 0 {
            answers.steps(
                &format!("strips-deep on {ranks} ranks, {n} particles, {steps} steps"),
                &run,
            );
        }
    });
}
