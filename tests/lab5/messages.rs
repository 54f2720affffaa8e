//! Questions about functions that all ranks call together.

use common::soft::{CUTOFF, Particle, Scene, Simulation, Statistics};
use common_mpi::{Wire, calls_made};
use lab5::{VARIANTS, broadcast, gather_at_root, reduce, scatter_from_root};
use mpi::traits::*;
use oracle::scenes::on_edges;
use oracle::{Ask, Near, Random, digest, memory, no_other_calls, truth};
use oracle_mpi::{Rank, on_each};

/// Greatest numbers of items per rank, one after another. One of them is more than 16 bits can
/// count, and the next is small again.
const MOST: [usize; 5] = [0, 5, 40, 70_000, 5];

/// Number of items of a rank in a long run.
const LONG: usize = 1000;

/// Draws a list for each rank.
fn lists(random: &mut Random, ranks: usize, most: usize) -> Vec<Vec<Wire>> {
    let list = |n: usize, random: &mut Random| {
        on_edges(random, n, 1.0, 9).iter().map(Wire::from).collect()
    };
    (0..ranks).map(|_| list(random.below(4) * most / 3, random)).collect()
}

/// Returns the length of a list and two sums of its items.
fn sums_of(list: &[Wire]) -> Vec<f64> {
    digest(list.iter().map(|w| (w.x + 2.0 * w.y + 4.0 * w.vx + 8.0 * w.vy, w.id)))
}

/// Asks whether an exchange used two collective operations, the first for counts and the second for
/// items.
fn two_calls(name: &str, what: &str, ask: &mut impl Ask) {
    let count = |calls: &[&str], v: &str| {
        let of_kind = format!("MPI_{what}{v}");
        calls.iter().filter(|call| **call == of_kind).count() as f64
    };
    let found = || {
        let calls = calls_made();
        vec![count(&calls, ""), count(&calls, "v"), calls.len() as f64]
    };
    let question = format!(
        "{name}: (1) number of calls of MPI_{what}, (2) number of calls of MPI_{what}v, (3) number of all MPI calls"
    );
    ask.exact(&question, found, || vec![1.0, 1.0, 2.0]);
}

/// Asks for the lists that the root receives from all ranks, by two collective operations.
pub(crate) fn gathers(random: &mut Random, ask: &mut impl Ask) {
    on_each(ask, "5.4", &[1, 2, 3, 5], random, |rank, random, ask| {
        for most in MOST {
            let lists = lists(random, rank.ranks, most);
            let own = &lists[rank.number];
            let found = rank.call("gather_at_root", |world| gather_at_root(world, own));
            let name = format!("gather_at_root on {}, up to {most} items", rank.name());
            two_calls(&name, "Gather", ask);
            let question = format!(
                "{name}: number of lists that this rank gets. Then for each list: its length, a checksum of its items \
                 in their order, and the sum of its ids"
            );
            ask.exact(
                &question,
                || of_all(&found, rank.ranks),
                || of_all(if rank.is_root() { &lists } else { &[] }, rank.ranks),
            );
        }
        let items = vec![Wire::default(); LONG];
        let turn = || drop(rank.call("gather_at_root", |world| gather_at_root(world, &items)));
        keeps_its_memory("gather_at_root", rank, size_of_val(&items[..]), turn, ask);
    });
}

/// Returns the number of lists, and the sums of each.
fn of_all(lists: &[Vec<Wire>], ranks: usize) -> Vec<f64> {
    let mut all = vec![lists.len() as f64];
    all.extend(lists.iter().flat_map(|list| sums_of(list)));
    all.resize(1 + 3 * ranks, 0.0);
    all
}

