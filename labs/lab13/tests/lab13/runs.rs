//! Whole runs, of `strips` and of `strips-deep`.

use common::soft::{CUTOFF, Particle, Scene};
use lab13::{VARIANTS, right_steps};
use oracle::mpiexec::OnRanks;
use oracle::{Ask, scenes};
use oracle_mpi::RunsOnRanks;

use super::{deep, strips};

/// A function that returns runs of a variant on some numbers of ranks.
type On = fn(&[usize]) -> RunsOnRanks;

pub(crate) fn dense_box(on: On, ask: &mut impl Ask) {
    on(&[1, 2, 3, 5]).resynchronised(ask, &[scenes::dense()], 40);
}

pub(crate) fn close_pairs(on: On, ask: &mut impl Ask) {
    on(&[3]).resynchronised(ask, &[scenes::close_pairs()], 20);
}

pub(crate) fn over_the_edges(on: On, ask: &mut impl Ask) {
    let some: Vec<Scene> = scenes::edges().into_iter().step_by(7).collect();
    on(&[2]).resynchronised(ask, &some, 3);
}

pub(crate) fn long_run(on: On, ask: &mut impl Ask) {
    on(&[2, 3]).resynchronised(ask, &[counter(2000, 3)], 120);
}

pub(crate) fn few_rows(on: On, ask: &mut impl Ask) {
    let alone = scene(0.3, vec![Particle { x: 0.1, y: 0.3, ..Particle::default() }]);
    on(&[3, 4, 7]).resynchronised(ask, &[scenes::crowd(3), alone], 12);
}

pub(crate) fn empty_ranks(on: On, ask: &mut impl Ask) {
    // Other ranks have rows without particles, or no rows.
    let all = [scenes::corner(0.0), scenes::corner(45.0 * CUTOFF), scenes::one_row()];
    on(&[4, 5]).resynchronised(ask, &all, 20);
}

/// Returns runs that cut the strips again with every list.
pub(crate) fn often_cut(on: On) -> RunsOnRanks {
    on(&[3]).set("rebalance", 1.0)
}

pub(crate) fn cut_again(on: On, ask: &mut impl Ask) {
    let names = ["times the strips were cut again"];
    often_cut(on).counters(ask, &scenes::drifting(), 40, &names, |_, found| match found {
        [times] if *times >= 3.0 => Ok(()),
        _ => Err(format!("the strips were cut again {found:?} times, but must be cut again at least 3 times, because \
                          the particles crossed the box")),
    });
}

/// Asks about a pair so close that it flies apart at once, among particles at rest. It crosses
/// several strips before any list expects it.
pub(crate) fn become_fast(on: On, ask: &mut impl Ask) {
    let size = 60.0 * CUTOFF;
    let mut particles = scenes::lattice_with_jitter(600, size, 0.01, 5).particles().to_vec();
    let middle = 30.0 * CUTOFF;
    particles.push(Particle { x: middle, y: middle, ..Particle::default() });
    particles.push(Particle { x: middle, y: middle + 0.02 * CUTOFF, ..Particle::default() });
    on(&[2, 5]).resynchronised(ask, &[scene(size, particles)], 20);
}

/// Asks about two particles that start 2.05 cutoffs apart on two ranks, and touch after both have
/// moved 0.525 cutoffs. With a skin of one cutoff, a list lasts until a particle has moved half a
/// cutoff.
pub(crate) fn meeting(on: On, ask: &mut impl Ask) {
    let at = |y: f64, vy: f64| Particle { x: 0.05, y, vy, ..Particle::default() };
    let two = scene(0.1, vec![at(0.03, 1.0), at(0.0505, -1.0)]);
    on(&[2]).set("skin", 1.0).resynchronised(ask, &[two], 40);
}

pub(crate) fn threads(ask: &mut impl Ask) {
    let with_threads = RunsOnRanks::new("13.6", VARIANTS, "strips-threads", &[2]);
    let others = [1, 3].map(|threads| with_threads.clone().threads(threads));
    strips(&[2]).same_bits(ask, &[counter(1000, 2)], 30, &others);
}

