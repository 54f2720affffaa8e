//! Questions about messages that all ranks answer together.

use std::thread::sleep;
use std::time::Duration;

use common::hard::{Disc, RandomScene, Scene, Simulation};
use common_mpi::{Clock, calls_made};
use hard_disc_ranks::{Deal, DiscWire, MasterWorkers, Team};
use lab8::{Lab8, VARIANTS, collect, hand_out};
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;
use oracle::{Ask, Random, begins_send, digest, integers, truth};
use oracle_mpi::{DiscsOnRanks, Rank, on_each};

/// Number of discs of a list in a long run.
const LONG: usize = 1000;

/// Draws a list of discs for each worker or rank: empty, short, or longer than the library can
/// buffer.
fn lists(random: &mut Random, count: usize, most: usize) -> Vec<Vec<DiscWire>> {
    (0..count).map(|_| list(random, most)).collect()
}

fn list(random: &mut Random, most: usize) -> Vec<DiscWire> {
    let length = (1 + random.below(4)) * most / 4;
    let mut list = vec![DiscWire::default(); length];
    for (number, disc) in (0..).zip(&mut list) {
        disc.x = random.between(0.0, 1.0);
        disc.number = number;
    }
    list
}

fn sums_of(list: &[DiscWire]) -> Vec<f64> {
    digest(list.iter().map(|disc| (disc.x, disc.number)))
}

fn name_of(team: Team, rank: &Rank<'_>, most: usize) -> String {
    let works = if team.master_works { "works too" } else { "does not work" };
    format!("{}, a master that {works}, lists of up to {most} discs", rank.name())
}

/// Draws numbers of ranks: one, a few, and a random number.
fn counts(random: &mut Random) -> [usize; 3] {
    [1, 2, 3 + random.below(4)]
}

/// Asks for the list that each rank receives from the master, and for the number of sends that the
/// master begins before it waits for one. A worker that is not ready must not delay the other
/// workers.
pub(crate) fn hands_out(random: &mut Random, ask: &mut impl Ask) {
    let counts = counts(random);
    on_each(ask, "8.4", &counts, random, |rank, random, ask| {
        let cases = [(false, 0), (false, 5), (true, 5), (false, 264_000), (true, 264_000)];
        for (master_works, most) in cases {
            let team = Team::new(rank.ranks, master_works);
            let lists = lists(random, team.workers, most);
            let own = if rank.is_root() { &lists[..] } else { &[] };
            let found = rank.call("hand_out", |world| hand_out(world, team, own));
            let name = name_of(team, rank, most);
            let question =
                format!("{name}: number of sends that this rank begins before it waits for a send");
            ask.exact(&question, || integers([sends_begun()]), || integers([sends(team, rank)]));
            let question = format!(
                "{name}: (1) number of discs that this rank gets, (2) a checksum of their positions in the order of the \
                 list, (3) the sum of their numbers"
            );
            let worker = team.worker(rank.number as i32);
            let right = || worker.map_or_else(|| sums_of(&[]), |worker| sums_of(&lists[worker]));
            ask.exact(&question, || sums_of(&found), right);
        }
        let team = Team::new(rank.ranks, true);
        let count = if rank.is_root() { rank.ranks } else { 0 };
        let lists = vec![vec![DiscWire::default(); LONG]; count];
        let turn = |world: &_| drop(hand_out(world, team, &lists));
        rank.keeps_its_memory("hand_out", LONG * size_of::<DiscWire>(), turn, ask);
    });
}

/// Returns the number of sends that the last call began before it waited for a send.
fn sends_begun() -> usize {
    let made = calls_made();
    let begun = made.iter().take_while(|call| !call.starts_with("MPI_Wait"));
    begun.filter(|call| begins_send(call)).count()
}

/// Returns the number of lists that a rank sends to others.
fn sends(team: Team, rank: &Rank<'_>) -> usize {
    if rank.is_root() { team.workers - usize::from(team.master_works) } else { 0 }
}

/// Asks for the workers' lists that the master has received, in the order of workers.
pub(crate) fn collects(random: &mut Random, ask: &mut impl Ask) {
    let counts = counts(random);
    on_each(ask, "8.5", &counts, random, |rank, random, ask| {
        let cases = [(true, 0), (false, 0), (false, 5), (true, 5), (false, 5), (true, 264_000)];
        for (master_works, most) in cases {
            let team = Team::new(rank.ranks, master_works);
            let lists = lists(random, rank.ranks, most);
            let is_worker = team.worker(rank.number as i32).is_some();
            let own = if is_worker { &lists[rank.number][..] } else { &[] };
            let found = rank.call("collect", |world| {
                if most == 5 {
                    wait_for_the_rank_above(world);
                }
                collect(world, team, own)
            });
            let name = name_of(team, rank, most);
            let question = format!(
                "{name}: (1) number of discs that this rank has at the end, (2) a checksum of their positions in the \
                 order of the list, (3) the sum of their numbers"
            );
            let right = || {
                let workers = (0..team.workers).filter(|_| rank.is_root());
                let lists = workers.map(|worker| &lists[team.rank(worker) as usize][..]);
                sums_of(&lists.collect::<Vec<_>>().concat())
            };
            ask.exact(&question, || sums_of(&found), right);
        }
        let team = Team::new(rank.ranks, true);
        let own = vec![DiscWire::default(); LONG];
        let turn = |world: &_| drop(collect(world, team, &own));
        rank.keeps_its_memory("collect", LONG * size_of::<DiscWire>(), turn, ask);
    });
}

