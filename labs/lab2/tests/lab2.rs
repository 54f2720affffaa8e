//! Lab 2's graders.

#[path = "lab2/bins.rs"]
mod bins;
#[path = "lab2/examples_of_bins.rs"]
mod examples_of_bins;
#[path = "lab2/examples_of_order.rs"]
mod examples_of_order;
#[path = "lab2/grid.rs"]
mod grid;
#[path = "lab2/lists.rs"]
mod lists;
#[path = "lab2/particles.rs"]
mod particles;
#[path = "lab2/runs.rs"]
mod runs;
#[path = "lab2/sorted.rs"]
mod sorted;

use bins::*;
use examples_of_bins::*;
use examples_of_order::*;
use grid::*;
use lists::*;
use runs::*;
use sorted::*;

oracle::questions! {
    task_2_1 {
        bins_table => "A box, the least side of a bin, and a number of particles: the number of bins along a wall, and \
                       their side, which exceeds the least side by a margin. There is at least one bin, and there are \
                       at most eight for each particle.",
        columns_table => "A box of side 4 with four bins along a wall: the column, the row and the bin of a position. \
                          A position on a far wall is in the last column or row.",
        grids => "A box of any size with any number of particles: the number of bins along a wall.",
        columns => "A coordinate anywhere in a box, also on a wall: its column.",
    }
    task_2_2 {
        near_table => "Grids of 1, 2 and 5 rows: the rows next to each row, including the row itself.",
        near => "A row of a grid of any size: the rows next to it, including the row itself.",
    }
    task_2_3 {
        refill_table => "Five particles and four bins of side 1: the particles in each bin after each filling.",
        refills => "Bins that are filled again and again, with many particles and with few: the particles in each bin \
                    after each filling.",
    }
    task_2_4 {
        nine_bins_table after "2.2" => "Particle 0 in the middle of bin (2, 2) of a grid of 5 by 5, and one neighbour \
                                        in a different bin: the acceleration of particle 0, and the number of \
                                        particles that it was tested against, including itself.",
        nine_bins after "2.2" => "A particle among any number of others: its acceleration, and the number of particles \
                                  in the bins around it that it was tested against, including itself.",
        edges after "2.1, 2.2, 2.3" = |_, ask| edges(ask, &rebuild())
            => "Pairs 0.9995 cutoffs apart, across every edge between bins and in every direction: the state after one \
                step.",
        steps after "2.1, 2.2, 2.3" = |_, ask| steps(ask, &rebuild())
            => "Dense boxes, particles at one position, and fast particles, with bins of 1 to 3 cutoffs: the state \
                after each step.",
        crowds after "2.1, 2.2, 2.3" = |_, ask| crowds(ask, &rebuild())
            => "200 crowds, one after another in one engine: the state after each of two steps.",
        sparse after "2.1, 2.2, 2.3" = |_, ask| sparse(ask, &rebuild())
            => "Boxes of one particle, and pairs in a box a million cutoffs wide: the state after each of three \
                steps.",
        pair_tests after "2.1, 2.2, 2.3" = |_, ask| pair_tests(ask, &rebuild())
            => "The official scene with 1,000 to 64,000 particles: the number of pair tests for each particle in a \
                step, which must not grow.",
        official_run after "2.1, 2.2, 2.3" = |_, ask| official_run(ask, &rebuild())
            => "The official scene of 1,000 particles: the state after each of 1,000 steps, and the output, byte for \
                byte.",
        statistics after "2.1, 2.2, 2.3" = |_, ask| statistics(ask, &rebuild())
            => "Pairs exactly one cutoff apart, a dense box and the official run: dmin, davg and navg of each step, \
                and their averages.",
        memory after "2.1, 2.2, 2.3" = |_, ask| memory(ask, &rebuild())
            => "A long run: the memory in use, which must not grow with the number of steps.",
    }
    task_2_5 {
        leavers_table => "Bin 0 of side 1, and the seven particles in its list after a move: the particles in the list \
                          and in `changed` afterwards. `changed` held particle 9 before.",
        leavers => "A bin, and the particles in its list after a move: the particles that stay in the list, and those \
                    in `changed`.",
        edges after "2.1, 2.2, 2.3, 2.4" = |_, ask| edges(ask, &incremental())
            => "Pairs 0.9995 cutoffs apart, across every edge between bins and in every direction: the state after one \
                step.",
        steps after "2.1, 2.2, 2.3, 2.4" = |_, ask| steps(ask, &incremental())
            => "Dense boxes, particles at one position, and fast particles, with bins of 1 to 3 cutoffs: the state \
                after each step.",
        crowds after "2.1, 2.2, 2.3, 2.4" = |_, ask| crowds(ask, &incremental())
            => "200 crowds, one after another in one engine: the state after each of two steps.",
        sparse after "2.1, 2.2, 2.3, 2.4" = |_, ask| sparse(ask, &incremental())
            => "Boxes of one particle, and pairs in a box a million cutoffs wide: the state after each of three \
                steps.",
        keeps_everyone after "2.1, 2.2, 2.3, 2.4" = |_, ask| keeps_everyone(ask, &incremental())
            => "A dense box: the state after each of 1,000 steps, with every particle inside the box.",
        official_run after "2.1, 2.2, 2.3, 2.4" = |_, ask| official_run(ask, &incremental())
            => "The official scene of 1,000 particles: the state after each of 1,000 steps, and the output, byte for \
                byte.",
        statistics after "2.1, 2.2, 2.3, 2.4" = |_, ask| statistics(ask, &incremental())
            => "Pairs exactly one cutoff apart, a dense box and the official run: dmin, davg and navg of each step, \
                and their averages.",
        memory after "2.1, 2.2, 2.3, 2.4" = |_, ask| memory(ask, &incremental())
            => "A long run: the memory in use, which must not grow with the number of steps.",
    }
    task_2_6 {
        lists_table => "The lists of two bins after each insertion. The particle that was inserted last comes first.",
        lists => "Lists that are cleared and filled again and again: the particles of each bin, and the particles that \
                  follow one of them in its list.",
    }
    task_2_7 {
        forward_table after "2.2" => "Grids of one, two and three rows: the neighbouring bins that come after each \
                                      bin.",
        pairs_table after "2.1, 2.2, 2.6" => "Four particles at rest with bins of 1.1 cutoffs, particle 3 alone: their \
                                              velocities after a step, the number of pair tests, and the number of \
                                              pairs within the cutoff.",
        forwards after "2.2" => "A bin of a grid of any size: the neighbouring bins that come after it.",
        looks after "2.1, 2.2, 2.6" => "A box in which every bin touches every other: the number of pair tests in a \
                                        step. Each pair is tested once.",
        edges after "2.1, 2.2, 2.6" = |_, ask| edges(ask, &linked_list())
            => "Pairs 0.9995 cutoffs apart, across every edge between bins and in every direction: the state after one \
                step.",
        steps after "2.1, 2.2, 2.6" = |_, ask| steps(ask, &linked_list())
            => "Dense boxes, particles at one position, and fast particles, with bins of 1 to 3 cutoffs: the state \
                after each step.",
        drawn_boxes after "2.1, 2.2, 2.6" => "Random boxes, crowds and pairs, with bins of two and three cutoffs: the \
                                              state after each step.",
        crowds after "2.1, 2.2, 2.6" = |_, ask| crowds(ask, &linked_list())
            => "200 crowds, one after another in one engine: the state after each of two steps.",
        sparse after "2.1, 2.2, 2.6" = |_, ask| sparse(ask, &linked_list())
            => "Boxes of one particle, and pairs in a box a million cutoffs wide: the state after each of three \
                steps.",
        official_run after "2.1, 2.2, 2.6" = |_, ask| official_run(ask, &linked_list())
            => "The official scene of 1,000 particles: the state after each of 1,000 steps, and the output, byte for \
                byte.",
        statistics after "2.1, 2.2, 2.6" = |_, ask| statistics(ask, &linked_list())
            => "Pairs exactly one cutoff apart, a dense box and the official run: dmin, davg and navg of each step, \
                and their averages.",
        memory after "2.1, 2.2, 2.6" = |_, ask| memory(ask, &linked_list())
            => "A long run: the memory in use, which must not grow with the number of steps.",
    }
    task_2_8 {
        sort_table => "Five particles in three bins of one row: the particles in memory before and after the sort, and \
                       the indices at which each bin begins and ends.",
        sorts => "Any rows of a grid, sorted again and again: the particles in memory, and the indices at which each \
                  bin begins and ends.",
    }
    task_2_9 {
        gather_table => "Particle 5 and its candidates in two slices, particle 1 beyond the cutoff: the number of \
                         candidates tested, the distances of the neighbours in the order of summation, and the \
                         acceleration. Every sum begins at 0.",
        sums => "Any number of candidates in any order: the acceleration, bit for bit, the number of candidates \
                 tested, and the number of pairs summed.",
        edges after "2.1, 2.2, 2.8" = |_, ask| edges(ask, &sorted())
            => "Pairs 0.9995 cutoffs apart, across every edge between bins and in every direction: the state after one \
                step.",
        steps after "2.1, 2.2, 2.8" = |_, ask| steps(ask, &sorted())
            => "Dense boxes, particles at one position, and fast particles, with bins of 1 to 3 cutoffs: the state \
                after each step.",
        crowds after "2.1, 2.2, 2.8" = |_, ask| crowds(ask, &sorted())
            => "200 crowds, one after another in one engine: the state after each of two steps.",
        sparse after "2.1, 2.2, 2.8" = |_, ask| sparse(ask, &sorted())
            => "Boxes of one particle, and pairs in a box a million cutoffs wide: the state after each of three \
                steps.",
        bits after "2.1, 2.2, 2.8" => "Dense boxes and crowds, with bins of 1 to 3 cutoffs: the state after each step, \
                                       bit for bit as in `all-pairs`.",
        bits_of_official_scenes after "2.1, 2.2, 2.8" => "Official scenes of 1 to 1,500 particles: the state after \
                                                          each of 200 steps, bit for bit as in `all-pairs`.",
        pair_tests after "2.1, 2.2, 2.8" = |_, ask| pair_tests(ask, &sorted())
            => "The official scene with 1,000 to 64,000 particles: the number of pair tests for each particle in a \
                step, which must not grow.",
        keeps_everyone after "2.1, 2.2, 2.8" = |_, ask| sorted().keeps_everyone(ask, &oracle::scenes::dense(), 1000)
            => "A dense box: x and y of each particle after each of 1,000 steps, inside the box.",
        official_run after "2.1, 2.2, 2.8" = |_, ask| official_run(ask, &sorted())
            => "The official scene of 1,000 particles: the state after each of 1,000 steps, and the output, byte for \
                byte.",
        statistics after "2.1, 2.2, 2.8" = |_, ask| statistics(ask, &sorted())
            => "Pairs exactly one cutoff apart, a dense box and the official run: dmin, davg and navg of each step, \
                and their averages.",
        memory after "2.1, 2.2, 2.8" = |_, ask| memory(ask, &sorted())
            => "A long run: the memory in use, which must not grow with the number of steps.",
    }
}