/// Checks that a step needs one message of positions and one reduction. The cost of a list is
/// spread over its steps.
pub(crate) fn few_messages(ask: &mut impl Ask) {
    let names = ["steps per list", "messages per step, busiest rank"];
    let scene = counter(20_000, 1);
    strips(&[2]).counters(ask, &scene, 100, &names, |_, found| match found {
        [steps, messages] if *steps > 4.0 && *messages < 4.0 => Ok(()),
        _ => Err(format!(
            "found {found:?}, but a list must last for more than 4 steps, and a rank must send fewer than 4 messages \
             in a step"
        )),
    });
}

/// Checks that an epoch needs a message to each partner and one reduction for all its steps. No
/// particle is kicked.
pub(crate) fn few_messages_of_epochs(ask: &mut impl Ask) {
    let names = ["steps per epoch", "messages per step, busiest rank", "epochs taken again"];
    deep(&[2, 3]).counters(ask, &counter(20_000, 1), 100, &names, |ranks, found| {
        let most = if ranks == 2 { 0.5 } else { 0.6 };
        match found {
            [steps, messages, again] if *steps > 4.0 && *messages < most && *again <= 2.0 => Ok(()),
            _ => Err(format!(
                "found {found:?}, but an epoch must have more than 4 steps, a rank must send fewer than {most} \
                 messages in a step, and at most 2 epochs may be taken again"
            )),
        }
    });
}

pub(crate) fn taken_again(ask: &mut impl Ask) {
    let names = ["epochs taken again"];
    deep(&[2, 3, 5]).counters(ask, &a_kick(), 12, &names, |_, found| match found {
        [again] if *again >= 1.0 => Ok(()),
        _ => Err(format!(
            "{found:?} epochs were taken again, but one must be, because a particle became fast in step 3"
        )),
    });
}

/// Position of the kicked particle after five steps.
const END: [f64; 2] = [0.302, 0.264_778_803];

/// Returns a scene with two particles at one position, in strip 1 of two, without a force. Their
/// speeds differ minimally, so in step 2 their distance is tiny, and in step 3 a push moves each
/// particle by eight cutoffs. One of the two crosses the border and reaches a third particle, which
/// is at rest there.
pub(crate) fn a_kick() -> Scene {
    let size = 60.0 * CUTOFF;
    let x = 30.2 * CUTOFF;
    let y = 50.0 * CUTOFF;
    let mut particles = scenes::lattice_with_jitter(600, size, 0.01, 8).particles().to_vec();
    particles.retain(|p| (p.x - x).abs() > 2.5 * CUTOFF);
    let one = Particle { x, y, ..Particle::default() };
    particles.push(Particle { vy: -1.28e-9, ..one });
    particles.push(one);
    // The kicked particle ends 0.4 cutoffs beside this particle.
    particles.push(Particle { x: END[0] + 0.4 * CUTOFF, y: END[1], ..Particle::default() });
    scene(size, particles)
}

/// Runs the lab's own program, the student's or the solution's.
pub(crate) fn program(task: &'static str, variant: &'static str, ask: &mut impl Ask) {
    ask.in_tests_only(|| {
        let program =
            option_env!("CARGO_BIN_EXE_lab13").or(option_env!("CARGO_BIN_EXE_solution13"));
        let program = program.expect("the lab has its own program");
        for ranks in [1, 2, 3, 5] {
            OnRanks::new(task, program, variant, ranks).official_bytes();
        }
        OnRanks::new(task, program, variant, 3).ends_when_a_rank_is_killed();
    });
}

/// Runs the program with deep ghosts. An unsolved starter stops at the `todo!` of task 13.8.
pub(crate) fn program_of_epochs(ask: &mut impl Ask) {
    ask.in_tests_only(|| _ = right_steps(&[0.0], CUTOFF));
    program("13.8", "strips-deep", ask);
}

fn counter(n: u64, seed: u32) -> Scene {
    Scene::counter(n, seed).expect("the scene is valid")
}

fn scene(size: f64, particles: Vec<Particle>) -> Scene {
    Scene::new(size, particles).expect("the scene is valid")
}
