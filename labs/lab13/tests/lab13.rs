//! Lab 13's graders.

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
        widths_of_ghosts => "The distance that the fastest particle moves in a step, and a number of steps: the \
                             necessary width of ghosts, all in cutoffs.",
        widths = |random, ask| widths(random, ask, false)
            => "Particles that are at rest, slow or fast, and 1 to 70,000 steps: the necessary width of ghosts.",
        table_of_widths => "Strips of some heights and densities, and some speeds: (1) the number of steps for which \
                            ghosts are chosen, (2) the width of the ghosts in cutoffs.",
        cheapest_steps => "Any strip, density and speed: the chosen number of steps. With any other number of steps, \
                           a step must cost the same or more.",
    }
    task_13_2 {
        table_of_partners => "Three to five strips, given by the edges between them, and a width of ghosts: the \
                              partners of each rank.",
        partners_of_ranks => "1 to 257 strips, some of which are empty. The ghosts are exactly as wide as the \
                              distance between two edges, or a rounding error more or less: the partners of a rank.",
    }
    task_13_3 {
        ghosts_and_pairs => "A dozen particles (ids) on three ranks, and ghosts with a width of 1.2: (1) the \
                             particles that each rank sends, (2) its ghosts, (3) the pairs across its borders.",
        chosen => "0 to 70,000 particles before or after a strip, some of them at a distance of exactly the width of \
                   ghosts: the indices of the particles that are ghosts.",
        pairs => "0 to 70,000 particles and ghosts, some of them at a distance of exactly the reach: the pairs within \
                  reach.",
        half_a_million => "Half a million particles in a row, and a ghost at the position of each particle: the \
                           number of pairs. A program that tests every pair would not finish.",
    }
    task_13_4 {
        positions_travel => "Positions that three ranks exchange: (1) the messages under way when the inner particles \
                             move, (2) the positions that each rank gets.",
        exchanges => "Lists of any length that 1, 2, 3 and 5 ranks exchange: (1) the messages under way when the \
                      inner particles move, (2) the positions that each rank gets.",
    }
    task_13_5 {
        table_of_loads => "The numbers of particles in the rows of a rank, and the number of listed pairs: (1) the \
                           load of the rank, (2) the share of each row, both in nanoseconds.",
        loads => "Any number of particles and any number of listed pairs: the load of the rank in nanoseconds.",
        shares => "Any load, and 1 to 4,097 rows: the share of each row.",
    }
    task_13_6 {
        one_decides => "Three ranks with ghosts two cutoffs wide: (1) whether the list of each rank has expired, (2) \
                        the greatest distance that a particle of the rank has gone, (3) the decision of all ranks.",
        renewals => "1, 2, 3 and 5 ranks, of which at most one needs a new list: the decision of all ranks. One \
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
            => "4 and 5 ranks, and all particles in a single row or in a few rows: the state after each of 20 steps.",
        drifting after "13.1, 13.2, 13.3, 13.4, 13.5"
            = |_, ask| often_cut(strips).resynchronised(ask, &[scenes::drifting()], 40)
            => "Three ranks, and particles that fly from the bottom to the top of the box: the state after each of 40 \
                steps.",
        cut_again after "13.1, 13.2, 13.3, 13.4, 13.5" = |_, ask| cut_again(strips, ask)
            => "Three ranks, and particles that fly from the bottom to the top of the box: the number of times that \
                the strips are cut again in 40 steps. It must be at least three.",
        become_fast after "13.1, 13.2, 13.3, 13.4, 13.5" = |_, ask| become_fast(strips, ask)
            => "A close pair of particles that fly apart so fast that they cross several strips before any list is \
                due to be rebuilt: the state after each of 20 steps.",
        meeting after "13.1, 13.2, 13.3, 13.4, 13.5" = |_, ask| meeting(strips, ask)
            => "Two particles on different ranks that fly towards each other, with a skin of one cutoff: the state \
                after each of 40 steps.",
        repeated after "13.1, 13.2, 13.3, 13.4, 13.5"
            = |_, ask| strips(&[3]).same_bits(ask, &[scenes::dense()], 60, &[])
            => "A dense box on three ranks, run three times: the state after each of 60 steps. It must have the same \
                bits in each run.",
        threads after "13.1, 13.2, 13.3, 13.4, 13.5" = |_, ask| threads(ask)
            => "1,000 particles on two ranks with 1 and 3 threads each: the state after each step. It must have the \
                same bits as in a run without threads.",
        dense_averages after "13.1, 13.2, 13.3, 13.4, 13.5"
            = |_, ask| strips(&[1, 2, 5]).averages(ask, &scenes::dense(), 4)
            => "A dense box on 1, 2 and 5 ranks: absmin, absavg and neighbours per particle over 4 steps.",
        few_messages after "13.1, 13.2, 13.3, 13.4, 13.5" = |_, ask| few_messages(ask)
            => "20,000 particles on two ranks: (1) the number of steps per list, which must be above four, (2) the \
                number of messages of a rank in a step, which must be below four.",
        program after "13.1, 13.2, 13.3, 13.4, 13.5" = |_, ask| program("13.6", "strips", ask)
            => "The lab's own program on ranks: (1) the official output, (2) whether the whole job ends after one rank \
                is killed.",
    }
    task_13_7 {
        depths_of_ghosts => "The distance that the fastest particle moves in a step, and a number of steps: the \
                             necessary depth of ghosts, all in cutoffs.",
        depths = |random, ask| widths(random, ask, true)
            => "Particles that are at rest, slow or fast, and 1 to 70,000 steps: the necessary depth of ghosts.",
        table_of_depths => "Strips of some heights and numbers of particles, and some speeds: (1) the number of steps \
                            in an epoch, (2) the depth of its ghosts in cutoffs.",
        cheapest_epochs => "Any strip, number of particles and speed: the chosen number of steps in an epoch. With \
                            any other number of steps, a step must cost the same or more.",
    }
    task_13_8 {
        table_of_right_steps => "The greatest distance that a particle went in each step of an epoch, and the depth \
                                 of ghosts, in cutoffs: the number of steps that are correct.",
        right_steps_of_epochs => "1 to 257 steps, and ghosts that are just deep enough for some of these steps, or \
                                  slightly deeper or less deep: the number of steps that are correct.",
        confirmed => "Three ranks, and for each rank the greatest distance that one of its particles went in each of \
                      four steps, in cutoffs: the numbers on which all ranks agree.",
        confirmations => "1, 2, 3 and 5 ranks, and epochs of any length: (1) the number of steps that are correct on \
                          all ranks, (2) the greatest of the ranks' numbers for each step. One Allreduce is allowed.",
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
            => "4 and 5 ranks, and all particles in a single row or in a few rows: the state after each of 20 steps.",
        drifting after "13.2, 13.5, 13.7" = |_, ask| often_cut(deep).resynchronised(ask, &[scenes::drifting()], 40)
            => "Three ranks, and particles that fly from the bottom to the top of the box: the state after each of 40 \
                steps.",
        cut_again after "13.2, 13.5, 13.7" = |_, ask| cut_again(deep, ask)
            => "Three ranks, and particles that fly from the bottom to the top of the box: the number of times that \
                the strips are cut again in 40 steps. It must be at least three.",
        kicked after "13.2, 13.5, 13.7" = |_, ask| deep(&[2, 3, 5]).resynchronised(ask, &[a_kick()], 12)
            => "A particle that is kicked across a border in the middle of an epoch, on 2, 3 and 5 ranks: the state \
                after each of 12 steps.",
        taken_again after "13.2, 13.5, 13.7" = |_, ask| taken_again(ask)
            => "A particle that is kicked across a border in the middle of an epoch: the number of epochs rolled back \
                in 12 steps. It must be at least one.",
        repeated after "13.2, 13.5, 13.7"
            = |_, ask| deep(&[3]).same_bits(ask, &[scenes::dense(), a_kick()], 61, &[])
            => "Two scenes on three ranks, run three times. In one of these runs, no state is read before the end: \
                the state at the end. It must have the same bits in each run.",
        dense_averages after "13.1, 13.2, 13.3, 13.4, 13.5, 13.6, 13.7"
            = |_, ask| deep(&[2]).averages(ask, &scenes::dense(), 4)
            => "A dense box on two ranks: absmin, absavg and neighbours per particle over 4 steps.",
        few_messages after "13.2, 13.5, 13.7" = |_, ask| few_messages_of_epochs(ask)
            => "20,000 particles on 2 and 3 ranks: (1) the number of steps per epoch, which must be above four, (2) \
                the number of messages of a rank in a step, which must be far below one, (3) the number of epochs \
                rolled back, which must be at most two.",
        program after "13.2, 13.5, 13.7" = |_, ask| program_of_epochs(ask)
            => "The lab's own program on ranks: (1) the official output, (2) whether the whole job ends after one rank \
                is killed.",
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
