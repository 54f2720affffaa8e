//! Lab 10's graders.

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
        drift_table => "Three particles in a box of side 1: velocities and positions after each of two calls with a \
                        step of 0.5. Index 3 belongs to no particle, so the velocity at this index must not change.",
        moves => "Any number of particles, some of which may leave the box: (1) velocities and positions after a \
                  step, (2) whether any particle is outside.",
        walls => "A particle on a wall, or a rounding error beside the wall: whether any particle is outside. A \
                  particle on a wall is inside.",
    }
    task_10_2 {
        pairs_table => "A dozen particles in a row: for each particle, the later particles within a reach of 1, 1.5 \
                        and 2 cutoffs.",
        lists => "Any range of particles and any reach: the pairs within reach, in ascending order. They are appended \
                  to the pairs that the list already contains.",
        reaches => "Particles at exactly the reach, or a rounding error nearer or farther: the pairs within reach. A \
                    pair at exactly the reach is within it.",
    }
    task_10_3 {
        expiry_table => "A displacement and a skin, in the same unit of length: whether the list has expired. Both \
                         particles of a pair may have moved by the displacement.",
        skins_table => "Several average numbers of neighbours, and several distances that a particle moves in a \
                        step, in units of the cutoff c: the cheapest skin, in cutoffs.",
        expiry => "A displacement of exactly half a skin, or a rounding error more or less: whether the list has \
                   expired.",
        skins => "Any density and any displacement: the cheapest of the skins 0.05, 0.1, … 3 cutoffs.",
    }
    task_10_4 {
        filter_table => "Four particles on a line, the first of which has index 10, and five pairs of them: for three \
                         limits, the pairs whose squared distance is at most the limit.",
        near => "Any pairs of any particles: the pairs whose squared distance is at most a limit, in the order of the \
                 given pairs.",
        verlet_steps after "10.1, 10.2, 10.3" => "The variant `neighbour-list`, which calls your functions, in dense \
                                                  and sparse boxes: the state after each step.",
        verlet_statistics after "10.1, 10.2, 10.3" => "The variant `neighbour-list`: dmin, davg and navg of each \
                                                       step.",
        verlet_bytes after "10.1, 10.2, 10.3" => "The variant `neighbour-list` in the official scene: the output of \
                                                  1,000 steps, byte for byte.",
        verlet_threads after "10.1, 10.2, 10.3" => "The variant `neighbour-list` on 1, 2, 3, 4 and 8 threads: the \
                                                    state at the end. It must have the same bits for every number of \
                                                    threads.",
        in_a_row after "10.1, 10.2, 10.3" => "The variant `neighbour-list`, once in several steps in a row and once \
                                              in single steps: the state at the end. It must have the same bits in \
                                              both cases.",
        long_rows after "10.1, 10.2, 10.3" => "The variant `neighbour-list` with 9,000 particles in a flat strip: the \
                                               state after each step.",
        outliers after "10.1, 10.2, 10.3" => "The variant `neighbour-list` with 2,000 particles, three of which are \
                                              too fast for the list: the state after each step.",
        heating_up after "10.1, 10.2, 10.3" => "The variant `neighbour-list` with particles that become too fast for \
                                                the list: the share of the particles that outrun the list. A new list \
                                                must suit the new speeds.",
    }
    task_10_5 {
        lists_table after "10.2, 10.4" => "Five particles on a line at 1, 1.8, 2.6, 4.4 and 6.9 cutoffs, which go \
                                           0.05 cutoffs in a step, and a skin of 1 cutoff: both lists after \
                                           `rebuild`, and the inner list after `rebuild_inner`.",
        outer_lists after "10.2" => "The outer list of any scene, built twice: (1) its pairs, (2) its skin, (3) the \
                                     displacements of both lists. The pairs must be all pairs within reach, each \
                                     listed once.",
        inner_lists after "10.2, 10.4" => "The inner list of any scene, built twice: (1) its pairs, (2) its skin, (3) \
                                           its displacement. The pairs must be the near pairs of the outer list, in \
                                           the order of the outer list.",
        margins after "10.2, 10.4" => "Two particles whose distance is a rounding error greater than the cutoff plus \
                                       the skin: the pairs in both lists. Both lists must contain the pair.",
        chosen_skins after "10.2, 10.3, 10.4" => "Lists for which no skin is given: the skins of both lists. They \
                                                  follow from the distance that the fastest particle moves in a step.",
    }
    task_10_6 {
        forces_table after "10.2, 10.4, 10.5" => "Four particles at rest, of which particle 3 has no neighbour: the \
                                                  acceleration of each particle, computed twice.",
        steps_table after "10.1, 10.2, 10.3, 10.4, 10.5" => "Two particles that fly towards each other, each 0.05 \
                                                             cutoffs in a step, with a skin of 0.37 cutoffs. After \
                                                             each step, in cutoffs: (1) the distance of the \
                                                             particles, (2) the number of outer pairs, (3) the \
                                                             displacements of both lists.",
        accelerations after "10.2, 10.4, 10.5" => "Any scene: the accelerations of all particles, computed twice, and \
                                                   then once more with an empty list.",
        ages after "10.1, 10.2, 10.3, 10.4, 10.5" => "Particles that push each other apart: the displacements of both \
                                                      lists after each step. They must grow by the distance that the \
                                                      fastest particle moves in this step.",
        two_meet after "10.1, 10.2, 10.3, 10.4, 10.5" => "Two particles that meet after each of them has gone half a \
                                                          skin: the state after each of 40 steps.",
        steps after "10.1, 10.2, 10.3, 10.4, 10.5" => "Your engine with both lists, without an inner list, and with a \
                                                       thin skin: the state after each step.",
        drawn_boxes after "10.1, 10.2, 10.3, 10.4, 10.5" => "Your engine in random boxes, with an inner list and \
                                                             without one: the state after each step.",
        library_bits after "10.1, 10.2, 10.3, 10.4, 10.5" => "Your engine and the library's engine, with a skin so \
                                                              thin that both engines sort the particles in each step: \
                                                              the state at the end. It must have the same bits in \
                                                              both engines.",
        rebuilds after "10.1, 10.2, 10.3, 10.4, 10.5" => "Your engine with a given skin: the number of outer lists \
                                                          built in 100 steps.",
        a_list_lasts after "10.1, 10.2, 10.3, 10.4, 10.5" => "Your engine in the official scene: (1) the number of \
                                                              steps that a list lasts, (2) the number of pair tests \
                                                              for each particle in a step.",
        official_bytes after "10.1, 10.2, 10.3, 10.4, 10.5" => "Your engine in the official scene: the output of 1,000 \
                                                                steps, byte for byte.",
        statistics after "10.1, 10.2, 10.3, 10.4, 10.5" => "Your engine in a dense box: dmin, davg and navg of each step.",
        memory after "10.1, 10.2, 10.3, 10.4, 10.5" => "Your engine in a long run: the memory in use, which must not \
                                                        grow with the number of steps.",
    }
}
