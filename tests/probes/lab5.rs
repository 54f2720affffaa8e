//! What is asked about lab 5.
//!
//! Ranks get blocks of as many rows as each other, except where the cut itself is asked about.

use common::soft::{Particle, Statistics};
use common_mpi::{Wire, calls_made, together};
use lab5::{VARIANTS, broadcast, gather_at_root, reduce, scatter_from_root};
use mpi::traits::*;
use solution2::BIN_SIZE;

use self::ranks::tell_all;
use self::soft::{Engine, on_edges};
use crate::{Answers, Random, weighed};

#[path = "../lab5/questions.rs"]
mod questions;
#[path = "ranks.rs"]
mod ranks;
#[path = "soft.rs"]
mod soft;

/// Asks everything about a task.
pub fn ask(task: &str, random: &mut Random, answers: &mut Answers) {
    match task {
        "5.1" => questions::cuts(random, &mut told(answers)),
        "5.2" => questions::leavers(random, &mut told(answers)),
        "5.3" => questions::copies(random, &mut told(answers)),
        "5.4" => gathers(random, answers),
        "5.5" => questions::parcels(random, &mut told(answers)),
        "5.6" => scatters(random, answers),
        "5.7" => questions::ghosts(random, &mut told(answers)),
        "5.8" => steps(random, answers),
        "5.9" => statistics(random, answers),
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

/// Particles in a box of side 1 with `rows` rows of bins, well inside them.
fn particles(random: &mut Random, rows: usize, n: usize) -> Vec<Particle> {
    let particle = |id| {
        let mut at = || (random.below(rows) as f64 + random.between(0.05, 0.95)) / rows as f64;
        let (x, y) = (at(), at());
        Particle { x, y, vx: random.between(-1.0, 1.0), vy: random.between(-1.0, 1.0), id }
    };
    (0..n as u32).map(particle).collect()
}

/// What a rank has in the rounds of a job: nothing, a little, more than a packet.
fn list(random: &mut Random, most: usize) -> Vec<Wire> {
    let n = random.below(most + 1);
    particles(random, 10, n).iter().map(Wire::from).collect()
}

/// The most items, round by round.
const MOST: [usize; 5] = [0, 5, 40, 70_000, 5];

/// A list as its length and a few numbers that depend on its order.
fn digest(list: &[Wire]) -> [f64; 3] {
    [
        list.len() as f64,
        weighed(list.iter().map(|w| w.x + w.vy)),
        list.iter().map(|w| w.id as f64).sum(),
    ]
}

fn gathers(random: &mut Random, answers: &mut Answers) {
    ranks::each(&ranks::counts(random), |world| {
        let (rank, ranks) = (world.rank() as usize, world.size() as usize);
        for (round, most) in MOST.into_iter().enumerate() {
            let lists: Vec<_> = (0..ranks).map(|_| list(random, most)).collect();
            let found = together("gather_at_root", || gather_at_root(world, &lists[rank]));
            let made = calls_made().iter().filter(|name| name.starts_with("MPI_Gather")).count();
            let question = format!("{ranks} ranks, round {round}: gathers that each rank makes");
            tell_all(world, answers, &question, &[made as f64]);
            if rank == 0 {
                let digests: Vec<f64> = found.iter().flat_map(|list| digest(list)).collect();
                let question = format!(
                    "{ranks} ranks, round {round}: number, sum and ids of the items of each rank"
                );
                answers.exact(&question, &digests);
            } else {
                assert!(found.is_empty(), "rank {rank} is not the root and got something");
            }
        }
    });
}

fn scatters(random: &mut Random, answers: &mut Answers) {
    ranks::each(&ranks::counts(random), |world| {
        let (rank, ranks) = (world.rank() as usize, world.size() as usize);
        for (round, most) in MOST.into_iter().enumerate() {
            let lists: Vec<_> = (0..ranks).map(|_| list(random, most)).collect();
            let found = scatter_from_root(world, if rank == 0 { &lists } else { &[] });
            let question =
                format!("{ranks} ranks, round {round}: number, sum and ids of what each rank got");
            tell_all(world, answers, &question, &digest(&found));
        }
    });
}

/// In boxes whose rows of bins of one cutoff make even blocks. All ranks get the scene, and run it: that takes all tasks before this one.
fn steps(random: &mut Random, answers: &mut Answers) {
    ranks::each(&ranks::counts(random), |world| {
        let (rank, ranks) = (world.rank() as usize, world.size() as usize);
        let large = soft::spread(random, 70_000, 9.0, 0.0);
        let (_, found) = broadcast(world, (rank == 0).then_some(&large));
        let question = format!("{ranks} ranks: particles of a large scene on each");
        tell_all(world, answers, &question, &[found.len() as f64]);
        let side = ranks::even_side(random, ranks);
        let mut n = || 100 + random.below(200);
        let [many, fast, dense] = [n(), n(), n()];
        let scene = soft::spread(random, many, side, 1.0);
        let (size, found) = broadcast(world, (rank == 0).then_some(&scene));
        let wires: Vec<Wire> = found.iter().map(Wire::from).collect();
        let [n, sum, ids] = digest(&wires);
        let question = format!("{ranks} ranks: side, number, sum and ids of the scene on each");
        tell_all(world, answers, &question, &[size, n, sum, ids]);
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

fn statistics(random: &mut Random, answers: &mut Answers) {
    ranks::each(&ranks::counts(random), |world| {
        let (rank, ranks) = (world.rank() as usize, world.size() as usize);
        for round in 0..5 {
            let mut own = || Statistics {
                dmin: random.between(0.2, 1.0),
                davg: random.between(0.0, 100.0),
                navg: random.bits() >> (5 + random.below(58)),
                pair_tests: random.bits() >> (5 + random.below(58)),
            };
            let all: Vec<_> = (0..ranks).map(|_| own()).collect();
            let found = reduce(world, &all[rank]);
            assert_eq!(found.is_some(), rank == 0, "the root alone has the statistics");
            if let Some(found) = found {
                let question =
                    format!("{ranks} ranks, round {round}: dmin, davg, navg, pair tests");
                answers.close(&question, &soft::numbers(found));
            }
        }
    });
}
