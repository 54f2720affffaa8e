//! Lab 1's graders.

use lab1::{Tally, VARIANTS};
use oracle::{Ask, Runs, scenes};

#[path = "lab1/examples.rs"]
mod examples;
#[path = "lab1/questions.rs"]
mod questions;

use examples::*;
use questions::*;

oracle::questions! {
    task_1_1 {
        force_table => "A particle and a neighbour at nine distances, in the direction (0.6, 0.8): the acceleration \
                        (ax, ay) of the particle; none beyond the cutoff.",
        opposite => "A particle and a neighbour, and the two exchanged: the neighbour pushes away, along the line \
                     between the two, and the two accelerations are opposite.",
        forces => "A neighbour anywhere, near or far: the acceleration of the particle, [] for none.",
    }
    task_1_2 {
        bounce_table => "A particle that would fly to x with velocity v, in a box from 0 to 1: where it ends, and its \
                         velocity there.",
        bounces => "A particle that would fly to x with velocity v, in a box of any size: where it ends, and its velocity \
                    there.",
        velocity_first => "A particle with the acceleration a: the velocity changes first, and the position follows with \
                           the new velocity.",
        far_outside => "A particle that would fly so far that reflections one by one do not come to an end: where it ends, \
                        and its velocity there.",
    }
    task_1_3 {
        step_table after "1.1, 1.2" => "Three particles before a step and after it, in a box of ten cutoffs: particles 0 \
                                        and 1 are half a cutoff apart, particle 2 is alone.",
        looks => "A step of any number of particles: how many pairs the observer was told of.",
        steps after "1.1, 1.2" => "A step of any number of particles: x, y, vx, vy of each.",
        at_the_cutoff after "1.1" => "Two particles exactly a cutoff from a third: how many pairs within the cutoff the \
                                      observer was told of.",
        dense_box after "1.1, 1.2" = |_, ask| all_pairs("1.3").resynchronised(ask, &scenes::dense(), 20)
            => "150 particles in a dense box: each of 20 steps, from where the program itself was before the step.",
        one_position after "1.1, 1.2" = |_, ask| all_pairs("1.3").resynchronised(ask, &scenes::close_pairs(), 5)
            => "Pairs at 0, 0.003 and 0.005 cutoffs, and particles on walls: each of 5 steps.",
        fast after "1.1, 1.2" => "Particles so fast that a step takes them through the box several times: each of 20 steps.",
        crowds after "1.1, 1.2" = |_, ask| all_pairs("1.3").forces(ask)
            => "Crowds at rest: the acceleration of each particle, and all of them together, which must cancel.",
        bits after "1.1, 1.2" => "Dense boxes: the bits of sums in ascending order of the neighbours.",
        over_the_edges after "1.1, 1.2" = |_, ask| all_pairs("1.3").resynchronised_on_each(ask, scenes::edges(), 1)
            => "Pairs at 0.9995 cutoffs, in every direction: one step.",
        many_particles after "1.1, 1.2" => "A step of 4,097 particles: x, y, vx, vy of each.",
        memory = |_, ask| all_pairs("1.3").keeps_its_memory(ask)
            => "A long run: the memory that it holds does not grow with the number of steps.",
        official_run after "1.1, 1.2" = |_, ask| all_pairs("1.3").resynchronised(ask, &scenes::official(), 1000)
            => "The official scene, 1,000 particles: each of 1,000 steps, from where the program itself was before the step.",
        official_bytes after "1.1, 1.2" = |_, ask| all_pairs("1.3").official_bytes(ask)
            => "The official scene, 1,000 particles: the output of 1,000 steps, byte for byte.",
    }
    task_1_4 {
        tally_table => "A tally that sees six distances, one after another: dmin, davg and navg after each.",
        tallies => "A tally of any number of pairs, some of them at one position: navg, dmin and davg.",
        statistics after "1.1, 1.2, 1.3" => "Dense boxes: dmin, davg and navg of each step.",
        long_statistics after "1.1, 1.2, 1.3" => "The second half of the official run: neighbours per particle, absmin, \
                                                  absavg, and the energy.",
    }
    task_1_5 {
        energy_table => "Three particles, 0.5 cutoffs, 2 cutoffs and no distance apart: the potential of each pair, and \
                         the energies and the momentum of all.",
        potentials => "A pair at any distance: its potential.",
        energies => "Any number of particles, slow and fast: the energy of motion, the momentum, and the potential energy.",
        a_collision after "1.1, 1.2, 1.3" => "Two particles that collide and part again: the energy returns, and no \
                                              momentum is gained.",
    }
}

/// Returns runs of the variant `all-pairs`.
fn all_pairs(task: &'static str) -> Runs {
    if task == "1.4" {
        // Calls this task's function first, so that an unsolved starter stops at this task's
        // `todo!`.
        common::soft::Observer::seen(&mut Tally::default(), 0.0);
    }
    Runs::new(task, VARIANTS, "all-pairs")
}

fn fast(_: &mut oracle::Random, ask: &mut impl Ask) {
    for scene in scenes::fast() {
        all_pairs("1.3").resynchronised(ask, &scene, 20);
    }
}

fn bits(_: &mut oracle::Random, ask: &mut impl Ask) {
    all_pairs("1.3").bits_of_all_pairs(ask, &scenes::dense(), 20);
    all_pairs("1.3").bits_of_all_pairs(ask, &scenes::crowd(3), 5);
}

fn statistics(_: &mut oracle::Random, ask: &mut impl Ask) {
    all_pairs("1.4").statistics_of_each_step(ask, &scenes::dense(), 20);
    all_pairs("1.4").statistics_of_each_step(ask, &scenes::close_pairs(), 3);
}

fn long_statistics(_: &mut oracle::Random, ask: &mut impl Ask) {
    all_pairs("1.4").long_statistics(ask);
}
