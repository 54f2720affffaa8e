//! What tests and probe ask alike about the calls that all ranks make together.

use common::soft::{CUTOFF, Particle, Scene, Statistics};
use common_mpi::{Wire, calls_made, together};
use lab5::{VARIANTS, broadcast, gather_at_root, reduce, scatter_from_root};
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;

use super::ask::{Ask, digest, memory, no_other_calls, rounded, truth};
use super::on_edges;
use crate::Random;

/// The most items of a rank: none, a few, more than 16 bits count, and then less.
const MOST: [usize; 5] = [0, 5, 40, 70_000, 5];

/// The items of a rank in a long run.
const LONG: usize = 1000;

/// A list for each rank.
fn lists(random: &mut Random, ranks: usize, most: usize) -> Vec<Vec<Wire>> {
    let list = |n: usize, random: &mut Random| {
        on_edges(random, n, 1.0, 9).iter().map(Wire::from).collect()
    };
    (0..ranks).map(|_| list(random.below(4) * most / 3, random)).collect()
}

fn told(list: &[Wire]) -> Vec<f64> {
    digest(list.iter().map(|w| (w.x + 2.0 * w.y + 4.0 * w.vx + 8.0 * w.vy, w.id)))
}

/// That an exchange is two collective operations: one of counts, one of items.
fn two_calls(name: &str, what: &str, ask: Ask<'_>) {
    let calls = calls_made();
    let count = |v: &str| {
        let of_kind = format!("MPI_{what}{v}");
        calls.iter().filter(|call| ***call == of_kind).count() as f64
    };
    let found = vec![count(""), count("v"), calls.len() as f64];
    let question = format!("{name}: calls of MPI_{what}, of MPI_{what}v, and of MPI in all");
    ask(&question, found, vec![1.0, 1.0, 2.0]);
}

/// What the root gets of all ranks, and that it takes two collective operations.
pub(super) fn gathers(world: &SimpleCommunicator, random: &mut Random, ask: Ask<'_>) {
    let (rank, ranks) = (world.rank() as usize, world.size() as usize);
    for most in MOST {
        let lists = lists(random, ranks, most);
        let found = together("gather_at_root", || gather_at_root(world, &lists[rank]));
        let name = format!("gather_at_root on rank {rank} of {ranks}, up to {most} items");
        two_calls(&name, "Gather", ask);
        let all = |lists: &[Vec<Wire>]| {
            let mut all = vec![lists.len() as f64];
            all.extend(lists.iter().flat_map(|list| told(list)));
            all.resize(1 + 3 * ranks, 0.0);
            all
        };
        let right = if rank == 0 { &lists[..] } else { &[] };
        let question =
            format!("{name}: how many lists it gets, and how many items and sums of each");
        ask(&question, all(&found), all(right));
    }
    let items = vec![Wire::default(); LONG];
    let turn = |_| {
        together("gather_at_root", || drop(gather_at_root(world, &items)));
        world.barrier();
    };
    let name = format!("gather_at_root on rank {rank} of {ranks}");
    memory(&name, (50, size_of_val(&items[..])), |turns| (0..turns).for_each(turn), ask);
}

/// What each rank gets of the root's lists, by two collective operations.
pub(super) fn scatters(world: &SimpleCommunicator, random: &mut Random, ask: Ask<'_>) {
    let (rank, ranks) = (world.rank() as usize, world.size() as usize);
    for most in MOST {
        let lists = lists(random, ranks, most);
        let own = if rank == 0 { &lists[..] } else { &[] };
        let found = together("scatter_from_root", || scatter_from_root(world, own));
        let name = format!("scatter_from_root on rank {rank} of {ranks}, up to {most} items");
        two_calls(&name, "Scatter", ask);
        let question = format!("{name}: how many it gets, and sums of them");
        ask(&question, told(&found), told(&lists[rank]));
    }
    let lists = vec![vec![Wire::default(); LONG]; if rank == 0 { ranks } else { 0 }];
    let turn = |_| {
        together("scatter_from_root", || drop(scatter_from_root(world, &lists)));
        world.barrier();
    };
    let name = format!("scatter_from_root on rank {rank} of {ranks}");
    memory(&name, (50, LONG * size_of::<Wire>()), |turns| (0..turns).for_each(turn), ask);
}

