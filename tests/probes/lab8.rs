//! What is asked about lab 8: master and workers. The ranks without a master are in
//! `lab8_strips.rs`.

use common::Variant;
use common::hard::{Scene, Simulation};
use hard_disc_ranks::{DiscWire, Team};
use lab8::{VARIANTS, collect, hand_out};
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;
use solution7::Hit;

use self::given::collected_from_above;
use self::hard::state;
use self::ranks::tell_all;
use crate::{Answers, Random, truth, weighed};

#[path = "../oracle/src/ask.rs"]
mod ask;
#[path = "../lab8/given.rs"]
mod given;
#[path = "hard.rs"]
mod hard;
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
        "8.4" => handed_out(random, answers),
        "8.5" => collected(random, answers),
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

/// A list of discs for each rank: nothing, a few, or more than the library keeps aside.
fn lists(random: &mut Random, ranks: usize, most: usize) -> Vec<Vec<DiscWire>> {
    let disc = |number: u64, random: &mut Random| DiscWire {
        x: random.between(0.0, 1.0),
        number,
        ..DiscWire::default()
    };
    (0..ranks)
        .map(|_| (0..(1 + random.below(4)) * most / 4).map(|k| disc(k as u64, random)).collect())
        .collect()
}

/// A list as its length and a few numbers that depend on its order.
fn digest(list: &[DiscWire]) -> [f64; 3] {
    [
        list.len() as f64,
        weighed(list.iter().map(|d| d.x)),
        list.iter().map(|d| d.number as f64).sum(),
    ]
}

fn handed_out(random: &mut Random, answers: &mut Answers) {
    ranks::each(&[1, 2, 4], |world| {
        let (rank, ranks) = (world.rank(), world.size() as usize);
        for (master_works, most) in
            [(false, 0), (false, 5), (true, 5), (false, 30_000), (true, 30_000)]
        {
            let team = Team::new(ranks, master_works);
            let lists = lists(random, team.workers, most);
            let found = hand_out(world, team, if rank == 0 { &lists } else { &[] });
            let question = format!(
                "{ranks} ranks, lists of up to {most}, {} working: number, sum and numbers of what \
                 each rank got",
                if master_works { "the master" } else { "the master not" }
            );
            tell_all(world, answers, &question, &digest(&found));
        }
    });
}

fn collected(random: &mut Random, answers: &mut Answers) {
    ranks::each(&[1, 2, 4], |world| {
        let (rank, ranks) = (world.rank(), world.size() as usize);
        for (round, (master_works, most)) in
            [(true, 0), (false, 5), (true, 5), (false, 5), (true, 30_000)].into_iter().enumerate()
        {
            let team = Team::new(ranks, master_works);
            let lists = lists(random, ranks, most);
            let own = if team.worker(rank).is_some() { &lists[rank as usize][..] } else { &[] };
            let found = match most {
                5 => collected_from_above(world, team, own),
                _ => collect(world, team, own),
            };
            if rank == 0 {
                let question = format!(
                    "{ranks} ranks, round {round}: number, sum and numbers of what the master has, \
                     in the order of workers"
                );
                answers.exact(&question, &digest(&found));
            } else {
                assert!(found.is_empty(), "rank {rank} is no master and collected something");
            }
        }
    });
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
                        "{name} {parameters:?} on {} ranks, {scene_name}, step {step}: x y vx vy and \
                         collisions of disc {number}",
                        world.size()
                    );
                    answers.exact(&question, &state(disc));
                }
            }
        }
    }
}

/// Whole steps, which take all tasks before this one.
fn steps(random: &mut Random, answers: &mut Answers) {
    ranks::each(&[1, 2, 4], |world| {
        let scenes = [("60 discs", discs(random, 60, 0.4)), ("90 discs", discs(random, 90, 0.2))];
        tell_run(world, answers, "master-workers", &[], &scenes);
        tell_run(world, answers, "master-workers", &[("master-works", 1.0)], &scenes[..1]);
        tell_run(world, answers, "master-workers", &[("keep", 0.0)], &scenes[..1]);
        tell_traffic(world, answers, &scenes[0].1);
    });
}

/// Whether messages are counted in steps after the first, the only one in which the pairs are dealt.
fn tell_traffic(world: &SimpleCommunicator, answers: &mut Answers, scene: &Scene) {
    let variant = VARIANTS.iter().find(|v| v.name == "master-workers").expect("the lab has it");
    let mut simulation = (variant.build)(&variant.config()).expect("the variant can be built");
    simulation.load(scene);
    (0..3).for_each(|_| simulation.step());
    let counters = simulation.counters();
    let bytes = counters.iter().find(|c| c.0 == "bytes per step, busiest rank");
    if world.rank() == 0 {
        let some = truth(bytes.is_some_and(|bytes| bytes.1 > 0.0));
        let question = format!("{} ranks: whether bytes travel after the first step", world.size());
        answers.exact(&question, &[some]);
    }
}
