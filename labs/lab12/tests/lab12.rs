//! Lab 12's graders.

use common::soft::Particle;
use lab12::VARIANTS;
use oracle::{Ask, Runs, scenes};

#[path = "lab12/examples.rs"]
mod examples;
#[path = "lab12/falls.rs"]
mod falls;
#[path = "lab12/methods.rs"]
mod methods;
#[path = "lab12/moments.rs"]
mod moments;
#[path = "lab12/whole_runs.rs"]
mod whole_runs;

use examples::*;
use falls::*;
use methods::*;
use moments::*;
use whole_runs::*;

oracle::questions! {
    task_12_1 {
        drifts_and_kicks => "A step of length 1 by three compositions: (1) the time of each drift and of each kick, \
                             (2) the times that positions and velocities have reached afterwards.",
        steps => "A step of any composition: its drifts (0) and kicks (1) in their order, each with its time.",
        velocity_verlet => "Velocity Verlet: its drifts and its kicks, as fractions of a step.",
        pefrl => "PEFRL: its drifts and its kicks, as fractions of a step.",
        official_steps = |_, ask| variant("12.1", "euler").resynchronised(ask, &scenes::official(), 50)
            => "The variant `euler` in the official scene: the state after each of 50 steps. Each step must be the \
                official step.",
        dense_box = |_, ask| variant("12.1", "euler").resynchronised(ask, &scenes::dense(), 20)
            => "The variant `euler` with 150 particles in a dense box: the state after each of 20 steps. Each step \
                must be the official step.",
        over_the_edges = |_, ask| variant("12.1", "euler").resynchronised_on_each(ask, scenes::edges(), 3)
            => "The variant `euler` with pairs 0.9995 cutoffs apart, in every direction: the state after each of 3 \
                steps. Each step must be the official step.",
        orders => "Two particles that stay in contact: the order of the error, computed from steps in 4 and in 8 \
                   parts.",
    }
    task_12_2 {
        four_looks => "Two particles on springs, a = -x, and a step of length 1: (1) the positions at which each of \
                       the four evaluations is made, (2) the weighted sum of the slopes.",
        runge_kutta => "Particles in a ring that pull one another: (1) the positions at which each of the four \
                        evaluations is made, (2) the weighted sum of the slopes.",
        memory = |_, ask| variant("12.2", "rk4").keeps_its_memory(ask)
            => "A long run: the memory in use, which must not grow with the number of steps.",
        order => "Two particles that stay in contact: the order of the error of `rk4`, computed from steps in 4 and \
                  in 8 parts.",
        errors after "12.1" => "Two particles that stay in contact, and an official step in 2, 4 and 8 parts: the \
                                error of each method, compared with `rk4` in 256 parts.",
    }
    task_12_3 {
        falling_numbers => "A number that falls through zero between the times low and high: the moment at which it \
                            falls through zero.",
        crossings => "A number that falls in any way and in any units: (1) the moment at which it falls through zero, \
                      (2) how often the number was evaluated.",
        faint_crossings => "A line so near to zero that a product of two of its values may be rounded to 0: the \
                            moment at which it falls through zero.",
        contacts => "Two particles that collide head-on: (1) the number of steps for which they stay in reach, (2) \
                     their least distance.",
    }
    task_12_4 {
        watched_numbers after "12.3" => "A number, with its value and its slope at both ends of a step of length 1: \
                                         the time at which it falls through zero.",
        decided_at_the_ends => "A number whose fall can be decided from its values and slopes at both ends of a step: \
                                the time at which it falls through zero.",
        decided_inside after "12.3" => "A number that turns or falls inside a step: the time at which it falls \
                                        through zero.",
        a_touch after "12.3" => "The number (t - 1)² in a step of length 2, which touches zero: there must be no \
                                 time, because the number does not fall through zero.",
        across_the_cutoff after "12.2, 12.3" => "Two particles that come into reach, one of them after a collision \
                                                 with a wall: the errors of `rk4-located`. They must be of fourth \
                                                 order.",
        exact_motion after "12.2, 12.3" => "300 particles, and 100 official steps of `rk4-located`: the distance of \
                                            the particles from the exact motion.",
        any_threads after "12.2, 12.3" => "The variant `rk4-located` on 1 to 8 threads: the state at the end. It must \
                                           have the same bits for every number of threads.",
    }
}

/// Returns runs of a variant of this lab.
fn variant(task: &'static str, variant: &str) -> Runs {
    Runs::new(task, VARIANTS, variant)
}

fn any_threads(_: &mut oracle::Random, ask: &mut impl Ask) {
    starts_with_the_fall();
    let scene = common::soft::Scene::official(1000, 2).expect("the scene is valid");
    let located = variant("12.4", "rk4-located");
    located.same_bits_on_threads(ask, &scene, 20, &[1, 2, 3, 4, 8]);
    located.same_bits_on_threads(ask, &scenes::crowd(1), 3, &[1, 2, 4]);
}

/// Returns the greatest distance of a particle from its correct position.
fn farthest(a: &[Particle], b: &[Particle]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a.x - b.x).hypot(a.y - b.y)).fold(0.0, f64::max)
}
