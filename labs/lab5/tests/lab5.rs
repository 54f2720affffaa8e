//! Lab 5's graders.

use common::soft::{CUTOFF, Statistics};
use lab5::VARIANTS;
use oracle::mpiexec::OnRanks;
use oracle::{Ask, Random, scenes};
use oracle_mpi::RunsOnRanks;

#[path = "lab5/blocks.rs"]
mod blocks;
#[path = "lab5/examples.rs"]
mod examples;
#[path = "lab5/messages.rs"]
mod messages;
#[path = "lab5/questions.rs"]
mod questions;

use examples::*;
use messages::*;
use questions::*;

oracle::questions! {
    task_5_1 {
        rows_and_owners => "Rows of bins that are divided among ranks: (1) the rank that owns each row, (2) the block \
                            of rows of each rank.",
        few_rows => "1 to 30 rows on 1 to 30 ranks: (1) the start and the end of each block, (2) the owner of each \
                     row.",
        many_rows => "Up to 2^50 rows or ranks: (1) the start and the end of some blocks, (2) the owner of some rows. \
                      A search through the ranks would take hours.",
    }
    task_5_2 {
        local_and_remote => "Three ranks with two rows each, and particles that left their bins in a step: (1) the \
                             particles whose new bin is in the rank's rows (local), (2) all other particles (remote).",
        leavers => "A block of rows, and particles that left their bins: (1) the local particles, (2) the remote \
                    particles, which are appended to the particles that the list already contains.",
    }
    task_5_3 {
        copies_of_border_rows => "A dozen particles on three ranks with two rows each: the copies for neighbouring \
                                  ranks. They are copies of the particles in border rows.",
        copies => "A rank and its bins: the rank's copies. There must be one copy of each particle in a row that \
                   another rank sees.",
    }
    task_5_4 {
        gathered => "Three ranks, each with a list of particles (ids): (1) the list that each rank sends, (2) the \
                     lists that the root gets. A bar separates two lists.",
        gathers => "Lists of any length on 1, 2, 3 and 5 ranks: the lists that the root gets, in the order of ranks. \
                    One Gather and one Gatherv are allowed.",
    }
    task_5_5 {
        receivers => "Three ranks that sent leavers and copies (ids) to the root: the list that the root sends to \
                      each rank.",
        parcels => "Any number of ranks, with leavers and copies: the list that the root sends to each rank.",
    }
    task_5_6 {
        scattered => "The root's lists of particles (ids) for three ranks: the list that each rank gets. A bar \
                      separates two lists.",
        scatters => "Lists of any length for 1, 2, 3 and 5 ranks: the list that each rank gets. One Scatter and one \
                     Scatterv are allowed.",
    }
    task_5_7 {
        new_ghosts => "Three ranks with two rows each: (1) the particles (ids) that were in each row before, (2) the \
                       particles that arrive, (3) the particles in each row afterwards. A bar separates two rows.",
        ghosts => "The rows that a rank sees, and particles that arrive: the particles in each bin afterwards. Old \
                   ghosts must be removed, and each arrival must be in its bin.",
    }
    task_5_8 {
        one_exchange after "5.1, 5.2, 5.3, 5.4, 5.5, 5.6, 5.7"
            => "One exchange of a dozen particles on three ranks: the contents (ids) of every buffer before and after \
                each call.",
        broadcasts => "A scene on the root of 1 or 3 ranks: the scene that each rank has afterwards. Three calls of \
                       Bcast are allowed.",
        quiet_steps after "5.1, 5.2, 5.3, 5.4, 5.5, 5.6, 5.7"
            => "A step in which no particle comes near a border: (1) the number of MPI calls, (2) the number of bytes \
                sent.",
        dense_box after "5.1, 5.2, 5.3, 5.4, 5.5, 5.6, 5.7"
            = |_, ask| through_root(&[1, 2, 3, 4, 5]).bits_of_all_pairs(ask, &[scenes::dense()], 20)
            => "150 particles in a dense box on 1 to 5 ranks: the state after each of 20 steps, which must have the \
                same bits as in `all-pairs`.",
        narrow_bins after "5.1, 5.2, 5.3, 5.4, 5.5, 5.6, 5.7"
            = |_, ask| through_root(&[2, 3, 5]).set("bin-size", 1.0).bits_of_all_pairs(ask, &[scenes::dense()], 20)
            => "A dense box with bins of one cutoff on 2, 3 and 5 ranks: the state after each of 20 steps, which must \
                have the same bits as in `all-pairs`.",
        more_ranks_than_rows after "5.1, 5.2, 5.3, 5.4, 5.5, 5.6, 5.7"
            = |_, ask| through_root(&[4, 7]).set("bin-size", 3.0).bits_of_all_pairs(ask, &[scenes::dense()], 10)
            => "A dense box with three rows of bins on 4 and 7 ranks, so that some ranks have no rows: the state \
                after each of 10 steps, which must have the same bits as in `all-pairs`.",
        crowds after "5.1, 5.2, 5.3, 5.4, 5.5, 5.6, 5.7"
            = |_, ask| through_root(&[3]).bits_of_all_pairs(ask, &[scenes::crowd(3), scenes::crowd(4)], 5)
            => "Crowds of 200 particles on three ranks, some of which have no rows: the state after each of 5 steps, \
                which must have the same bits as in `all-pairs`.",
        one_corner after "5.1, 5.2, 5.3, 5.4, 5.5, 5.6, 5.7"
            => "A scene in which all particles are on the first or on the last rank: the state after each of 10 \
                steps, which must have the same bits as in `all-pairs`.",
        fast after "5.1, 5.2, 5.3, 5.4, 5.5, 5.6, 5.7"
            = |_, ask| through_root(&[5]).set("bin-size", 1.0).bits_of_all_pairs(ask, &scenes::fast(), 20)
            => "Particles that cross several ranks in a step: the state after each of 20 steps, which must have the \
                same bits as in `all-pairs`.",
        many_leavers after "5.1, 5.2, 5.3, 5.4, 5.5, 5.6, 5.7"
            => "600 particles, most of which change ranks in a step: the state after each of 3 steps, which must have \
                the same bits as in `all-pairs`.",
        official after "5.1, 5.2, 5.3, 5.4, 5.5, 5.6, 5.7" = |_, ask| through_root(&[1, 2, 3, 4]).official(ask)
            => "The official scene on 1 to 4 ranks: the state after each of 200 steps, which must have the same bits \
                as in `all-pairs`.",
        program after "5.1, 5.2, 5.3, 5.4, 5.5, 5.6, 5.7"
            => "The lab's own program on ranks: (1) the official output, (2) whether the whole job ends after one rank \
                is killed.",
    }
    task_5_9 {
        reduced => "Three ranks, each with its own statistics of one step: the statistics that the root gets.",
        sums => "Statistics with small and large values on 1, 2, 3 and 5 ranks: dmin, davg, navg and pair tests on \
                 the root, and no statistics on the other ranks. Only Reduce is allowed.",
        dense_averages after "5.1, 5.2, 5.3, 5.4, 5.5, 5.6, 5.7, 5.8"
            => "A dense box on 1, 2 and 4 ranks: absmin, absavg and neighbours per particle over 20 steps.",
    }
}

