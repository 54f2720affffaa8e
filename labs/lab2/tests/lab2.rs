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
        bins_table => "A box, the least side of a bin, and the number of particles: how many bins are along a wall, and \
                       their side, which is more than the least side by a margin. There is at least one bin, and there \
                       are at most eight for each particle.",
        columns_table => "A box of side 4 with four bins along a wall: the column and the row of a position, and its bin. \
                          The far walls belong to the last bins.",
        grids => "A box of any size with any number of particles: how many bins are along a wall.",
        columns => "A coordinate anywhere in a box, also on a wall: its column.",
    }
    task_2_2 {
        near_table => "Grids of 1, 2 and 5 rows: the rows next to each row.",
        near => "A row of a grid of any size: the rows next to it.",
    }
    task_2_3 {
        refill_table => "Five particles and four bins of side 1: which particles each bin holds, moment by moment.",
        refills => "Bins that are filled again and again, with many particles and with few: which particles each bin \
                    holds.",
    }
    task_2_4 {
        nine_bins_table after "2.2" => "Particle 0 in the middle of bin (2, 2) of 5 by 5, and one neighbour in another bin: \
                                        the acceleration of particle 0, and how many particles it looked at, itself among \
                                        them.",
        nine_bins after "2.2" => "A particle among any number of others: its acceleration, and how many particles it \
                                  looked at in the bins around it, itself among them.",
        edges after "2.1, 2.2, 2.3" = |_, ask| edges(ask, &rebuild())
            => "Pairs at 0.9995 cutoffs over every edge of bins, in every direction: one step.",
        steps after "2.1, 2.2, 2.3" = |_, ask| steps(ask, &rebuild())
            => "Dense boxes, particles at one position, and fast ones, with bins of 1 to 3 cutoffs: each step.",
        crowds after "2.1, 2.2, 2.3" = |_, ask| crowds(ask, &rebuild())
            => "200 crowds through one engine: each of two steps.",
        sparse after "2.1, 2.2, 2.3" = |_, ask| sparse(ask, &rebuild())
            => "Boxes of one particle, and pairs in a box a million cutoffs wide: each of three steps.",
        pair_tests after "2.1, 2.2, 2.3" = |_, ask| pair_tests(ask, &rebuild())
            => "The official scene with 1,000 to 64,000 particles: how many pairs are looked at for each particle.",
        official_run after "2.1, 2.2, 2.3" = |_, ask| official_run(ask, &rebuild())
            => "The official scene, 1,000 particles: each of 1,000 steps, and the output byte for byte.",
        statistics after "2.1, 2.2, 2.3" = |_, ask| statistics(ask, &rebuild())
            => "Pairs at exactly the cutoff, a dense box and the official run: dmin, davg and navg of each step, and their \
                averages.",
        memory after "2.1, 2.2, 2.3" = |_, ask| memory(ask, &rebuild())
            => "A long run: the memory that it holds does not grow with the number of steps.",
    }
    task_2_5 {
        leavers_table => "Seven particles in the list of bin 0, a bin of side 1, after a move: which of them are in the list \
                          and which in `changed` afterwards. `changed` held particle 9 before.",
        leavers => "A bin with any number of particles after a move: which of them stay, and which are in `changed`.",
        edges after "2.1, 2.2, 2.3, 2.4" = |_, ask| edges(ask, &incremental())
            => "Pairs at 0.9995 cutoffs over every edge of bins, in every direction: one step.",
        steps after "2.1, 2.2, 2.3, 2.4" = |_, ask| steps(ask, &incremental())
            => "Dense boxes, particles at one position, and fast ones, with bins of 1 to 3 cutoffs: each step.",
        crowds after "2.1, 2.2, 2.3, 2.4" = |_, ask| crowds(ask, &incremental())
            => "200 crowds through one engine: each of two steps.",
        sparse after "2.1, 2.2, 2.3, 2.4" = |_, ask| sparse(ask, &incremental())
            => "Boxes of one particle, and pairs in a box a million cutoffs wide: each of three steps.",
        keeps_everyone after "2.1, 2.2, 2.3, 2.4" = |_, ask| keeps_everyone(ask, &incremental())
            => "A dense box for 1,000 steps: each step, and no particle is lost.",
        official_run after "2.1, 2.2, 2.3, 2.4" = |_, ask| official_run(ask, &incremental())
            => "The official scene, 1,000 particles: each of 1,000 steps, and the output byte for byte.",
        statistics after "2.1, 2.2, 2.3, 2.4" = |_, ask| statistics(ask, &incremental())
            => "Pairs at exactly the cutoff, a dense box and the official run: dmin, davg and navg of each step, and their \
                averages.",
        memory after "2.1, 2.2, 2.3, 2.4" = |_, ask| memory(ask, &incremental())
            => "A long run: the memory that it holds does not grow with the number of steps.",
    }
    task_2_6 {
        lists_table => "The lists of two bins, moment by moment. The particle that came last comes first.",
        lists => "Lists that are cleared and filled again and again: the particles of each bin, and those after one of them.",
    }
    task_2_7 {
        forward_table after "2.2" => "Grids of one, two and three rows: the bins after each bin.",
        pairs_table after "2.1, 2.2, 2.6" => "Four particles at rest, particle 3 alone, with bins of 1.1 cutoffs: their \
                                              velocities after a step, and how many pairs the observer was told of.",
        forwards after "2.2" => "A bin of a grid of any size: the bins after it.",
        looks after "2.1, 2.2, 2.6" => "A box of bins that all touch: how many pairs are looked at in a step. Each pair is \
                                        looked at once.",
        edges after "2.1, 2.2, 2.6" = |_, ask| edges(ask, &linked_list())
            => "Pairs at 0.9995 cutoffs over every edge of bins, in every direction: one step.",
        steps after "2.1, 2.2, 2.6" = |_, ask| steps(ask, &linked_list())
            => "Dense boxes, particles at one position, and fast ones, with bins of 1 to 3 cutoffs: each step.",
        drawn_boxes after "2.1, 2.2, 2.6" => "Drawn boxes, crowds and pairs, with bins of two and three cutoffs: each step.",
        crowds after "2.1, 2.2, 2.6" = |_, ask| crowds(ask, &linked_list())
            => "200 crowds through one engine: each of two steps.",
        sparse after "2.1, 2.2, 2.6" = |_, ask| sparse(ask, &linked_list())
            => "Boxes of one particle, and pairs in a box a million cutoffs wide: each of three steps.",
        official_run after "2.1, 2.2, 2.6" = |_, ask| official_run(ask, &linked_list())
            => "The official scene, 1,000 particles: each of 1,000 steps, and the output byte for byte.",
        statistics after "2.1, 2.2, 2.6" = |_, ask| statistics(ask, &linked_list())
            => "Pairs at exactly the cutoff, a dense box and the official run: dmin, davg and navg of each step, and their \
                averages.",
        memory after "2.1, 2.2, 2.6" = |_, ask| memory(ask, &linked_list())
            => "A long run: the memory that it holds does not grow with the number of steps.",
    }
    task_2_8 {
        sort_table => "Five particles in three bins of one row: the particles in memory before and after the sort, and where \
                       each bin begins and ends.",
        sorts => "Any rows of a grid, sorted again and again: the particles in memory, and where bins begin and end.",
    }
    task_2_9 {
        gather_table => "Particle 5 and its candidates in two slices, particle 1 beyond the cutoff: how many candidates were \
                         looked at, the distances of the neighbours in the order in which they were summed, and the \
                         acceleration. Every sum begins at 0.",
        sums => "Any number of candidates in any order: the acceleration to the bit, how many candidates were looked at, and \
                 how many pairs were summed.",
        edges after "2.1, 2.2, 2.8" = |_, ask| edges(ask, &sorted())
            => "Pairs at 0.9995 cutoffs over every edge of bins, in every direction: one step.",
        steps after "2.1, 2.2, 2.8" = |_, ask| steps(ask, &sorted())
            => "Dense boxes, particles at one position, and fast ones, with bins of 1 to 3 cutoffs: each step.",
        crowds after "2.1, 2.2, 2.8" = |_, ask| crowds(ask, &sorted())
            => "200 crowds through one engine: each of two steps.",
        sparse after "2.1, 2.2, 2.8" = |_, ask| sparse(ask, &sorted())
            => "Boxes of one particle, and pairs in a box a million cutoffs wide: each of three steps.",
        bits after "2.1, 2.2, 2.8" => "Dense boxes and crowds, with bins of 1 to 3 cutoffs: the bits of all pairs.",
        bits_of_official_scenes after "2.1, 2.2, 2.8" => "Official scenes of 1 to 1,500 particles, 200 steps: the bits of all \
                                                          pairs.",
        pair_tests after "2.1, 2.2, 2.8" = |_, ask| pair_tests(ask, &sorted())
            => "The official scene with 1,000 to 64,000 particles: how many pairs are looked at for each particle.",
        keeps_everyone after "2.1, 2.2, 2.8" = |_, ask| sorted().keeps_everyone(ask, &oracle::scenes::dense(), 1000)
            => "A dense box for 1,000 steps: no particle is lost.",
        official_run after "2.1, 2.2, 2.8" = |_, ask| official_run(ask, &sorted())
            => "The official scene, 1,000 particles: each of 1,000 steps, and the output byte for byte.",
        statistics after "2.1, 2.2, 2.8" = |_, ask| statistics(ask, &sorted())
            => "Pairs at exactly the cutoff, a dense box and the official run: dmin, davg and navg of each step, and their \
                averages.",
        memory after "2.1, 2.2, 2.8" = |_, ask| memory(ask, &sorted())
            => "A long run: the memory that it holds does not grow with the number of steps.",
    }
}
