//! What tests and probe ask alike about the messages of master and workers, on all ranks.

use std::thread::sleep;
use std::time::Duration;

use common::hard::{Disc, RandomScene, Scene, Simulation};
use common_mpi::{calls_made, together};
use hard_disc_ranks::{DiscWire, Team};
use lab8::{VARIANTS, collect, hand_out};
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;

use super::ask::{Ask, digest, memory, truth};
use crate::Random;

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

/// The discs of a list in a long run.
const LONG: usize = 1000;

fn told(list: &[DiscWire]) -> Vec<f64> {
    digest(list.iter().map(|disc| (disc.x, disc.number)))
}

fn name_of(team: Team, rank: i32, most: usize) -> String {
    let works = if team.master_works { "works too" } else { "does not work" };
    format!("rank {rank} of a master that {works} and its workers, lists of up to {most}")
}

/// What each rank gets of the master's lists, and how many sends the master begins before it waits for one: a
/// worker that is not ready must not keep the others waiting.
pub(super) fn handed_out(world: &SimpleCommunicator, random: &mut Random, ask: Ask<'_>) {
    let (rank, ranks) = (world.rank(), world.size() as usize);
    for (master_works, most) in
        [(false, 0), (false, 5), (true, 5), (false, 264_000), (true, 264_000)]
    {
        let team = Team::new(ranks, master_works);
        let lists = lists(random, team.workers, most);
        let own = if rank == 0 { &lists[..] } else { &[] };
        let found = together("hand_out", || hand_out(world, team, own));
        let made = calls_made();
        let right = team.worker(rank).map_or_else(Vec::new, |worker| lists[worker].clone());
        let name = name_of(team, rank, most);
        let question = format!("{name}: how many items it gets, and two sums of them");
        ask(&question, told(&found), told(&right));
        let begun = made.iter().take_while(|call| !call.starts_with("MPI_Wait"));
        let sends = begun.filter(|call| **call == "MPI_Isend").count();
        let others = if rank == 0 { team.workers - usize::from(team.master_works) } else { 0 };
        let question = format!("{name}: how many sends it begins before it waits for one");
        ask(&question, vec![sends as f64], vec![others as f64]);
    }
    let team = Team::new(ranks, true);
    let lists = vec![vec![DiscWire::default(); LONG]; if rank == 0 { ranks } else { 0 }];
    let turn = |_| {
        together("hand_out", || drop(hand_out(world, team, &lists)));
        world.barrier();
    };
    let size = (50, LONG * size_of::<DiscWire>());
    memory(&name_of(team, rank, LONG), size, |turns| (0..turns).for_each(turn), ask);
}

/// What the master has of the workers' lists, in the order of workers.
pub(super) fn collected(world: &SimpleCommunicator, random: &mut Random, ask: Ask<'_>) {
    let (rank, ranks) = (world.rank(), world.size() as usize);
    for (master_works, most) in
        [(true, 0), (false, 0), (false, 5), (true, 5), (false, 5), (true, 264_000)]
    {
        let team = Team::new(ranks, master_works);
        let lists = lists(random, ranks, most);
        let own = if team.worker(rank).is_some() { &lists[rank as usize][..] } else { &[] };
        let found = together("collect", || match most {
            5 => collected_from_above(world, team, own),
            _ => collect(world, team, own),
        });
        let workers = (0..team.workers).filter(|_| rank == 0);
        let right: Vec<_> =
            workers.flat_map(|worker| lists[team.rank(worker) as usize].clone()).collect();
        let name = name_of(team, rank, most);
        let question = format!("{name}: how many items it has in the end, and two sums of them");
        ask(&question, told(&found), told(&right));
    }
    let (team, own) = (Team::new(ranks, true), vec![DiscWire::default(); LONG]);
    let turn = |_| {
        together("collect", || drop(collect(world, team, &own)));
        world.barrier();
    };
    let size = (50, size_of_val(&own[..]));
    memory(&name_of(team, rank, LONG), size, |turns| (0..turns).for_each(turn), ask);
}

/// What [`collect`] returns if the highest rank's list comes first, and each other one when the master
/// has had time to take it: a master that takes what arrives first gets another order.
fn collected_from_above(world: &SimpleCommunicator, team: Team, own: &[DiscWire]) -> Vec<DiscWire> {
    let (rank, ranks) = (world.rank(), world.size());
    if (1..ranks - 1).contains(&rank) {
        let _: (u8, _) = world.process_at_rank(rank + 1).receive_with_tag(85);
        sleep(Duration::from_millis(50));
    }
    let found = collect(world, team, own);
    if rank > 1 {
        world.process_at_rank(rank - 1).send_with_tag(&1_u8, 85);
    }
    found
}