/// Makes the highest rank send first, and each other rank after the master had time to receive that
/// list. A master that takes lists in the order of arrival then gets a different order. No rank
/// waits for the end of another rank's send, so a send may also wait for its receive.
fn wait_for_the_rank_above(world: &SimpleCommunicator) {
    let rank = world.rank();
    if (1..world.size() - 1).contains(&rank) {
        let _: (u8, _) = world.process_at_rank(rank + 1).receive_with_tag(85);
        sleep(Duration::from_millis(100));
    }
    if rank > 1 {
        world.process_at_rank(rank - 1).send_with_tag(&1_u8, 85);
    }
}

/// Asks for the bytes sent in short and long runs after the first step, in which all discs are
/// sent. Two discs meet in step 2 and never again.
pub(crate) fn quiet_steps(random: &mut Random, ask: &mut impl Ask) {
    let runs = DiscsOnRanks::new("8.7", VARIANTS, "master-workers", &[]);
    on_each(ask, "8.7", &[1, 2, 3], random, |rank, _, ask| {
        let bytes = |steps| {
            rank.call("a run", |world| {
                let mut engine = runs.engine(world);
                engine.load(&two_that_meet());
                (0..steps).for_each(|_| engine.step());
                bytes_of(&engine.counters(), steps)
            })
        };
        let few = bytes(3);
        let many = bytes(30);
        if rank.is_root() {
            let question = format!(
                "{}, two discs that meet only in step 2: (1) 1 if bytes are sent after step 1, 0 if not, (2) number \
                 of bytes sent after step 3, when the discs no longer meet",
                rank.name()
            );
            ask.exact(
                &question,
                || vec![truth(few > 0.0), many - few],
                || vec![truth(rank.ranks > 1), 0.0],
            );
        }
    });
}

/// Asks for the deal after two steps. It began with more blocks for each worker than the rule of
/// task 8.1 gives. Workers get their blocks in each step.
pub(crate) fn kept_deal(random: &mut Random, ask: &mut impl Ask) {
    on_each(ask, "8.7", &[3, 5], random, |rank, _, ask| {
        let team = Team::new(rank.ranks, false);
        let dealt = Deal { workers: team.workers, offsets: (0..team.workers).collect() };
        let kept = rank.call("two steps", |_| {
            let world = SimpleCommunicator::world();
            let mut engine = MasterWorkers::<Lab8>::new(world, team, false, Clock::new(false));
            engine.load(&two_that_meet());
            engine.deal = Some(dealt.clone());
            (0..2).for_each(|_| engine.step());
            engine.deal
        });
        let question = format!(
            "{}, two steps of an engine whose deal gives all blocks to each worker: the offsets of the deal after \
             these steps",
            rank.name()
        );
        let found = || kept.map_or_else(Vec::new, |deal| integers(deal.offsets));
        ask.exact(&question, found, || integers(dealt.offsets.clone()));
    });
}

fn two_that_meet() -> Scene {
    let discs = [(490.0, 3.0), (500.0, -3.0)].map(|(x, vx)| Disc::new(x, 500.0, vx, 0.5));
    Scene::new(1000.0, 1.0, discs.to_vec()).expect("all discs are inside the square")
}