/// Asks for the lists that each rank receives from the root, by two collective operations.
pub(crate) fn scatters(random: &mut Random, ask: &mut impl Ask) {
    on_each(ask, "5.6", &[1, 2, 3, 5], random, |rank, random, ask| {
        for most in MOST {
            let lists = lists(random, rank.ranks, most);
            let own = if rank.is_root() { &lists[..] } else { &[] };
            let found = rank.call("scatter_from_root", |world| scatter_from_root(world, own));
            let name = format!("scatter_from_root on {}, up to {most} items", rank.name());
            two_calls(&name, "Scatter", ask);
            let question = format!(
                "{name}: (1) length of the list that this rank gets, (2) a checksum of its items in their order, (3) \
                 the sum of its ids"
            );
            ask.exact(&question, || sums_of(&found), || sums_of(&lists[rank.number]));
        }
        let lists = vec![vec![Wire::default(); LONG]; if rank.is_root() { rank.ranks } else { 0 }];
        let turn =
            || drop(rank.call("scatter_from_root", |world| scatter_from_root(world, &lists)));
        keeps_its_memory("scatter_from_root", rank, LONG * size_of::<Wire>(), turn, ask);
    });
}

/// Asks whether the memory grows with the number of exchanges.
fn keeps_its_memory(
    what: &str,
    rank: &Rank<'_>,
    bytes: usize,
    turn: impl Fn(),
    ask: &mut impl Ask,
) {
    let turns = |turns| {
        for _ in 0..turns {
            turn();
            rank.world().barrier();
        }
    };
    memory(&format!("{what} on {}", rank.name()), (50, bytes), turns, ask);
}

/// Asks for the scene that each rank receives. It has few particles, then more than 16 bits can
/// count, and then fewer. Single precision cannot represent the sides of the boxes.
pub(crate) fn broadcasts(random: &mut Random, ask: &mut impl Ask) {
    on_each(ask, "5.8", &[1, 3], random, |rank, random, ask| {
        for (n, side) in [(12, 0.1), (70_000, 0.3), (1, 6.1)] {
            let scene = Scene::new(side, on_edges(random, n, side, 9)).expect("the scene is valid");
            let own = rank.is_root().then_some(&scene);
            let (size, found) = rank.call("broadcast", |world| broadcast(world, own));
            let name = format!("broadcast of {n} particles, {}", rank.name());
            no_other_calls(&calls_made(), &["MPI_Bcast"], &name, ask);
            let calls = || vec![calls_made().len() as f64];
            ask.judge(
                &format!("{name}: number of calls of MPI_Bcast, at most three"),
                calls,
                three_at_most,
            );
            ask.exact(&format!("{name}: side of the box"), || vec![size], || vec![side]);
            let question = format!(
                "{name}: (1) number of particles, (2) a checksum of the particles in their order, (3) the sum of their \
                 ids"
            );
            let sums = |particles: &[Particle]| {
                sums_of(&particles.iter().map(Wire::from).collect::<Vec<Wire>>())
            };
            ask.exact(&question, || sums(&found), || sums(scene.particles()));
        }
    });
}

fn three_at_most(calls: &[f64]) -> Result<(), String> {
    match calls {
        [calls] if *calls <= 3.0 => Ok(()),
        _ => Err(format!("there are {calls:?} calls, but three are enough")),
    }
}

/// Asks for the bytes of a step in which no particle comes near a border. Only lengths may be sent,
/// through the root.
pub(crate) fn quiet_steps(random: &mut Random, ask: &mut impl Ask) {
    on_each(ask, "5.8", &[1, 3, 4], random, |rank, _, ask| {
        let mut engine = rank.call("loading", |_| Some(loaded(&in_the_middles(rank.ranks))));
        rank.call("a step", |_| engine.iter_mut().for_each(|engine| engine.step()));
        let name = format!("a step far from borders, {}", rank.name());
        let question = format!(
            "{name}: number of calls of (1) MPI_Gather, (2) MPI_Gatherv, (3) MPI_Scatter, (4) MPI_Scatterv, (5) all \
             MPI functions"
        );
        ask.exact(&question, calls_of_a_step, || vec![2.0, 2.0, 1.0, 1.0, 6.0]);
        let question =
            format!("{name}: 1 if a rank sends more than the lengths of its lists, 0 if not");
        let found = || engine.iter().map(|engine| truth(bytes_of_a_step(&**engine) > 100.0));
        ask.exact(&question, || found().collect(), || vec![0.0]);
    });
}