/// The scene that each rank gets: more particles than sixteen bits count, and then less than before.
pub(super) fn broadcasts(world: &SimpleCommunicator, random: &mut Random, ask: Ask<'_>) {
    let (rank, ranks) = (world.rank(), world.size());
    for (n, side) in [(70_000, 3.0), (1, 6.0), (12, 0.1)] {
        let scene = Scene::new(side, on_edges(random, n, side, 9)).expect("the scene is sound");
        let (size, found) =
            together("broadcast", || broadcast(world, (rank == 0).then_some(&scene)));
        no_other_calls(
            &calls_made(),
            &["MPI_Bcast"],
            &format!("broadcast of {n} particles, rank {rank} of {ranks}"),
            ask,
        );
        let all = |size: f64, particles: &[_]| {
            let wires: Vec<Wire> = particles.iter().map(Wire::from).collect();
            [vec![size], told(&wires)].concat()
        };
        let question = format!(
            "broadcast of {n} particles: the side of the box on rank {rank} of {ranks}, how many particles, and \
             sums of them"
        );
        ask(&question, all(size, &found), all(side, scene.particles()));
    }
}

/// What a step sends where no particle comes near a border: lengths and nothing else, by way of the root.
pub(super) fn quiet_steps(world: &SimpleCommunicator, ask: Ask<'_>) {
    let (rank, ranks) = (world.rank(), world.size() as usize);
    // A line of particles, which push each other along it, in the middle of each rank's rows.
    let rows = 6 * ranks;
    let side = (rows as f64 + 0.5) * 2.0 * CUTOFF;
    let particle = |i: usize| Particle {
        x: side * (i / ranks) as f64 / 500.0,
        y: side * (6 * (i % ranks) + 3) as f64 / rows as f64,
        ..Particle::default()
    };
    let scene = Scene::new(side, (0..500 * ranks).map(particle).collect()).expect("it is sound");
    let mut simulation = (VARIANTS[0].build)(&VARIANTS[0].config()).expect("it can be built");
    simulation.load(&scene);
    together("a step", || simulation.step());
    let name = format!("a step far from borders, rank {rank} of {ranks}");
    no_other_calls(
        &calls_made(),
        &["MPI_Gather", "MPI_Gatherv", "MPI_Scatter", "MPI_Scatterv"],
        &name,
        ask,
    );
    let counters = simulation.counters();
    let bytes = counters.iter().find(|(name, _)| *name == "bytes per step, busiest rank");
    let more = bytes.is_some_and(|(_, bytes)| *bytes > 100.0);
    ask(&format!("{name}: does a rank send more than lengths (1)"), vec![truth(more)], vec![0.0]);
}

/// Counts of any size: those of a long run on a large machine do not fit into 32 bits.
pub(super) fn sums(world: &SimpleCommunicator, random: &mut Random, ask: Ask<'_>) {
    let (rank, ranks) = (world.rank() as usize, world.size() as usize);
    for round in 0..8 {
        let mut count = || random.bits() >> (5 + 8 * (round % 8));
        let counts: Vec<[u64; 2]> = (0..ranks).map(|_| [count(), count()]).collect();
        let davg: Vec<f64> = (0..ranks).map(|_| random.magnitude(1e-3, 1e6)).collect();
        let own = Statistics {
            dmin: 0.5 + ((rank + 2 + round) % ranks) as f64 / 16.0,
            davg: davg[rank],
            navg: counts[rank][0],
            pair_tests: counts[rank][1],
        };
        let found = together("reduce", || reduce(world, &own));
        let name = format!("reduce {round}, on rank {rank} of {ranks}");
        no_other_calls(&calls_made(), &["MPI_Reduce"], &name, ask);
        let sum = |which: usize| counts.iter().map(|counts| counts[which]).sum();
        let davg: f64 = davg.iter().sum();
        let right = Statistics { dmin: 0.5, davg, navg: sum(0), pair_tests: sum(1) };
        let right = (rank == 0).then_some(right);
        let is = |all: &Option<Statistics>| vec![truth(all.is_some())];
        ask(&format!("{name}: 1 for an answer, 0 for none"), is(&found), is(&right));
        // A number with a point has 53 bits.
        let halves = |count: u64| vec![(count >> 32) as f64, f64::from(count as u32)];
        let [found, right] = [found, right].map(|all| all.unwrap_or(own));
        ask(&format!("{name}: dmin"), vec![found.dmin], vec![right.dmin]);
        // Ranks may be added up in any order.
        let near = rounded(found.davg, right.davg, davg);
        ask(&format!("{name}: davg"), vec![near], vec![right.davg]);
        for (what, found, right) in
            [("navg", found.navg, right.navg), ("pair tests", found.pair_tests, right.pair_tests)]
        {
            let question = format!("{name}: {what}, upper and lower 32 bits");
            ask(&question, halves(found), halves(right));
        }
    }
}
