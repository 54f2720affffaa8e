//! What is asked about lab 13.

use common::soft::CUTOFF;
use lab13::{VARIANTS, exchange_positions};
use mpi::Rank;
use mpi::traits::*;

use self::ranks::tell_all;
use self::soft::Engine;
use crate::{Answers, Random, weighed};

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
        "13.4" => exchanges(random, answers),
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

/// In rows of ranks: nothing, a few, and more than the library keeps aside for ranks that send before
/// they receive. Rank 0 lets rank 1 begin only when its inner particles move, and they move until rank 1 has its positions.
fn exchanges(random: &mut Random, answers: &mut Answers) {
    ranks::each(&[1, 2, 3, 4], |world| {
        let (rank, ranks) = (world.rank(), world.size());
        for (round, most) in [0, 7, 1000, 200_000].into_iter().enumerate() {
            let lengths: Vec<usize> = (0..2 * ranks).map(|_| random.below(most + 1)).collect();
            let beside: Vec<Rank> = [rank - 1, rank + 1]
                .into_iter()
                .filter(|other| (0..ranks).contains(other))
                .collect();
            // Upwards and downwards from a rank.
            let length = |from: Rank, to: Rank| lengths[2 * from as usize + usize::from(to > from)];
            let letter = |from: Rank, to: Rank| -> Vec<f64> {
                (0..length(from, to)).map(|k| f64::from(10 * from + to) + k as f64).collect()
            };
            let sent: Vec<_> = beside.iter().map(|to| letter(rank, *to)).collect();
            let mut received: Vec<_> =
                beside.iter().map(|from| vec![0.0; length(*from, rank)]).collect();
            let token = round == 1 && ranks == 2;
            if token && rank == 1 {
                let _: (i32, _) = world.process_at_rank(0).receive_with_tag(7);
            }
            let mut worked = 0.0;
            exchange_positions(world, &beside, &sent, &mut received, || {
                worked += 1.0;
                if token && rank == 0 {
                    world.process_at_rank(1).send_with_tag(&1, 7);
                    let _: (i32, _) = world.process_at_rank(1).receive_with_tag(8);
                }
            });
            if token && rank == 1 {
                world.process_at_rank(0).send_with_tag(&1, 8);
            }
            let mut told = vec![worked];
            for positions in &received {
                told.extend([positions.len() as f64, weighed(positions.iter().copied())]);
            }
            told.resize(5, 0.0);
            let question = format!(
                "{ranks} ranks, lists of up to {most}: for each rank how often it worked, numbers \
                 received and their weighed sum"
            );
            tell_all(world, answers, &question, &told);
        }
    });
}

/// First what the ranks say to expired lists, then whole steps, which take all other tasks.
fn steps(random: &mut Random, answers: &mut Answers) {
    ranks::each(&[1, 2, 4], |world| {
        let (rank, ranks) = (world.rank() as usize, world.size() as usize);
        questions::renewals(world, random, &mut |question, found, _| {
            tell_all(world, answers, question, &found);
        });
        let dense = soft::spread(random, 200, 12.5 * CUTOFF, 1.0);
        let crowd = soft::crowd(random, 250, 12.5 * CUTOFF, 1.0);
        for (variant, threads) in [("strips", 1), ("strips-threads", 2)] {
            let mut engine = Engine::new(VARIANTS, variant, threads, &[]);
            for (name, scene, steps) in [("200 in 12.5 cutoffs", &dense, 6), ("250", &crowd, 1)] {
                let run = engine.run(scene, steps);
                if rank == 0 {
                    answers.steps(&format!("{variant} on {ranks} ranks, {name}"), &run);
                }
            }
        }
    });
}

/// First how many steps are right, by one rank and by all, then whole steps, which take tasks 13.2, 13.5 and
/// 13.7.
fn epochs(random: &mut Random, answers: &mut Answers) {
    ranks::each(&[1, 2, 4], |world| {
        let (rank, ranks) = (world.rank() as usize, world.size() as usize);
        questions::rights(random, &mut |question, found, _| {
            tell_all(world, answers, question, &found);
        });
        questions::confirmations(world, random, &mut |question, found, _| {
            tell_all(world, answers, question, &found);
        });
        let dense = soft::spread(random, 200, 12.5 * CUTOFF, 1.0);
        let mut engine = Engine::new(VARIANTS, "strips-deep", 1, &[]);
        let run = engine.run(&dense, 8);
        if rank == 0 {
            answers.steps(&format!("strips-deep on {ranks} ranks, 200 in 12.5 cutoffs"), &run);
        }
    });
}