fn through_root(ranks: &[usize]) -> RunsOnRanks {
    RunsOnRanks::new("5.8", VARIANTS, "through-root", ranks)
}

fn one_corner(_: &mut Random, ask: &mut impl Ask) {
    let corners = [0.0, 45.0 * CUTOFF].map(scenes::corner);
    through_root(&[3, 4]).bits_of_all_pairs(ask, &corners, 10);
}

fn many_leavers(_: &mut Random, ask: &mut impl Ask) {
    let scene = scenes::lattice_with_jitter(600, 20.6 * CUTOFF, 400.0, 7);
    through_root(&[2]).bits_of_all_pairs(ask, &[scene], 3);
}

/// Runs the lab's own program, the student's or the solution's.
fn program(_: &mut Random, ask: &mut impl Ask) {
    ask.in_tests_only(|| {
        let program = option_env!("CARGO_BIN_EXE_lab5").or(option_env!("CARGO_BIN_EXE_solution5"));
        let program = program.expect("the lab has its own program");
        let on_ranks = |ranks| OnRanks::new("5.8", program, "through-root", ranks);
        on_ranks(2).official_bytes();
        on_ranks(3).ends_when_a_rank_is_killed();
    });
}

fn dense_averages(_: &mut Random, ask: &mut impl Ask) {
    let runs = RunsOnRanks::new("5.9", VARIANTS, "through-root", &[1, 2, 4]);
    // Calls this task's function first, so that an unsolved starter stops at this task's `todo!`.
    let runs = runs.first(|world| _ = lab5::reduce(world, &Statistics::default()));
    runs.averages(ask, &scenes::dense(), 20);
}
