//! What is asked about lab 6.

use common_mpi::Ghost;
use lab6::{VARIANTS, exchange_all, exchange_beside, interior_rows};
use mpi::traits::*;
use solution2::BIN_SIZE;

use self::meanwhile::works_meanwhile;
use self::ranks::tell_all;
use self::soft::{Engine, on_edges};
use crate::{Answers, Random, truth, weighed};

#[path = "../lab6/meanwhile.rs"]
mod meanwhile;
#[path = "../lab6/questions.rs"]
mod questions;
#[path = "ranks.rs"]
mod ranks;
#[path = "soft.rs"]
mod soft;

/// Asks everything about a task.
pub fn ask(task: &str, random: &mut Random, answers: &mut Answers) {
    match task {
        "6.1" => questions::balance(random, &mut told(answers)),
        "6.2" => questions::neighbours(random, &mut told(answers)),
        "6.3" => exchanges(random, answers),
        "6.4" => all_to_all(random, answers),
        "6.5" => interiors(random, answers),
        "6.6" => questions::leavers(random, &mut told(answers)),
        "6.7" => steps(random, answers),
        _ => panic!("there is no task {task}"),
    }
}

/// Tells what the lab answers; what is right is the solution's to say.
fn told(answers: &mut Answers) -> impl FnMut(&str, Vec<usize>, Vec<usize>) {
    |question, found, _| {
        let found: Vec<f64> = found.into_iter().map(|number| number as f64).collect();
        answers.exact(question, &found);
    }
}

/// A list as its length and a few numbers that depend on its order.
fn digest(list: &[Ghost]) -> [f64; 3] {
    [list.len() as f64, weighed(list.iter().map(|g| g.x)), list.iter().map(|g| g.id as f64).sum()]
}

fn ghosts(random: &mut Random, n: usize) -> Vec<Ghost> {
    let ghost = |id| Ghost { x: random.between(0.0, 1.0), y: random.between(0.0, 1.0), id };
    (0..n as u64).map(ghost).collect()
}

/// Lists from every rank to every rank: `[from][to]`.
fn letters(random: &mut Random, ranks: usize, n: impl Fn(usize) -> usize) -> Vec<Vec<Vec<Ghost>>> {
    let mut list = || {
        let most = n(random.below(4));
        ghosts(random, most)
    };
    (0..ranks).map(|_| (0..ranks).map(|_| list()).collect()).collect()
}

/// In rows of ranks: nothing, a little, more than a packet, and then more than the library keeps
/// aside for ranks that send before they receive. Some of the lists are empty.
fn exchanges(random: &mut Random, answers: &mut Answers) {
    ranks::each(&ranks::counts(random), |world| {
        let (rank, ranks) = (world.rank() as usize, world.size() as usize);
        for (round, most) in [0, 5, 1000, 60_000].into_iter().enumerate() {
            let letters = letters(random, ranks, |part| most * part / 3);
            let beside = [rank.checked_sub(1), (rank + 1 < ranks).then_some(rank + 1)];
            let mut beside: Vec<usize> = beside.into_iter().flatten().collect();
            if round % 2 == 1 {
                beside.reverse();
            }
            let outgoing: Vec<_> =
                beside.iter().map(|&to| (to as i32, letters[rank][to].clone())).collect();
            let mut worked = 0.0;
            let (incoming, result) = exchange_beside(world, &outgoing, || {
                worked += 1.0;
                42.0
            });
            let mut told = vec![worked, result, incoming.len() as f64];
            told.extend(incoming.iter().flat_map(|list| digest(list)));
            told.resize(9, 0.0);
            let question = format!(
                "{ranks} ranks, lists of up to {most}, round {round}: for each rank how often it \
                 worked and with what result, lists received, number, sum and ids of each"
            );
            tell_all(world, answers, &question, &told);
        }
        if ranks == 2 {
            let question = "for each rank whether rank 0 works while its messages travel";
            tell_all(world, answers, question, &[truth(works_meanwhile(world))]);
        }
    });
}

fn all_to_all(random: &mut Random, answers: &mut Answers) {
    ranks::each(&ranks::counts(random), |world| {
        let (rank, ranks) = (world.rank() as usize, world.size() as usize);
        for (round, most) in [0, 5, 70_000, 5].into_iter().enumerate() {
            let letters = letters(random, ranks, |part| most * part / 4);
            let found = exchange_all(world, &letters[rank]);
            let question = format!(
                "{ranks} ranks, round {round}: number, sum and ids of what each rank got from all"
            );
            tell_all(world, answers, &question, &digest(&found));
        }
    });
}

/// The empty range may be written in several ways, so rows are told one by one.
fn interiors(random: &mut Random, answers: &mut Answers) {
    for rows in (1..8).chain([9 + random.below(20)]) {
        for (start, end) in (0..=rows).flat_map(|start| (start..=rows).map(move |end| (start, end)))
        {
            let interior = interior_rows(&(start..end), rows);
            let inside: Vec<f64> = interior.clone().map(|row| row as f64).collect();
            let question = format!("the interior of rows {start} to {end} of {rows}");
            answers.exact(&question, &inside);
            let part =
                start <= interior.start && interior.start <= interior.end && interior.end <= end;
            let question = format!("whether that lies within {start} to {end}");
            answers.exact(&question, &[truth(part)]);
        }
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
            questions::shares(random, &mut told(answers));
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
