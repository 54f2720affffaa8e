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
        bins_table => "A box, the least side of a bin, and a number of particles: (1) the number of bins along a \
                       wall, (2) the side of a bin, which must exceed the least side by a margin. The box has at \
                       least one bin, and at most eight times as many bins as particles.",
        columns_table => "A box of side 4 with four bins along a wall: the column, the row and the bin of a position. \
                          A position on a far wall is in the last column or row.",
        grids => "A box of any size with any number of particles: the number of bins along a wall.",
        columns => "A coordinate anywhere in a box, or exactly on a wall: its column.",
    }
    task_2_2 {
        near_table => "Grids of 1, 2 and 5 rows: the rows next to each row, including the row itself.",
        near => "A row of a grid of any size: the rows next to it, including the row itself.",
    }
    task_2_3 {
        refill_table => "Five particles and four bins of side 1: the particles in each bin after each filling.",
        refills => "Bins that are filled again and again, sometimes with many particles and sometimes with few: the \
                    particles in each bin after each filling.",
    }
    task_2_4 {
        nine_bins_table after "2.2" => "Particle 0 in the middle of bin (2, 2) of a grid of 5 by 5, and one neighbour \
                                        in a different bin: (1) the acceleration of particle 0, (2) the number of \
                                        particles against which particle 0 was tested, including itself.",
        nine_bins after "2.2" => "A particle among any number of others: (1) its acceleration, (2) the number of \
                                  particles against which it was tested. These are the particles in the bins around \
                                  it, including itself.",
        edges after "2.1, 2.2, 2.3" = |_, ask| edges(ask, &rebuild())
            => "Pairs 0.9995 cutoffs apart, across every edge between bins and in every direction: the state after \
                one step.",
        steps after "2.1, 2.2, 2.3" = |_, ask| steps(ask, &rebuild())
            => "Dense boxes, particles at one position, and fast particles, with bins of 1 to 3 cutoffs: the state \
                after each step.",
        crowds after "2.1, 2.2, 2.3" = |_, ask| crowds(ask, &rebuild())
            => "One engine that simulates 200 crowds, one after another: the state after each of two steps.",
        sparse after "2.1, 2.2, 2.3" = |_, ask| sparse(ask, &rebuild())
            => "Boxes with one particle, and pairs in a box that is a million cutoffs wide: the state after each of \
                three steps.",
        pair_tests after "2.1, 2.2, 2.3" = |_, ask| pair_tests(ask, &rebuild())
            => "The official scene with 1,000 to 64,000 particles: the number of pair tests for each particle in a \
                step. It must not grow with the number of particles.",
        official_run after "2.1, 2.2, 2.3" = |_, ask| official_run(ask, &rebuild())
            => "The official scene of 1,000 particles: (1) the state after each of 1,000 steps, (2) the output, byte \
                for byte.",
        statistics after "2.1, 2.2, 2.3" = |_, ask| statistics(ask, &rebuild())
            => "Pairs exactly one cutoff apart, a dense box, and the official run: dmin, davg and navg of each step, \
                and their averages.",
        memory after "2.1, 2.2, 2.3" = |_, ask| memory(ask, &rebuild())
            => "A long run: the memory in use, which must not grow with the number of steps.",
    }
    task_2_5 {
        leavers_table => "Bin 0 has the side 1, and seven particles are in its list after a move: the particles in \
                          the list and in `changed` afterwards. Particle 9 was in `changed` before.",
        leavers => "A bin, and the particles in its list after a move: (1) the particles that stay in the list, (2) \
                    the particles in `changed`.",
        edges after "2.1, 2.2, 2.3, 2.4" = |_, ask| edges(ask, &incremental())
            => "Pairs 0.9995 cutoffs apart, across every edge between bins and in every direction: the state after one \
                step.",
        steps after "2.1, 2.2, 2.3, 2.4" = |_, ask| steps(ask, &incremental())
            => "Dense boxes, particles at one position, and fast particles, with bins of 1 to 3 cutoffs: the state \
                after each step.",
        crowds after "2.1, 2.2, 2.3, 2.4" = |_, ask| crowds(ask, &incremental())
            => "One engine that simulates 200 crowds, one after another: the state after each of two steps.",
        sparse after "2.1, 2.2, 2.3, 2.4" = |_, ask| sparse(ask, &incremental())
            => "Boxes with one particle, and pairs in a box that is a million cutoffs wide: the state after each of \
                three steps.",
        keeps_everyone after "2.1, 2.2, 2.3, 2.4" = |_, ask| keeps_everyone(ask, &incremental())
            => "A dense box: the state after each of 1,000 steps. Every particle must stay inside the box.",
        official_run after "2.1, 2.2, 2.3, 2.4" = |_, ask| official_run(ask, &incremental())
            => "The official scene of 1,000 particles: (1) the state after each of 1,000 steps, (2) the output, byte \
                for byte.",
        statistics after "2.1, 2.2, 2.3, 2.4" = |_, ask| statistics(ask, &incremental())
            => "Pairs exactly one cutoff apart, a dense box, and the official run: dmin, davg and navg of each step, \
                and their averages.",
        memory after "2.1, 2.2, 2.3, 2.4" = |_, ask| memory(ask, &incremental())
            => "A long run: the memory in use, which must not grow with the number of steps.",
    }
    task_2_6 {
        lists_table => "The lists of two bins after each insertion. The particle that was inserted last comes first.",
        lists => "Lists that are cleared and filled again and again: (1) the particles in the list of each bin, (2) \
                  the particles that come after one particle in its list.",
    }
    task_2_7 {
        forward_table after "2.2" => "Grids of one, two and three rows: for each bin, the neighbouring bins that come \
                                      after it.",
        pairs_table after "2.1, 2.2, 2.6" => "Four particles at rest, and bins with a side of 1.1 cutoffs. Particle 3 \
                                              has no neighbour: (1) the velocities after a step, (2) the number of \
                                              pair tests, (3) the number of pairs within the cutoff.",
        forwards after "2.2" => "A bin of a grid of any size: the neighbouring bins that come after it.",
        looks after "2.1, 2.2, 2.6" => "A box in which every bin touches every other bin: the number of pair tests in \
                                        a step. Each pair must be tested once.",
        edges after "2.1, 2.2, 2.6" = |_, ask| edges(ask, &linked_list())
            => "Pairs 0.9995 cutoffs apart, across every edge between bins and in every direction: the state after one \
                step.",
        steps after "2.1, 2.2, 2.6" = |_, ask| steps(ask, &linked_list())
            => "Dense boxes, particles at one position, and fast particles, with bins of 1 to 3 cutoffs: the state \
                after each step.",
        drawn_boxes after "2.1, 2.2, 2.6" => "Random boxes, crowds and pairs, with bins of two and three cutoffs: the \
                                              state after each step.",
        crowds after "2.1, 2.2, 2.6" = |_, ask| crowds(ask, &linked_list())
            => "One engine that simulates 200 crowds, one after another: the state after each of two steps.",
        sparse after "2.1, 2.2, 2.6" = |_, ask| sparse(ask, &linked_list())
            => "Boxes with one particle, and pairs in a box that is a million cutoffs wide: the state after each of \
                three steps.",
        official_run after "2.1, 2.2, 2.6" = |_, ask| official_run(ask, &linked_list())
            => "The official scene of 1,000 particles: (1) the state after each of 1,000 steps, (2) the output, byte \
                for byte.",
        statistics after "2.1, 2.2, 2.6" = |_, ask| statistics(ask, &linked_list())
            => "Pairs exactly one cutoff apart, a dense box, and the official run: dmin, davg and navg of each step, \
                and their averages.",
        memory after "2.1, 2.2, 2.6" = |_, ask| memory(ask, &linked_list())
            => "A long run: the memory in use, which must not grow with the number of steps.",
    }
    task_2_8 {
        sort_table => "Five particles in three bins of one row: (1) the particles in memory order before the sort, (2) \
                       the particles in memory order after the sort, (3) the indices at which each bin begins and \
                       ends.",
        sorts => "Any rows of a grid, sorted again and again: (1) the particles in memory order, (2) the \
                  indices at which each bin begins and ends.",
    }
    task_2_9 {
        gather_table => "Particle 5 and two slices of candidates, of which candidate 1 is beyond the cutoff: (1) \
                         the number of candidates tested, (2) the distances to the neighbours in the order of \
                         summation, (3) the acceleration. Every sum begins at 0.",
        sums => "Any number of candidates in any order: (1) the acceleration, bit for bit, (2) the number of \
                 candidates tested, (3) the number of pairs summed.",
        edges after "2.1, 2.2, 2.8" = |_, ask| edges(ask, &sorted())
            => "Pairs 0.9995 cutoffs apart, across every edge between bins and in every direction: the state after one \
                step.",
        steps after "2.1, 2.2, 2.8" = |_, ask| steps(ask, &sorted())
            => "Dense boxes, particles at one position, and fast particles, with bins of 1 to 3 cutoffs: the state \
                after each step.",
        crowds after "2.1, 2.2, 2.8" = |_, ask| crowds(ask, &sorted())
            => "One engine that simulates 200 crowds, one after another: the state after each of two steps.",
        sparse after "2.1, 2.2, 2.8" = |_, ask| sparse(ask, &sorted())
            => "Boxes with one particle, and pairs in a box that is a million cutoffs wide: the state after each of \
                three steps.",
        bits after "2.1, 2.2, 2.8" => "Dense boxes and crowds, with bins of 1 to 3 cutoffs: the state after each \
                                       step. The state must have the same bits as in `all-pairs`.",
        bits_of_official_scenes after "2.1, 2.2, 2.8" => "Official scenes of 1 to 1,500 particles: the state after \
                                                          each of 200 steps. The state must have the same bits as in \
                                                          `all-pairs`.",
        pair_tests after "2.1, 2.2, 2.8" = |_, ask| pair_tests(ask, &sorted())
            => "The official scene with 1,000 to 64,000 particles: the number of pair tests for each particle in a \
                step. It must not grow with the number of particles.",
        keeps_everyone after "2.1, 2.2, 2.8" = |_, ask| sorted().keeps_everyone(ask, &oracle::scenes::dense(), 1000)
            => "A dense box: x and y of each particle after each of 1,000 steps. Every particle must stay inside the \
                box.",
        official_run after "2.1, 2.2, 2.8" = |_, ask| official_run(ask, &sorted())
            => "The official scene of 1,000 particles: (1) the state after each of 1,000 steps, (2) the output, byte \
                for byte.",
        statistics after "2.1, 2.2, 2.8" = |_, ask| statistics(ask, &sorted())
            => "Pairs exactly one cutoff apart, a dense box, and the official run: dmin, davg and navg of each step, \
                and their averages.",
        memory after "2.1, 2.2, 2.8" = |_, ask| memory(ask, &sorted())
            => "A long run: the memory in use, which must not grow with the number of steps.",
    }
}