fn calls_of_a_step() -> Vec<f64> {
    let calls = calls_made();
    let exchange = ["MPI_Gather", "MPI_Gatherv", "MPI_Scatter", "MPI_Scatterv"];
    let of_kind = |kind: &str| calls.iter().filter(|call| **call == kind).count();
    exchange.map(of_kind).into_iter().chain([calls.len()]).map(|count| count as f64).collect()
}

fn loaded(scene: &Scene) -> Box<dyn Simulation> {
    let mut engine = (VARIANTS[0].build)(&VARIANTS[0].config()).expect("the engine can be built");
    engine.load(scene);
    engine
}

/// Returns the bytes that the busiest rank sends in a step.
fn bytes_of_a_step(engine: &dyn Simulation) -> f64 {
    let counters = engine.counters();
    let bytes = counters.iter().find(|(name, _)| *name == "bytes per step, busiest rank");
    bytes.map_or(0.0, |(_, bytes)| *bytes)
}

/// Returns a line of particles that push each other along it, in the middle of each rank's rows.
fn in_the_middles(ranks: usize) -> Scene {
    let rows = 6 * ranks;
    let side = (rows as f64 + 0.5) * 2.0 * CUTOFF;
    let particle = |i: usize| Particle {
        x: side * (i / ranks) as f64 / 500.0,
        y: side * (6 * (i % ranks) + 3) as f64 / rows as f64,
        ..Particle::default()
    };
    Scene::new(side, (0..500 * ranks).map(particle).collect()).expect("the scene is valid")
}

/// Asks for sums of counts of any size. The counts of a long run on a large machine exceed 32 bits.
pub(crate) fn sums(random: &mut Random, ask: &mut impl Ask) {
    on_each(ask, "5.9", &[1, 2, 3, 5], random, |rank, random, ask| {
        for round in 0..8 {
            let all: Vec<Statistics> =
                (0..rank.ranks).map(|number| drawn(random, number, rank.ranks, round)).collect();
            let own = all[rank.number];
            let found = rank.call("reduce", |world| reduce(world, &own));
            let name = format!("reduce {round} on {}", rank.name());
            no_other_calls(&calls_made(), &["MPI_Reduce"], &name, ask);
            let calls = || vec![calls_made().len() as f64];
            ask.judge(
                &format!("{name}: number of calls of MPI_Reduce, at most three"),
                calls,
                three_at_most,
            );
            let question = format!("{name}: 1 if this rank gets statistics, 0 if not");
            ask.exact(&question, || vec![truth(found.is_some())], || vec![truth(rank.is_root())]);
            if rank.is_root() {
                let found = found.unwrap_or(own);
                ask.exact(&format!("{name}: dmin"), || vec![found.dmin], || vec![0.5]);
                // The ranks may be added in any order.
                ask.near(
                    &format!("{name}: davg"),
                    || vec![found.davg],
                    || {
                        let davg = all.iter().map(|s| s.davg).sum();
                        vec![Near { right: davg, scale: davg }]
                    },
                );
                let question = format!(
                    "{name}: upper and lower 32 bits of navg, then upper and lower 32 bits of the number of pair tests"
                );
                ask.exact(
                    &question,
                    || halves(found.navg, found.pair_tests),
                    || {
                        halves(
                            all.iter().map(|s| s.navg).sum(),
                            all.iter().map(|s| s.pair_tests).sum(),
                        )
                    },
                );
            }
        }
    });
}

/// Draws the statistics of a rank.
fn drawn(random: &mut Random, number: usize, ranks: usize, round: usize) -> Statistics {
    let mut count = || random.bits() >> (5 + 8 * (round % 8));
    let counts = [count(), count()];
    Statistics {
        dmin: 0.5 + ((number + 2 + round) % ranks) as f64 / 16.0,
        davg: random.magnitude(1e-3, 1e6),
        navg: counts[0],
        pair_tests: counts[1],
    }
}

/// Splits counts into halves, because a floating-point number has 53 bits and a count has 64.
fn halves(navg: u64, pair_tests: u64) -> Vec<f64> {
    [navg, pair_tests]
        .into_iter()
        .flat_map(|count| [(count >> 32) as f64, f64::from(count as u32)])
        .collect()
}
