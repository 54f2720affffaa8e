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
        drifts_and_kicks => "A step of length 1 by three compositions: each drift and each kick for its time, and how far \
                             positions and velocities are then.",
        steps => "A step of any composition: what is done one after the other, each as 0 for a drift or 1 for a kick and \
                  then its time.",
        velocity_verlet => "Velocity Verlet: the drifts and the kicks, as fractions of a step.",
        pefrl => "PEFRL: the drifts and the kicks, as fractions of a step.",
        official_steps = |_, ask| variant("12.1", "euler").resynchronised(ask, &scenes::official(), 50)
            => "Variant euler, the official scene: each of 50 steps is the official step.",
        dense_box = |_, ask| variant("12.1", "euler").resynchronised(ask, &scenes::dense(), 20)
            => "Variant euler, 150 particles in a dense box: each of 20 steps is the official step.",
        over_the_edges = |_, ask| variant("12.1", "euler").resynchronised_on_each(ask, scenes::edges(), 3)
            => "Variant euler, pairs at 0.9995 cutoffs in every direction: each of 3 steps is the official step.",
        orders => "Two particles that stay in contact: by how much the error shrinks if the parts of a step are half as \
                   long.",
    }
    task_12_2 {
        four_looks => "Two particles on springs, a = -x, and a step of length 1: where each of the four looks is, and the \
                       weighted sum of the slopes.",
        runge_kutta => "Particles that pull one another, in a ring: where each of the four looks is, and the weighted sum \
                        of the slopes.",
        memory = |_, ask| variant("12.2", "rk4").keeps_its_memory(ask)
            => "A long run: the memory that it holds does not grow with the number of steps.",
        order => "Two particles that stay in contact: by how much the error of rk4 shrinks if the parts of a step are half \
                  as long.",
        errors after "12.1" => "Two particles that stay in contact, an official step in 2, 4 and 8 parts: the error of each \
                                method beside rk4 with 256 parts.",
    }
    task_12_3 {
        falling_numbers => "A number that falls through zero between low and high: the moment.",
        crossings => "A number that falls in any way and in any units: the moment, and how often the number was looked at.",
        faint_crossings => "A line so near to zero that a product of two numbers may be 0: the moment.",
        contacts => "Two particles meet head on: how long they stay in reach, and how near they come.",
    }
    task_12_4 {
        watched_numbers after "12.3" => "A number with its value and its slope at both ends of a step of length 1: when it \
                                         falls through zero.",
        told_by_the_ends => "A number of which both ends of a step tell all: when it falls through zero.",
        told_inside after "12.3" => "A number that turns or falls inside a step: when it falls through zero.",
        a_touch after "12.3" => "(t - 1)² in a step of 2: it touches zero and does not fall.",
        across_the_cutoff after "12.2, 12.3" => "Two particles come into reach, one past a wall: the error of rk4-located \
                                                 is of fourth order.",
        exact_motion after "12.2, 12.3" => "300 particles, 100 official steps of rk4-located: how far they are from the \
                                            exact motion.",
        any_threads after "12.2, 12.3" => "Variant rk4-located on 1 to 8 threads: the same bits.",
    }
}

/// Returns runs of a variant of this lab.
fn variant(task: &'static str, variant: &str) -> Runs {
    Runs::new(task, VARIANTS, variant)
}

fn any_threads(_: &mut oracle::Random, ask: &mut impl Ask) {
    starts_with_the_fall();
    let scene = common::soft::Scene::official(1000, 2).expect("the scene is sound");
    let located = variant("12.4", "rk4-located");
    located.same_bits_on_threads(ask, &scene, 20, &[1, 2, 3, 4, 8]);
    located.same_bits_on_threads(ask, &scenes::crowd(1), 3, &[1, 2, 4]);
}

/// Returns the greatest distance of a particle from its correct position.
fn farthest(a: &[Particle], b: &[Particle]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a.x - b.x).hypot(a.y - b.y)).fold(0.0, f64::max)
}