fn built(name: &str) -> Box<dyn Simulation> {
    let variant = VARIANTS.iter().find(|v| v.name == name).expect("the lab has it");
    (variant.build)(&variant.config()).expect("the variant can be built")
}

/// Two discs meet in step 2 and never again: what travels in few and in many steps after the first, in which all
/// travels.
pub(super) fn quiet_steps(world: &SimpleCommunicator, ask: Ask<'_>) {
    let discs = [(490.0, 3.0), (500.0, -3.0)].map(|(x, vx)| Disc::new(x, 500.0, vx, 0.5));
    let scene = Scene::new(1000.0, 1.0, discs.to_vec()).expect("all are inside");
    let bytes = |steps: u32| {
        let mut simulation = built("master-workers");
        simulation.load(&scene);
        (0..steps).for_each(|_| simulation.step());
        let counters = simulation.counters();
        let bytes = counters.iter().find(|(name, _)| *name == "bytes per step, busiest rank");
        bytes.map_or(0.0, |(_, bytes)| (bytes * f64::from(steps - 1)).round())
    };
    let (few, many) = (bytes(3), bytes(30));
    let (rank, ranks) = (world.rank(), world.size());
    let question = format!(
        "{ranks} ranks, two discs meet in step 2: do bytes travel after step 1 (1), and how many after step 3, when \
         nothing happens any more"
    );
    if rank == 0 {
        ask(&question, vec![truth(few > 0.0), many - few], vec![truth(ranks > 1), 0.0]);
    } else {
        ask(&question, vec![0.0, 0.0], vec![0.0, 0.0]);
    }
}

/// Whether ranks share the search for pairs: of four ranks three are workers, or each has a strip with as many discs as
/// another.
pub(super) fn shares(world: &SimpleCommunicator, random: &mut Random, name: &str, ask: Ask<'_>) {
    let (n, seed) = (300 + random.below(200), 1 + random.below(1 << 30) as u32);
    let scene = RandomScene::new(n as u64, 100.0, 1.0, seed).with_speeds(0.5, 3.0).draw();
    let mut simulation = built(name);
    simulation.load(&scene.expect("the scene is sound"));
    (0..4).for_each(|_| simulation.step());
    let counters = simulation.counters();
    let count = |name| counters.iter().find(|(it, _)| *it == name).map_or(0.0, |(_, count)| *count);
    let much = 3.0 * count("pair tests, busiest rank") > 2.0 * count("pair tests");
    let ranks = world.size();
    let question = format!(
        "{name}, {ranks} ranks, {n} discs: does one rank look at more than two thirds of the pairs (1)"
    );
    ask(&question, vec![truth(much && ranks > 3)], vec![0.0]);
}

/// To whom a rank without a master talks where discs are slow and strips high: to the two beside it, by a number and a
/// list each time, as often as all add up something. All together they only agree on numbers.
pub(super) fn neighbours(world: &SimpleCommunicator, ask: Ask<'_>) {
    let scene = RandomScene::new(500, 100.0, 1.0, 8).with_speeds(0.1, 0.2).draw();
    let mut simulation = built("spatial-cuts");
    simulation.load(&scene.expect("the scene is sound"));
    together("a step", || simulation.step());
    let made = calls_made();
    let count = |name: &str| made.iter().filter(|call| **call == name).count();
    let many = count("MPI_Isend") > 4 * count("MPI_Allreduce");
    let to_all = ["gather", "Gather", "Bcast", "catter", "lltoall"];
    let others = made.iter().filter(|call| to_all.iter().any(|part| call.contains(part))).count();
    let question = format!(
        "slow discs, rank {} of {}: does it send to more than two in a round (1), and calls of MPI that bring lists to \
         all",
        world.rank(),
        world.size()
    );
    ask(&question, vec![truth(many), others as f64], vec![0.0; 2]);
}

/// Does what a rank holds grow with the steps of a variant?
pub(super) fn long_run(world: &SimpleCommunicator, name: &str, ask: Ask<'_>) {
    let mut simulation = built(name);
    let scene = RandomScene::new(1000, 100.0, 1.0, 7).with_speeds(0.5, 3.0).draw();
    let scene = scene.expect("the scene is sound");
    simulation.load(&scene);
    let size = (50, size_of_val(scene.discs()));
    let name = format!("{name}, rank {} of {}", world.rank(), world.size());
    memory(&name, size, |steps| (0..steps).for_each(|_| simulation.step()), ask);
}
