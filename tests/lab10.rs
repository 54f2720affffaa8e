#[path = "lab10/engine.rs"]
mod engine;
#[path = "lab10/examples.rs"]
mod examples;
#[path = "lab10/forces.rs"]
mod forces;
#[path = "lab10/library.rs"]
mod library;
#[path = "lab10/lists.rs"]
mod lists;
#[path = "lab10/primitives.rs"]
mod primitives;
#[path = "lab10/scenes.rs"]
mod scenes;
#[path = "lab10/skins.rs"]
mod skins;

use engine::*;
use examples::*;
use forces::*;
use library::*;
use lists::*;
use primitives::*;
use skins::*;

oracle::questions! {
    task_10_1 {
        drift_table => "Three particles in a box of side 1: velocities and positions after each of two calls with a step of 0.5. \
                        The velocity at index 3, after those of the particles, must stay as it is.",
        moves => "Any number of particles, some of which may leave the box: velocities and positions after a step, and \
                  whether any particle is outside.",
        walls => "A particle on a wall, or a rounding error beside it: whether any particle is outside. A particle on \
                  a wall is inside.",
    }
    task_10_2 {
        pairs_table => "A dozen particles in a row: for each particle the later particles within a reach of 1, 1.5 and \
                        2 cutoffs.",
        lists => "Any range of particles and any reach: the pairs within reach, in ascending order, which follow the \
                  pairs from before.",
        reaches => "Particles at the reach, or a rounding error beside it: the pairs within reach. A pair at the reach \
                    is within.",
    }
    task_10_3 {
        expiry_table => "A displacement and a skin, in the same unit of length: whether the list has expired. Both \
                         particles of a pair may have moved by the displacement.",
        skins_table => "The mean number of neighbours, and the distance that a particle goes in a step, in cutoffs c: \
                        the cheapest skin, in cutoffs.",
        expiry => "A displacement of half a skin, or a rounding error beside it: whether the list has expired.",
        skins => "Any density and any displacement: the cheapest skin, one of 0.05, 0.1, … 3 cutoffs.",
    }
    task_10_4 {
        filter_table => "Four particles on a line, the first with index 10, and five pairs of them: the pairs that are \
                         near, for three squared distances.",
        near => "Any pairs of any particles: the pairs that are near, in the order of the given pairs.",
        verlet_steps after "10.1, 10.2, 10.3" => "The variant `neighbour-list`, which calls your functions, in dense \
                                                  and sparse boxes: the state after each step.",
        verlet_statistics after "10.1, 10.2, 10.3" => "The variant `neighbour-list`: dmin, davg and navg of each \
                                                       step.",
        verlet_bytes after "10.1, 10.2, 10.3" => "The variant `neighbour-list` in the official scene: the output of \
                                                  1,000 steps, byte for byte.",
        verlet_threads after "10.1, 10.2, 10.3" => "The variant `neighbour-list` on 1, 2, 3, 4 and 8 threads: the \
                                                    state at the end, with the same bits on each number of threads.",
        in_a_row after "10.1, 10.2, 10.3" => "The variant `neighbour-list` in several steps in a row, and one by one: \
                                              the state at the end, with the same bits.",
        long_rows after "10.1, 10.2, 10.3" => "The variant `neighbour-list` with 9,000 particles in a flat strip: the \
                                               state after each step.",
        outliers after "10.1, 10.2, 10.3" => "The variant `neighbour-list` with 2,000 particles, three of which are \
                                              too fast for the list: the state after each step.",
        heating_up after "10.1, 10.2, 10.3" => "The variant `neighbour-list` with particles that become too fast for \
                                                the list: the share of particles that outruns it. A new list must suit \
                                                the new speeds.",
    }
    task_10_5 {
        lists_table after "10.2, 10.4" => "Five particles on a line at 1, 1.8, 2.6, 4.4 and 6.9 cutoffs, which go 0.05 \
                                           cutoffs in a step, and a skin of 1 cutoff: both lists after `rebuild`, and \
                                           the inner list after `rebuild_inner`.",
        outer_lists after "10.2" => "The outer list of any scene, built twice: its pairs, which are all pairs within \
                                     reach, each once; its skin; and both displacements.",
        inner_lists after "10.2, 10.4" => "The inner list of any scene, built twice: its pairs, which are the near \
                                           pairs of the outer list in their order; its skin; and its displacement.",
        margins after "10.2, 10.4" => "Two particles that are a rounding error further apart than cutoff and skin: the \
                                       pair in both lists.",
        chosen_skins after "10.2, 10.3, 10.4" => "Lists for which no skin is given: the skins of both lists, which \
                                                  follow from the distance that the fastest particle goes in a step.",
    }
    task_10_6 {
        forces_table after "10.2, 10.4, 10.5" => "Four particles at rest, particle 3 alone: the acceleration of each \
                                                  particle, computed twice.",
        steps_table after "10.1, 10.2, 10.3, 10.4, 10.5" => "Two particles that fly towards each other, 0.05 cutoffs \
                                                             in a step each, with a skin of 0.37 cutoffs: their \
                                                             distance, the number of outer pairs, and both \
                                                             displacements after each step, in cutoffs.",
        accelerations after "10.2, 10.4, 10.5" => "Any scene: the accelerations of all particles, computed twice, and \
                                                   with an empty list.",
        ages after "10.1, 10.2, 10.3, 10.4, 10.5" => "Particles that push each other apart: the displacements of both \
                                                      lists after each step, which must grow by the distance that the \
                                                      fastest particle goes in it.",
        two_meet after "10.1, 10.2, 10.3, 10.4, 10.5" => "Two particles that meet after half a skin each: the state \
                                                          after each of 40 steps.",
        steps after "10.1, 10.2, 10.3, 10.4, 10.5" => "Your engine with both lists, without an inner list, and with a \
                                                       thin skin: the state after each step.",
        drawn_boxes after "10.1, 10.2, 10.3, 10.4, 10.5" => "Your engine in random boxes, with an inner list and \
                                                             without: the state after each step.",
        library_bits after "10.1, 10.2, 10.3, 10.4, 10.5" => "Your engine and the library's, with a skin so thin that \
                                                              both sort in each step: the state at the end, with the \
                                                              same bits.",
        rebuilds after "10.1, 10.2, 10.3, 10.4, 10.5" => "Your engine with a given skin: the number of outer lists \
                                                          built in 100 steps.",
        a_list_lasts after "10.1, 10.2, 10.3, 10.4, 10.5" => "Your engine in the official scene: the number of steps \
                                                              that a list lasts, and the number of pair tests for each \
                                                              particle in a step.",
        official_bytes after "10.1, 10.2, 10.3, 10.4, 10.5" => "Your engine in the official scene: the output of 1,000 \
                                                                steps, byte for byte.",
        statistics after "10.1, 10.2, 10.3, 10.4, 10.5" => "Your engine in a dense box: dmin, davg and navg of each step.",
        memory after "10.1, 10.2, 10.3, 10.4, 10.5" => "Your engine in a long run: the memory in use, which must not \
                                                        grow with the number of steps.",
    }
}
