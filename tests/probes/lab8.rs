//! What is asked about lab 8: master and workers. The ranks without a master are in
//! `lab8_strips.rs`.

use common::Variant;
use common::hard::{Disc, Scene, Simulation};
use hard_disc_ranks::{Deal, DiscWire, Job, Part, Team};
use lab8::{VARIANTS, collect, collided, hand_out, jobs, offsets, search_job, update};
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;
use solution5::Cut;
use solution7::{Candidate, Hit};

use self::given::{OFFSETS, collected_from_above};
use self::hard::{state, values};
use self::ranks::tell_all;
use crate::{Answers, Random, truth, weighed};

#[path = "../lab8/given.rs"]
mod given;
#[path = "hard.rs"]
mod hard;
#[path = "ranks.rs"]
mod ranks;
#[path = "lab8_strips.rs"]
mod strips;

/// Asks everything about a task.
pub fn ask(task: &str, random: &mut Random, answers: &mut Answers) {
    match task {
        "8.1" => blocks(answers),
        "8.2" => dealt(answers),
        "8.3" => searches(random, answers),
        "8.4" => handed_out(random, answers),
        "8.5" => collected(random, answers),
        "8.6" => extras(random, answers),
        "8.7" => steps(random, answers),
        "8.8" => strips::reaches(random, answers),
        "8.9" => strips::ghosts(random, answers),
        "8.10" => strips::certain(random, answers),
        "8.11" => strips::news(random, answers),
        "8.12" => strips::moves(random, answers),
        "8.13" => strips::steps(random, answers),
        _ => panic!("there is no task {task}"),
    }
}

fn numbers(list: impl IntoIterator<Item = usize>) -> Vec<f64> {
    list.into_iter().map(|number| number as f64).collect()
}

fn blocks(answers: &mut Answers) {
    for workers in (1..40).chain([64, 100, 128]) {
        let question = format!("the blocks of worker 0 of {workers}");
        answers.exact(&question, &numbers(offsets(workers)));
    }
}

/// Offsets are given: which they are is another task.
fn dealt(answers: &mut Answers) {
    for (workers, offsets) in OFFSETS {
        let offsets = offsets.to_vec();
        let deal = Deal { workers, offsets };
        for worker in 0..workers {
            let job = |job: &Job| [job.row as f64, job.column as f64, f64::from(job.part as u8)];
            let jobs: Vec<f64> = jobs(&deal, worker).iter().flat_map(job).collect();
            let question = format!(
                "row, column and part (0 whole, 1 first, 2 second) of the jobs of worker {worker} \
                 of {workers}"
            );
            answers.exact(&question, &jobs);
        }
    }
}

/// `n` discs that fly up to 3, on so much of the square.
fn discs(random: &mut Random, n: u64, fraction: f64) -> Scene {
    hard::crowd(random, n, fraction, [0.5, 3.0])
}

fn searches(random: &mut Random, answers: &mut Answers) {
    for round in 0..10 {
        let scene = discs(random, 121, 0.6);
        let blocks = Cut { rows: 121, ranks: 4 };
        for (row, column) in [(0, 0), (3, 3), (0, 3), (1, 2)] {
            for part in [Part::Whole, Part::First, Part::Second] {
                if row == column && part != Part::Whole {
                    continue;
                }
                let mut found = Vec::new();
                let job = Job { row, column, part };
                let tests = search_job(scene.discs(), &blocks, &job, scene.radius(), &mut found);
                found.sort_by_key(|c| c.hit);
                answers.exact(&format!("round {round}, {job:?}: candidates"), &values(&found));
                answers.exact(&format!("round {round}, {job:?}: pairs tested"), &[tests as f64]);
            }
        }
    }
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

fn some_discs(random: &mut Random, n: usize) -> Vec<Disc> {
    let mut number = || random.between(-3.0, 3.0);
    (0..n).map(|_| Disc::new(50.0 + number(), 50.0 + number(), number(), number())).collect()
}

fn extras(random: &mut Random, answers: &mut Answers) {
    for round in 0..40 {
        let all = some_discs(random, 40);
        let blocks = Cut { rows: 40, ranks: 4 };
        // Each disc collides once at most.
        let mut order: Vec<u32> = (0..40).collect();
        random.shuffle(&mut order);
        let pair = |ab: &[u32]| Hit::Pair(ab[0].min(ab[1]), ab[0].max(ab[1]));
        let walls = [Hit::WallX(order[20]), Hit::Corner(order[21]), Hit::WallY(order[22])];
        let hits = order[..20].chunks(2).map(pair).chain(walls);
        let taken: Vec<Candidate> = hits.map(|hit| Candidate { time: 0.5, hit }).collect();
        for held in [&[0, 1][..], &[1, 2], &[3, 0], &[0, 1, 3], &[]] {
            let mut told = collided(&all, &blocks, held, &taken);
            told.sort_by_key(|wire| wire.number);
            let told: Vec<f64> = told.iter().flat_map(|w| [w.number as f64, w.x, w.vy]).collect();
            let question =
                format!("round {round}: number, x, vy of the collided discs of blocks {held:?}");
            answers.exact(&question, &told);
        }
        let arrived: Vec<DiscWire> =
            [4, 27, 29].map(|number| DiscWire::new(number, &some_discs(random, 1)[0])).to_vec();
        for moves in [true, false] {
            let mut held = all.clone();
            update(&mut held, &[0..10, 20..30], moves, &arrived);
            for (number, disc) in held.iter().enumerate() {
                let question = format!(
                    "round {round}, a worker of discs 0 to 9 and 20 to 29, moves: {moves}, disc {number}"
                );
                answers.exact(&question, &state(disc)[..4]);
            }
        }
    }
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
