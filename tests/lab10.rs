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
        drift_table => "Three particles in a box of side 1, before a step of 0.5 and after it, twice. The velocity at index 3 \
                        is behind the particles and stays as it is.",
        moves => "Any number of particles, some of which may leave the box: velocities and positions after a step, and whether \
                  any particle is outside.",
        walls => "A particle on a wall, or as little as possible beside it: whether any particle is outside. On a wall is \
                  inside.",
    }
    task_10_2 {
        pairs_table => "A dozen particles in a row: the particles behind each that are within a reach of 1, 1.5 and 2 cutoffs.",
        lists => "Any range of particles and any reach: the pairs within reach, in ascending order, behind those found before.",
        reaches => "Particles at the reach and a little beside it: the pairs within reach. At the reach is within.",
    }
    task_10_3 {
        expiry_table => "A displacement and a skin, in one unit of length: whether the list has expired. Both particles of a \
                         pair can go so far.",
        skins_table => "Neighbours at random, and how far a particle goes in a step, in cutoffs c: the cheapest skin, in \
                        cutoffs.",
        expiry => "A displacement of half a skin, and a little more or less: whether the list has expired.",
        skins => "Any density and any displacement: the cheapest skin of 0.05, 0.1, … 3 cutoffs.",
    }
    task_10_4 {
        filter_table => "Four particles on a line, the first of which has the index 10, and five pairs of them: which pairs are \
                         near, for three squared distances.",
        near => "Any pairs of any particles: the pairs that are near, in their order.",
        verlet_steps after "10.1, 10.2, 10.3" => "The variant neighbour-list, which calls your functions, in dense and sparse \
                                                  boxes: each step.",
        verlet_statistics after "10.1, 10.2, 10.3" => "The variant neighbour-list: dmin, davg and navg of each step.",
        verlet_bytes after "10.1, 10.2, 10.3" => "The variant neighbour-list, the official scene: the output of 1,000 steps, \
                                                  byte for byte.",
        verlet_threads after "10.1, 10.2, 10.3" => "The variant neighbour-list on 1, 2, 3, 4 and 8 threads: the same bits.",
        in_a_row after "10.1, 10.2, 10.3" => "The variant neighbour-list, steps in a row and one by one: the same bits.",
        long_rows after "10.1, 10.2, 10.3" => "The variant neighbour-list, 9,000 particles in a flat strip: each step.",
        outliers after "10.1, 10.2, 10.3" => "The variant neighbour-list, three of 2,000 particles too fast for the list: each \
                                              step.",
        heating_up after "10.1, 10.2, 10.3" => "The variant neighbour-list, particles that become too fast for the list: it is \
                                                made for their new speed.",
    }
    task_10_5 {
        lists_table after "10.2, 10.4" => "Five particles on a line at 1, 1.8, 2.6, 4.4 and 6.9 cutoffs, which go 0.05 cutoffs in \
                                           a step, and a skin of 1 cutoff: both lists after `rebuild` and after \
                                           `rebuild_inner`.",
        outer_lists after "10.2" => "The outer list of any scene, built twice: all pairs within reach, each once, its skin and \
                                     both displacements.",
        inner_lists after "10.2, 10.4" => "The inner list of any scene, made twice: the near pairs of the outer list in their \
                                           order, its skin and its displacement.",
        margins after "10.2, 10.4" => "Two particles a hair further apart than cutoff and skin: both lists have the pair.",
        chosen_skins after "10.2, 10.3, 10.4" => "No skin was asked for: the skins of both lists follow from the distance that \
                                                  the fastest particle goes in a step.",
    }
    task_10_6 {
        forces_table after "10.2, 10.4, 10.5" => "Four particles at rest, particle 3 alone: the accelerations of each, computed \
                                                  twice.",
        steps_table after "10.1, 10.2, 10.3, 10.4, 10.5" => "Two particles that fly towards each other, 0.05 cutoffs in a step \
                                                             each, with a skin of 0.37 cutoffs: how far apart they are, the \
                                                             pairs in the outer list, and both displacements, in cutoffs.",
        accelerations after "10.2, 10.4, 10.5" => "Any scene: the accelerations of all particles, computed twice, and with an \
                                                   empty list.",
        ages after "10.1, 10.2, 10.3, 10.4, 10.5" => "Particles that push each other apart: after each step both lists are \
                                                      older by as far as the fastest particle went in it.",
        two_meet after "10.1, 10.2, 10.3, 10.4, 10.5" => "Two particles that meet after half a skin each: each of 40 steps.",
        steps after "10.1, 10.2, 10.3, 10.4, 10.5" => "Your engine with both lists, without an inner list, and with a thin \
                                                       skin: each step.",
        drawn_boxes after "10.1, 10.2, 10.3, 10.4, 10.5" => "Your engine in drawn boxes, with an inner list and without: each \
                                                             step.",
        library_bits after "10.1, 10.2, 10.3, 10.4, 10.5" => "Your engine and the library's with a skin so thin that both sort \
                                                              in each step: the same bits.",
        rebuilds after "10.1, 10.2, 10.3, 10.4, 10.5" => "Your engine with a given skin: how many outer lists are built in 100 \
                                                          steps.",
        a_list_lasts after "10.1, 10.2, 10.3, 10.4, 10.5" => "Your engine in the official scene: how long a list lasts, and how \
                                                              many pairs are looked at.",
        official_bytes after "10.1, 10.2, 10.3, 10.4, 10.5" => "Your engine in the official scene: the output of 1,000 steps, \
                                                                byte for byte.",
        statistics after "10.1, 10.2, 10.3, 10.4, 10.5" => "Your engine in a dense box: dmin, davg and navg of each step.",
        memory after "10.1, 10.2, 10.3, 10.4, 10.5" => "Your engine in a long run: the memory that it holds does not grow with \
                                                        the number of steps.",
    }
}