/// Returns the bytes that the busiest rank sends in `steps` steps after the first.
fn bytes_of(counters: &[(&'static str, f64)], steps: u32) -> f64 {
    let bytes = counters.iter().find(|(name, _)| *name == "bytes per step, busiest rank");
    bytes.map_or(0.0, |(_, bytes)| (bytes * f64::from(steps - 1)).round())
}

/// Asks which ranks a rank sends lists to, in a job without a master, with slow discs and high
/// strips. In each round all ranks add up a number, and a rank sends each of its two neighbours a
/// number and a list. No collective call may carry a list.
pub(crate) fn neighbours(random: &mut Random, ask: &mut impl Ask) {
    let runs = DiscsOnRanks::new("8.13", VARIANTS, "spatial-cuts", &[]);
    on_each(ask, "8.13", &[5], random, |rank, _, ask| {
        let scene = RandomScene::new(500, 100.0, 1.0, 8).with_speeds(0.1, 0.2).draw();
        let mut engine = rank.call("loading", |world| {
            let mut engine = runs.engine(world);
            engine.load(scene.as_ref().expect("the scene is valid"));
            Some(engine)
        });
        rank.call("a step", |_| engine.iter_mut().for_each(|engine| engine.step()));
        let question = format!(
            "slow discs, {}: (1) 1 if this rank sends to more than two ranks in a round, 0 if not, (2) number of MPI \
             calls that bring lists to all ranks",
            rank.name()
        );
        ask.exact(&question, to_many_or_all, || vec![0.0; 2]);
    });
}

/// Returns 1 if this rank's last calls sent to more than two ranks in a round, 0 if not; then the
/// number of calls that sent lists to all ranks.
fn to_many_or_all() -> Vec<f64> {
    let made = calls_made();
    let count = |name: &str| made.iter().filter(|call| **call == name).count();
    let sends = made.iter().filter(|call| begins_send(call)).count();
    let many = sends > 4 * count("MPI_Allreduce");
    let to_all = ["gather", "Gather", "Bcast", "catter", "lltoall"];
    let others = made.iter().filter(|call| to_all.iter().any(|part| call.contains(part))).count();
    vec![truth(many), others as f64]
}

/// Asks how often all ranks agree on a number in a step. They agree once on the range, once on a sum
/// of zero, and once more if two discs of a strip collide.
pub(crate) fn quiet_rounds(random: &mut Random, ask: &mut impl Ask) {
    let runs = DiscsOnRanks::new("8.13", VARIANTS, "spatial-cuts", &[]);
    on_each(ask, "8.13", &[3], random, |rank, _, ask| {
        for pairs in [0, 1] {
            let scene = at_rest_beside(pairs);
            let mut engine = rank.call("loading", |world| {
                let mut engine = runs.engine(world);
                engine.load(&scene);
                Some(engine)
            });
            rank.call("a step", |_| engine.iter_mut().for_each(|engine| engine.step()));
            let question = format!(
                "30 discs at rest and {pairs} pairs that collide far from a cut, {}: number of calls of Allreduce in \
                 a step",
                rank.name()
            );
            let made = calls_made();
            let reductions = made.iter().filter(|call| **call == "MPI_Allreduce").count();
            ask.exact(&question, || integers([reductions]), || integers([2 + pairs]));
        }
    });
}

/// Returns 30 discs at rest, and a pair that collides near the lower wall if `pairs` is 1.
fn at_rest_beside(pairs: usize) -> Scene {
    let place = |k: u32| 10.0 + 15.0 * f64::from(k);
    let mut discs: Vec<Disc> =
        (0..30).map(|k| Disc::new(place(k % 6), place(k / 6), 0.0, 0.0)).collect();
    let pair = [(17.0, 2.0), (22.0, -2.0)].map(|(x, vx)| Disc::new(x, 17.0, vx, 0.0));
    discs.extend_from_slice(&pair[..2 * pairs]);
    Scene::new(100.0, 1.0, discs).expect("all discs are inside the square")
}

/// Asks whether the rank searches for wall collisions after it has sent the ghosts, and before it
/// waits for the ghosts that arrive.
pub(crate) fn walls_meanwhile(random: &mut Random, ask: &mut impl Ask) {
    let runs = DiscsOnRanks::new("8.13", VARIANTS, "spatial-cuts", &[]);
    on_each(ask, "8.13", &[3], random, |rank, _, ask| {
        let scene = RandomScene::new(300, 100.0, 1.0, 9).with_speeds(0.1, 0.2).draw();
        rank.call("a step", |world| {
            let mut engine = runs.engine(world);
            engine.load(scene.as_ref().expect("the scene is valid"));
            engine.step();
        });
        let question = format!(
            "300 slow discs, {}, a step: 1 if `walls_of` is called at a time when no ghosts are under way, 0 if not",
            rank.name()
        );
        ask.judge(&question, || vec![truth(walls_alone())], |found| match found {
            [0.0] => Ok(()),
            _ => Err("the wall collisions are found before or after the ghosts travel. Find them while the ghosts \
                      travel".into()),
        });
    });
}

/// Returns whether some search for wall collisions does not come between a call that starts a
/// message and a call that waits.
fn walls_alone() -> bool {
    let made = calls_made();
    let is_search = |at: &usize| made[*at] == "walls_of";
    (0..made.len()).filter(is_search).any(|at| {
        let before = made[..at].last().is_some_and(|call| call.starts_with("MPI_I"));
        let behind = made.get(at + 1).is_some_and(|call| call.starts_with("MPI_Wait"));
        !before || !behind
    })
}
