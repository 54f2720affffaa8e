//! Lab 11's graders.

use common::soft::{DT, Scene};
use lab11::{VARIANTS, meets_wall, window_length};
use oracle::{Ask, Runs, scenes};
use windows::Span;

#[path = "lab11/examples.rs"]
mod examples;
#[path = "lab11/flights.rs"]
mod flights;
#[path = "lab11/groups.rs"]
mod groups;
#[path = "lab11/plans.rs"]
mod plans;
#[path = "lab11/small_steps.rs"]
mod small_steps;
#[path = "lab11/whole_runs.rs"]
mod whole_runs;

use examples::*;
use flights::*;
use groups::*;
use plans::*;
use small_steps::*;
use whole_runs::*;

oracle::questions! {
    task_11_1 {
        flown_steps => "Three particles that fly freely, in steps of 0.1: x after 1, 3 and 10 steps, to the last digit.",
        flights => "Any number of particles that fly freely for any number of steps: x of each particle, bit for bit.",
    }
    task_11_2 {
        closest_approaches => "Two free flights. As seen from the first particle, the second starts at d and has the \
                               velocity w: the least distance within times of 0 to 8.",
        approaches => "Two free flights of any length and any speed: the square of their least distance.",
    }
    task_11_3 {
        joined_pairs => "Eleven particles, and seven pairs that join the groups of their particles: the root of each \
                         particle after each pair.",
        roots => "Chains and trees of numbers: (1) the root of a number, (2) the number of parents above the number \
                  before the call, (3) the number of parents above it after the call.",
        long_chain => "A chain of a million numbers: the root of its last number.",
        joins => "Pairs that are joined in any order: the root of each number after each pair.",
        many_joins => "A million numbers, each joined to the next: the root of the last number.",
    }
    task_11_4 {
        deviations => "A particle that deviates from its free flight, and a margin of 0.05 cutoffs: whether the \
                       particle may have met another particle that is not on its list.",
        margins => "Any deviation and any margin: 1 if the particle is too far away from its free flight, 0 if not.",
    }
    task_11_5 {
        walls_ahead => "A particle in a box of side 1, and a window of four steps of 0.125: whether the particle may \
                        meet a wall.",
        walls => "A particle anywhere, and a window of any length: 1 if the particle may meet a wall, 0 if not.",
        windows after "11.1, 11.2, 11.3, 11.4" => "Windows of 1 to 16 steps: the state after each step, which must \
                                                   have the same bits as in `all-pairs`.",
        back_from_a_wall after "11.1, 11.2, 11.3, 11.4" => "A particle that comes back from a wall within a window of \
                                                            16 steps, and meets a particle at rest: the state after \
                                                            each step, which must have the same bits as in \
                                                            `all-pairs`.",
        redone after "11.1, 11.2, 11.3, 11.4" => "A scene that is too crowded for windows of 64 steps: (1) the state \
                                                  after each step, which must have the same bits as in `all-pairs`, \
                                                  (2) the number of windows that are computed again.",
    }
    task_11_6 {
        window_lengths => "The density (particles per unit area) and the mean speed of the particles: the number of \
                           steps in a window.",
        lengths => "Any density and any speed: the number of steps in a window.",
        plans => "The official scene, stretched or compressed: whether the programs `planned` and `substep` choose \
                  windows or a list.",
        a_crystal => "Particles in a crystal, three cutoffs apart: the number of neighbours that the planner expects.",
        a_fast_particle => "A nearly empty box, and the same box with one fast particle: the planner's choice. It \
                            must be windows in the first case, and a list in the second.",
        threads_that_pay => "The variant `planned` and a given number of threads: the number of threads that work.",
        steps_counted = |_, ask| steps_on_a_list(ask)
            => "The variant `planned` in a long run with a list: how often, on average, a particle is accessed \
                (read or written) in a step.",
        planned after "11.1, 11.2, 11.3, 11.4, 11.5" = |_, ask| follows_the_model(ask, by_choice("11.6"), 200)
            => "The variant `planned` with the planner's choice: the state after each step, compared with the model.",
        planned_in_windows after "11.1, 11.2, 11.3, 11.4, 11.5" = |_, ask| follows_the_model(ask, in_windows("11.6"), 40)
            => "The variant `planned` in windows of 6 steps: the state after each step, compared with the model.",
        statistics after "11.1, 11.2, 11.3, 11.4, 11.5" => "The variant `planned`: dmin, davg and navg of each step.",
        memory after "11.1, 11.2, 11.3, 11.4, 11.5" = |_, ask| by_choice("11.6").keeps_its_memory(ask)
            => "A long run with the planner's choice: the memory in use, which must not grow with the number of \
                steps.",
        memory_in_windows after "11.1, 11.2, 11.3, 11.4, 11.5" = |_, ask| in_windows("11.6").keeps_its_memory(ask)
            => "A long run in windows: the memory in use, which must not grow with the number of steps.",
        official_bytes after "11.1, 11.2, 11.3, 11.4, 11.5" = |_, ask| official_output(ask)
            => "The variant `planned` in the official scene of 1,000 particles: the output of 1,000 steps, byte for \
                byte.",
        neighbour_list after "11.1, 11.2, 11.3, 11.4, 11.5" = |_, ask| beside_the_list(ask)
            => "The variant `planned` with 3,000 particles, 200 steps: the state at the end, compared with the state \
                that a neighbour list reaches.",
        any_threads after "11.1, 11.2, 11.3, 11.4, 11.5" = |_, ask| planned_on_threads(ask)
            => "The variant `planned` on 1 to 8 threads: the state at the end. It must have the same bits for every \
                number of threads.",
        steps_in_a_row after "11.1, 11.2, 11.3, 11.4, 11.5" => "Several steps in a row, and as many single steps: the \
                                                                state at the end. It must have the same bits in both \
                                                                cases.",
        small_steps after "11.1, 11.2, 11.3, 11.4, 11.5" => "The variant `substep` in the official scene, 100 steps: \
                                                             the state at the end, compared with a run in which all \
                                                             particles take small steps.",
        small_steps_anywhere after "11.1, 11.2, 11.3, 11.4, 11.5" => "The variant `substep` in hard scenes: the state \
                                                                      after each of 3 steps, compared with a run in \
                                                                      which all particles take ten small steps in \
                                                                      each step.",
        bent_paths after "11.1, 11.2, 11.3, 11.4, 11.5" => "The variant `substep` with overlapping particles that \
                                                            push each other far: the state at the end. It must have \
                                                            the same bits in windows of 1 step and of 9 steps.",
        small_steps_any_threads after "11.1, 11.2, 11.3, 11.4, 11.5" = |_, ask| substep_on_threads(ask)
            => "The variant `substep` on 1 to 8 threads: the state at the end. It must have the same bits for every \
                number of threads.",
    }
}

