//! What is asked about lab 5.
//!
//! Ranks get blocks of as many rows as each other, except where the cut itself is asked about.

use lab5::VARIANTS;
use mpi::traits::*;
use solution2::BIN_SIZE;

use self::ranks::on_all;
use self::soft::{Engine, on_edges};
use crate::{Answers, Random};

#[path = "../oracle/src/ask.rs"]
mod ask;
#[path = "../lab5/messages.rs"]
mod messages;
#[path = "../lab5/questions.rs"]
mod questions;
#[path = "ranks.rs"]
mod ranks;
#[path = "soft.rs"]
mod soft;

/// Asks everything about a task.
pub fn ask(task: &str, random: &mut Random, answers: &mut Answers) {
    match task {
        "5.1" => questions::cuts(random, &mut answers.told()),
        "5.2" => questions::leavers(random, &mut answers.told()),
        "5.3" => questions::copies(random, &mut answers.told()),
        "5.4" => ranks::each(&ranks::counts(random), |world| {
            messages::gathers(world, random, &mut on_all(world, answers));
        }),
        "5.5" => questions::parcels(random, &mut answers.told()),
        "5.6" => ranks::each(&ranks::counts(random), |world| {
            messages::scatters(world, random, &mut on_all(world, answers));
        }),
        "5.7" => questions::ghosts(random, &mut answers.told()),
        "5.8" => steps(random, answers),
        "5.9" => ranks::each(&ranks::counts(random), |world| {
            messages::sums(world, random, &mut on_all(world, answers));
        }),
        _ => panic!("there is no task {task}"),
    }
}

/// In boxes whose rows of bins of one cutoff make even blocks. All ranks get the scene, and run it: that takes all tasks before this one.
fn steps(random: &mut Random, answers: &mut Answers) {
    ranks::each(&ranks::counts(random), |world| {
        let (rank, ranks) = (world.rank() as usize, world.size() as usize);
        messages::broadcasts(world, random, &mut on_all(world, answers));
        messages::quiet_steps(world, &mut on_all(world, answers));
        let side = ranks::even_side(random, ranks);
        let mut n = || 100 + random.below(200);
        let [many, fast, dense] = [n(), n(), n()];
        let scene = soft::spread(random, many, side, 1.0);
        for (name, scene, steps) in [
            ("some", scene, 5 + random.below(8)),
            ("fast ones", soft::spread(random, fast, side, 60.0), 3),
            ("a crowd", soft::crowd(random, dense, side, 1.0), 2),
        ] {
            let mut engine = Engine::new(VARIANTS, "through-root", 1, &[(BIN_SIZE, 1.0)]);
            let run = engine.run(&scene, steps);
            if rank == 0 {
                let question = format!("through-root on {ranks} ranks, {name}, {steps} steps");
                answers.bits(&question, &run);
            }
        }
    });
}
