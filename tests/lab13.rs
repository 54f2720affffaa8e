use common::soft::CUTOFF;
use lab13::{VARIANTS, right_steps};
use oracle::scenes;
use oracle_mpi::RunsOnRanks;

#[path = "lab13/dozen.rs"]
mod dozen;
#[path = "lab13/epochs.rs"]
mod epochs;
#[path = "lab13/examples.rs"]
mod examples;
#[path = "lab13/examples_on_ranks.rs"]
mod examples_on_ranks;
#[path = "lab13/ghosts.rs"]
mod ghosts;
#[path = "lab13/loads.rs"]
mod loads;
#[path = "lab13/messages.rs"]
mod messages;
#[path = "lab13/pairs.rs"]
mod pairs;
#[path = "lab13/runs.rs"]
mod runs;
#[path = "lab13/widths.rs"]
mod widths;

use dozen::*;
use epochs::*;
use examples::*;
use examples_on_ranks::*;
use ghosts::*;
use loads::*;
use messages::*;
use pairs::*;
use runs::*;
use widths::*;

oracle::questions! {
    task_13_1 {
        widths_of_ghosts => "The distance that the fastest particle goes in a step, and a number of steps: the \
                             necessary width of ghosts, all in cutoffs.",
        widths = |random, ask| widths(random, ask, false)
            => "Particles at rest, slow and fast, and 1 to 70,000 steps: the necessary width of ghosts.",
        table_of_widths => "Strips of some heights and densities, and some speeds: the number of steps for which \
                            ghosts are chosen, and their width in cutoffs.",
        cheapest_steps => "Any strip, density and speed: the chosen number of steps. With any other number, a step \
                           must cost as much or more.",
    }
    task_13_2 {
        table_of_partners => "Three to five strips, given by the edges between them, and a width of ghosts: the \
                              partners of each rank.",
        partners_of_ranks => "1 to 257 strips, some of them empty, and ghosts as wide as the distance of two edges, \
                              or a rounding error more or less: the partners of a rank.",
    }
    task_13_3 {
        ghosts_and_pairs => "A dozen particles (ids) on three ranks, and ghosts 1.2 wide: the particles that each rank \
                             sends, its ghosts, and the pairs across its borders.",
        chosen => "0 to 70,000 particles before or after a strip, some of them exactly at the width of ghosts: the \
                   indices of the particles that are ghosts.",
        pairs => "0 to 70,000 particles and ghosts, some of them exactly at the reach: the pairs within reach.",
        half_a_million => "Half a million particles in a row, and a ghost at the position of each: the number of \
                           pairs. A program that tests every pair would not finish.",
    }
    task_13_4 {
        positions_travel => "Positions between three ranks: the messages under way when the inner particles move, and \
                             the positions that each rank gets.",
        exchanges => "Lists of any length between 1, 2, 3 and 5 ranks: the messages under way when the inner particles \
                      move, and the positions that each rank gets.",
    }
    task_13_5 {
        table_of_loads => "Particles in the rows of a rank, and listed pairs: the load of the rank and the share of \
                           each row, in nanoseconds.",
        loads => "Any number of particles and of listed pairs: the load.",
        shares => "Any load, and 1 to 4,097 rows: the share of each row.",
    }
    task_13_6 {
        one_decides => "Three ranks with ghosts two cutoffs wide: whether each rank's list has expired, the distance \
                        that a particle has gone, and the decision of the ranks.",
        renewals => "1, 2, 3 and 5 ranks, of which one or none needs new lists: the decision of all ranks. One \
                     Allreduce is allowed.",
        dense_box after "13.1, 13.2, 13.3, 13.4, 13.5" = |_, ask| dense_box(strips, ask)
            => "150 particles in a dense box on 1, 2, 3 and 5 ranks: the state after each of 40 steps.",
        close_pairs after "13.1, 13.2, 13.3, 13.4, 13.5" = |_, ask| close_pairs(strips, ask)
            => "Pairs 0, 0.003 and 0.005 cutoffs apart, on three ranks: the state after each of 20 steps.",
        over_the_edges after "13.1, 13.2, 13.3, 13.4, 13.5" = |_, ask| over_the_edges(strips, ask)
            => "Pairs 0.9995 cutoffs apart, in every direction, on two ranks: the state after each of 3 steps.",
        many_lists after "13.1, 13.2, 13.3, 13.4, 13.5" = |_, ask| long_run(strips, ask)
            => "2,000 particles on 2 and 3 ranks, with many lists: the state after each of 120 steps.",
        more_ranks_than_rows after "13.1, 13.2, 13.3, 13.4, 13.5" = |_, ask| few_rows(strips, ask)
            => "A crowd in two rows of bins, and a single particle, on 3, 4 and 7 ranks: the state after each of 12 \
                steps.",
        fast after "13.1, 13.2, 13.3, 13.4, 13.5" = |_, ask| strips(&[2, 5]).resynchronised(ask, &scenes::fast(), 20)
            => "Particles that cross the box in a step, on 2 and 5 ranks: the state after each of 20 steps.",
        empty_ranks after "13.1, 13.2, 13.3, 13.4, 13.5" = |_, ask| empty_ranks(strips, ask)
            => "All particles in a few rows, or in one, on 4 and 5 ranks: the state after each of 20 steps.",
        drifting after "13.1, 13.2, 13.3, 13.4, 13.5"
            = |_, ask| often_cut(strips).resynchronised(ask, &[scenes::drifting()], 40)
            => "Particles that fly from the bottom to the top of the box, on three ranks: the state after each of 40 \
                steps.",
        cut_again after "13.1, 13.2, 13.3, 13.4, 13.5" = |_, ask| cut_again(strips, ask)
            => "Particles that fly from the bottom to the top of the box, on three ranks: the number of times that the \
                strips are cut again in 40 steps, at least three.",
        become_fast after "13.1, 13.2, 13.3, 13.4, 13.5" = |_, ask| become_fast(strips, ask)
            => "A close pair that flies apart through several strips before any list expects it: the state after each \
                of 20 steps.",
        meeting after "13.1, 13.2, 13.3, 13.4, 13.5" = |_, ask| meeting(strips, ask)
            => "Two particles of two ranks that fly towards each other, with a skin of one cutoff: the state after \
                each of 40 steps.",
        repeated after "13.1, 13.2, 13.3, 13.4, 13.5"
            = |_, ask| strips(&[3]).same_bits(ask, &[scenes::dense()], 60, &[])
            => "A dense box on three ranks, run three times: the state after each of 60 steps, with the same bits in \
                each run.",
        threads after "13.1, 13.2, 13.3, 13.4, 13.5" = |_, ask| threads(ask)
            => "1,000 particles on two ranks with 1 and 3 threads each: the state after each step, with the same bits \
                as without threads.",
        dense_averages after "13.1, 13.2, 13.3, 13.4, 13.5"
            = |_, ask| strips(&[1, 2, 5]).averages(ask, &scenes::dense(), 4)
            => "A dense box on 1, 2 and 5 ranks: absmin, absavg and neighbours per particle over 4 steps.",
        few_messages after "13.1, 13.2, 13.3, 13.4, 13.5" = |_, ask| few_messages(ask)
            => "20,000 particles on two ranks: the steps per list, more than four, and the messages of a rank in a \
                step, fewer than four.",
        program after "13.1, 13.2, 13.3, 13.4, 13.5" = |_, ask| program("13.6", "strips", ask)
            => "The lab's own program on ranks: the official output, and the end of the job after one rank is killed.",
    }
    task_13_7 {
        depths_of_ghosts => "The distance that the fastest particle goes in a step, and a number of steps: the \
                             necessary depth of ghosts, all in cutoffs.",
        depths = |random, ask| widths(random, ask, true)
            => "Particles at rest, slow and fast, and 1 to 70,000 steps: the necessary depth of ghosts.",
        table_of_depths => "Strips of some heights and numbers of particles, and some speeds: the number of steps in \
                            an epoch, and the depth of its ghosts in cutoffs.",
        cheapest_epochs => "Any strip, number of particles and speed: the chosen number of steps in an epoch. With \
                            any other number, a step must cost as much or more.",
    }
    task_13_8 {
        table_of_right_steps => "The greatest distance that a particle went in each step of an epoch, and the depth of \
                                 ghosts, in cutoffs: the number of steps that are right.",
        right_steps_of_epochs => "1 to 257 steps, and ghosts as deep as some of them need, or slightly more or less: \
                                  the number of steps that are right.",
        confirmed => "Three ranks, and the greatest distance that a particle of each went in each of four steps, in \
                      cutoffs: the numbers on which all ranks agree.",
        confirmations => "1, 2, 3 and 5 ranks, and epochs of any length: the number of steps that are right on all \
                          ranks, and the greatest of each number. One Allreduce is allowed.",
        dense_box after "13.2, 13.5, 13.7" = |_, ask| dense_box(deep, ask)
            => "150 particles in a dense box on 1, 2, 3 and 5 ranks: the state after each of 40 steps.",
        close_pairs after "13.2, 13.5, 13.7" = |_, ask| close_pairs(deep, ask)
            => "Pairs 0, 0.003 and 0.005 cutoffs apart, on three ranks: the state after each of 20 steps.",
        over_the_edges after "13.2, 13.5, 13.7" = |_, ask| over_the_edges(deep, ask)
            => "Pairs 0.9995 cutoffs apart, in every direction, on two ranks: the state after each of 3 steps.",
        many_epochs after "13.2, 13.5, 13.7" = |_, ask| long_run(deep, ask)
            => "2,000 particles on 2 and 3 ranks, with many epochs: the state after each of 120 steps.",
        more_ranks_than_rows after "13.2, 13.5, 13.7" = |_, ask| few_rows(deep, ask)
            => "A crowd in two rows of bins, and a single particle, on 3, 4 and 7 ranks: the state after each of 12 \
                steps.",
        fast after "13.2, 13.5, 13.7" = |_, ask| deep(&[2, 5]).resynchronised(ask, &scenes::fast(), 20)
            => "Particles that cross the box in a step, on 2 and 5 ranks: the state after each of 20 steps.",
        empty_ranks after "13.2, 13.5, 13.7" = |_, ask| empty_ranks(deep, ask)
            => "All particles in a few rows, or in one, on 4 and 5 ranks: the state after each of 20 steps.",
        drifting after "13.2, 13.5, 13.7" = |_, ask| often_cut(deep).resynchronised(ask, &[scenes::drifting()], 40)
            => "Particles that fly from the bottom to the top of the box, on three ranks: the state after each of 40 \
                steps.",
        cut_again after "13.2, 13.5, 13.7" = |_, ask| cut_again(deep, ask)
            => "Particles that fly from the bottom to the top of the box, on three ranks: the number of times that the \
                strips are cut again in 40 steps, at least three.",
        kicked after "13.2, 13.5, 13.7" = |_, ask| deep(&[2, 3, 5]).resynchronised(ask, &[a_kick()], 12)
            => "A particle that is kicked across a border in the middle of an epoch, on 2, 3 and 5 ranks: the state \
                after each of 12 steps.",
        taken_again after "13.2, 13.5, 13.7" = |_, ask| taken_again(ask)
            => "A particle that is kicked across a border in the middle of an epoch: the number of epochs rolled back \
                in 12 steps, at least one.",
        repeated after "13.2, 13.5, 13.7"
            = |_, ask| deep(&[3]).same_bits(ask, &[scenes::dense(), a_kick()], 61, &[])
            => "Two scenes on three ranks, run three times, once without reading any state before the end: the state \
                at the end, with the same bits in each run.",
        dense_averages after "13.1, 13.2, 13.3, 13.4, 13.5, 13.6, 13.7"
            = |_, ask| deep(&[2]).averages(ask, &scenes::dense(), 4)
            => "A dense box on two ranks: absmin, absavg and neighbours per particle over 4 steps.",
        few_messages after "13.2, 13.5, 13.7" = |_, ask| few_messages_of_epochs(ask)
            => "20,000 particles on 2 and 3 ranks: the steps per epoch, more than four, the messages of a rank in a \
                step, far fewer than one, and the epochs taken again, at most two.",
        program after "13.2, 13.5, 13.7" = |_, ask| program_of_epochs(ask)
            => "The lab's own program on ranks: the official output, and the end of the job after one rank is killed.",
    }
}

/// Returns runs on each of these numbers of ranks. An unsolved starter stops at the `todo!` of task
/// 13.6.
fn strips(ranks: &[usize]) -> RunsOnRanks {
    RunsOnRanks::new("13.6", VARIANTS, "strips", ranks)
}

/// Returns runs with deep ghosts. An unsolved starter stops at the `todo!` of task 13.8.
fn deep(ranks: &[usize]) -> RunsOnRanks {
    RunsOnRanks::new("13.8", VARIANTS, "strips-deep", ranks)
        .first(|_| _ = right_steps(&[0.0], CUTOFF))
}