/// Returns runs of a variant of this lab. An unsolved starter stops at the `todo!` of `task`.
fn variant(task: &'static str, variant: &str) -> Runs {
    if task == "11.5" {
        meets_wall(&Span { steps: 8, dt: DT, size: 1.0 }, 0.5, 0.5, 1.0, 1.0);
    } else {
        window_length(2000.0, 0.5);
    }
    Runs::new(task, VARIANTS, variant)
}

/// Returns runs of `planned` with the planner's choice, a list for most scenes. All threads are
/// used, even in small scenes.
fn by_choice(task: &'static str) -> Runs {
    variant(task, "planned").set("share", 1.0)
}

/// Returns runs of `planned` in windows of 6 steps.
fn in_windows(task: &'static str) -> Runs {
    by_choice(task).set("window", 6.0)
}

fn official_output(ask: &mut impl Ask) {
    by_choice("11.6").official_bytes(ask);
    in_windows("11.6").official_bytes(ask);
}

fn statistics(_: &mut oracle::Random, ask: &mut impl Ask) {
    let planned = variant("11.6", "planned");
    planned.statistics_of_each_step(ask, &scenes::dense(), 10);
    planned.set("window", 4.0).statistics_of_each_step(ask, &scenes::official(), 10);
}

fn planned_on_threads(ask: &mut impl Ask) {
    let threads = [1, 2, 3, 4, 8];
    by_choice("11.6").same_bits_on_threads(ask, &scenes::cloud(1000, 30.0, 3), 20, &threads);
    let scene = Scene::official(2000, 2).expect("the scene is valid");
    in_windows("11.6").same_bits_on_threads(ask, &scene, 20, &threads);
}

fn substep_on_threads(ask: &mut impl Ask) {
    let scene = Scene::official(10_000, 2).expect("the scene is valid");
    let substep = variant("11.6", "substep").set("share", 1.0);
    substep.same_bits_on_threads(ask, &scene, 20, &[1, 2, 3, 8]);
    substep.same_bits_on_threads(ask, &scattered(3000, 0.6, 7), 20, &[1, 2, 3, 8]);
}
