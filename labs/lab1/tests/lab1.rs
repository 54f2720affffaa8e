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
        force_table => "A neighbour at nine distances in the direction (0.6, 0.8): the particle's acceleration, ax \
                        and ay. Beyond the cutoff the neighbour causes no acceleration.",
        opposite => "A pair of particles: the accelerations of both particles. They must be opposite and along the \
                     line between the particles, and each must point away from the other particle.",
        forces => "A neighbour at any distance: the particle's acceleration, ax and ay, or [] beyond the cutoff.",
    }
    task_1_2 {
        bounce_table => "A box from 0 to 1. Without walls, a particle would fly to x with velocity v: the particle's \
                         position and velocity after reflections.",
        bounces => "A box of any size. Without walls, a particle would fly to x with velocity v: the particle's \
                    position and velocity after reflections.",
        velocity_first => "A particle with the acceleration a: its velocity and position after a step. The velocity \
                           changes first, and then the position changes by the new velocity times the step.",
        far_outside => "A particle that would fly very far out of the box: its position and velocity after \
                        reflections. A loop over single reflections would never end.",
    }
    task_1_3 {
        step_table after "1.1, 1.2" => "Three particles in a box of ten cutoffs: their states before and after a step. \
                                        Particles 0 and 1 are half a cutoff apart, and particle 2 is alone.",
        looks => "A step of any number of particles: the number of pair tests reported to the observer.",
        steps after "1.1, 1.2" => "A step of any number of particles: x, y, vx, vy of each particle.",
        at_the_cutoff after "1.1" => "Two particles that are each exactly one cutoff from a third particle: the \
                                      number of pairs that are reported to the observer as within the cutoff.",
        dense_box after "1.1, 1.2" = |_, ask| all_pairs("1.3").resynchronised(ask, &scenes::dense(), 20)
            => "150 particles in a dense box: the state after each of 20 steps. The test's model starts each step \
                from the state that your program had before the step.",
        one_position after "1.1, 1.2" = |_, ask| all_pairs("1.3").resynchronised(ask, &scenes::close_pairs(), 5)
            => "Pairs 0, 0.003 and 0.005 cutoffs apart, and particles on walls: the state after each of 5 steps.",
        fast after "1.1, 1.2" => "Particles that cross the box several times in a step: the state after each of 20 \
                                  steps.",
        crowds after "1.1, 1.2" = |_, ask| all_pairs("1.3").forces(ask)
            => "Crowds at rest: the acceleration of each particle. The forces of a crowd must add up to zero.",
        bits after "1.1, 1.2" => "Dense boxes: the state after each step, bit for bit. Forces must be summed in \
                                  ascending order of the neighbours' ids.",
        over_the_edges after "1.1, 1.2" = |_, ask| all_pairs("1.3").resynchronised_on_each(ask, scenes::edges(), 1)
            => "Pairs 0.9995 cutoffs apart, in every direction: the state after one step.",
        many_particles after "1.1, 1.2" => "A step of 4,097 particles: x, y, vx, vy of each particle.",
        memory = |_, ask| all_pairs("1.3").keeps_its_memory(ask)
            => "A long run: the memory in use, which must not grow with the number of steps.",
        official_run after "1.1, 1.2" = |_, ask| all_pairs("1.3").resynchronised(ask, &scenes::official(), 1000)
            => "The official scene of 1,000 particles: the state after each of 1,000 steps. The test's model starts \
                each step from the state that your program had before the step.",
        official_bytes after "1.1, 1.2" = |_, ask| all_pairs("1.3").official_bytes(ask)
            => "The official scene of 1,000 particles: the output of 1,000 steps, byte for byte.",
    }
    task_1_4 {
        tally_table => "A tally that sees six distances, one after another: dmin, davg and navg after each distance.",
        tallies => "A tally that sees any number of pairs, some of which have both particles at one position: navg, \
                    dmin and davg.",
        statistics after "1.1, 1.2, 1.3" => "Dense boxes: dmin, davg and navg of each step.",
        long_statistics after "1.1, 1.2, 1.3" => "Steps 501 to 1,000 of the official scene: neighbours per particle, \
                                                  absmin, absavg, and the relative change of the energy.",
    }
    task_1_5 {
        energy_table => "Three pairs, 0.5, 2 and 0 cutoffs apart: the potential of each pair. Then three particles: \
                         their kinetic and potential energy, and their momentum.",
        potentials => "A pair of particles at any distance: the potential of the pair.",
        energies => "Any number of particles, slow and fast: their kinetic energy, their momentum, and their \
                     potential energy.",
        a_collision after "1.1, 1.2, 1.3" => "Two particles that collide and fly apart again: the relative change of \
                                              the energy, which must be small, and the momentum, which must stay \
                                              zero.",
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
