//! What is asked about lab 6.

use lab6::VARIANTS;
use mpi::traits::*;
use solution2::BIN_SIZE;

use self::ranks::on_all;
use self::soft::{Engine, on_edges};
use crate::{Answers, Random};

#[path = "../oracle/src/ask.rs"]
mod ask;
#[path = "../lab6/messages.rs"]
mod messages;
#[path = "../lab6/questions.rs"]
mod questions;
#[path = "ranks.rs"]
mod ranks;
#[path = "soft.rs"]
mod soft;

/// Asks everything about a task.
pub fn ask(task: &str, random: &mut Random, answers: &mut Answers) {
    match task {
        "6.1" => questions::balance(random, &mut answers.told()),
        "6.2" => questions::neighbours(random, &mut answers.told()),
        "6.3" => ranks::each(&ranks::counts(random), |world| {
            messages::beside(world, random, &mut on_all(world, answers));
        }),
        "6.4" => ranks::each(&ranks::counts(random), |world| {
            messages::all(world, random, &mut on_all(world, answers));
        }),
        "6.5" => questions::interiors(&mut answers.told()),
        "6.6" => questions::leavers(random, &mut answers.told()),
        "6.7" => steps(random, answers),
        _ => panic!("there is no task {task}"),
    }
}

/// Boxes whose rows of bins of one cutoff make even blocks, evenly filled: no block is empty, and even
/// blocks are good ones. That takes 6.3 to 6.6 as well.
fn steps(random: &mut Random, answers: &mut Answers) {
    ranks::each(&ranks::counts(random), |world| {
        let (rank, ranks) = (world.rank(), world.size());
        let side = ranks::even_side(random, ranks as usize);
        let [n, many] = [0; 2].map(|_| 200 + random.below(200));
        let dense = soft::spread(random, n, side, 1.0);
        let crowd = soft::crowd(random, many, side, 1.0);
        let steps = 3 + random.below(4);
        if rank == 0 {
            questions::shares(random, &mut answers.told());
        }
        for (variant, threads) in [("halo", 1), ("hybrid", 2 + random.below(2))] {
            let mut engine = Engine::new(VARIANTS, variant, threads, &[(BIN_SIZE, 1.0)]);
            for (name, scene, steps) in [("some", &dense, steps), ("a crowd", &crowd, 1)] {
                let run = engine.run(scene, steps);
                if rank == 0 {
                    let question = format!("{variant} on {ranks} ranks, {name}, {steps} steps");
                    answers.bits(&question, &run);
                }
            }
        }
    });
}
