//! Lab 6's graders.

use common::soft::{CUTOFF, Scene};
use lab6::{VARIANTS, keep_share};
use oracle::mpiexec::OnRanks;
use oracle::{Ask, Model, Random, scenes};
use oracle_mpi::RunsOnRanks;
use solution2::Grid;

#[path = "lab6/blocks.rs"]
mod blocks;
#[path = "lab6/examples.rs"]
mod examples;
#[path = "lab6/messages.rs"]
mod messages;
#[path = "lab6/particles.rs"]
mod particles;
#[path = "lab6/step.rs"]
mod step;

use blocks::*;
use examples::*;
use messages::*;
use particles::*;
use step::*;

oracle::questions! {
    task_6_1 {
        table_of_blocks => "The number of particles in each row, and a number of ranks: (1) the block of rows of each \
                            rank, (2) the number of particles in this block.",
        starts_of_blocks => "1 to 4,000 rows and ranks. Some cases have few particles, and some have more particles \
                             than 32 bits can count: the row at which each block starts.",
        a_million_blocks => "A million rows and a million ranks: the row at which each block starts.",
    }
    task_6_2 {
        table_of_neighbours => "Blocks of rows, some of which are empty: (1) the rank that has the row before each \
                                block, (2) the rank that has the row after it.",
        neighbours_of_ranks => "Any blocks of rows, many of which are empty: (1) the rank that has the row before a \
                                block, (2) the rank that has the row after it.",
    }
    task_6_3 {
        both_ways => "Lists of numbers between three ranks: (1) the messages under way when `work` is called, (2) the \
                      result of `work`, (3) the lists that each rank gets.",
        exchanges => "Lists of any length between 1, 2, 3 and 5 ranks: (1) the messages under way when `work` is \
                      called, (2) the lists that each rank gets.",
    }
    task_6_4 {
        from_all_to_all => "Three ranks, each with one list of numbers for every rank: the lists that each rank gets. \
                            A bar separates two lists.",
        lists_of_all => "1, 2, 3 and 5 ranks, each with one list of any length for every rank: the lists that each \
                         rank gets.",
    }
    task_6_5 {
        table_of_interiors => "Blocks of rows: the interior rows, which can be computed before the ghosts arrive.",
        interiors => "Every block of 1 to 8 rows: the interior rows, which can be computed before the ghosts arrive.",
    }
    task_6_6 {
        table_of_leavers => "Particles that left the block of a rank, and their new rows: the particles (1) for the \
                             neighbour with the lower number, (2) for the neighbour with the higher number, (3) for \
                             ranks farther away.",
        leavers => "60 particles that left the block of any rank: the particles (1) for the neighbour with \
                    the lower number, (2) for the neighbour with the higher number, (3) for ranks farther away.",
        one_step after "6.3, 6.4, 6.5" => "One step of a dozen particles on ranks with two rows each: the messages \
                                           that each rank sends and gets.",
    }
    task_6_7 {
        table_of_shares after "6.1" => "A dozen particles in six rows on three ranks: (1) the block of each rank, (2) \
                                        the particles (ids) that the rank keeps.",
        shares after "6.1" => "Scenes of 1 to 70,000 particles: (1) the row at which each block starts, (2) the \
                               particles that a rank keeps, (3) the number of times that the rank replays the scene.",
        large_scene after "6.1" => "Four million particles on 256 ranks: (1) the number of particles that a rank \
                                    keeps, (2) the memory that the rank needs for these particles.",
        dense_box after "6.1, 6.2, 6.3, 6.4, 6.5, 6.6"
            = |_, ask| halo(&[1, 2, 3, 4, 5]).bits_of_all_pairs(ask, &[scenes::dense()], 20)
            => "150 particles in a dense box on 1 to 5 ranks: the state after each of 20 steps, which must have the \
                same bits as in `all-pairs`.",
        counter_scene after "6.1, 6.2, 6.3, 6.4, 6.5, 6.6"
            = |_, ask| halo(&[1, 2, 3, 4]).bits_in_a_counter_scene(ask, 500, 120)
            => "500 particles on 1 to 4 ranks, each of which makes its own particles: the state after each of 120 \
                steps, which must have the same bits as in `all-pairs`.",
        with_threads after "6.1, 6.2, 6.3, 6.4, 6.5, 6.6" = |_, ask| by_other_ways(ask, "hybrid")
            => "Three ranks with three threads each: the state after each of 20 steps, which must have the same bits \
                as in `all-pairs`.",
        by_alltoallv after "6.1, 6.2, 6.3, 6.4, 6.5, 6.6" = |_, ask| by_other_ways(ask, "alltoallv")
            => "Three ranks that exchange all lists with Alltoallv: the state after each of 20 steps, which must have \
                the same bits as in `all-pairs`.",
        more_ranks_than_rows after "6.1, 6.2, 6.3, 6.4, 6.5, 6.6"
            = |_, ask| halo(&[4, 7]).set("bin-size", 3.0).bits_of_all_pairs(ask, &[scenes::dense()], 10)
            => "A dense box with three rows of bins on 4 and 7 ranks: the state after each of 10 steps, which must \
                have the same bits as in `all-pairs`.",
        crowds after "6.1, 6.2, 6.3, 6.4, 6.5, 6.6"
            = |_, ask| halo(&[2, 3]).bits_of_all_pairs(ask, &[scenes::crowd(3), scenes::crowd(4)], 5)
            => "Crowds of 200 particles on 2 and 3 ranks: the state after each of 5 steps, which must have the same \
                bits as in `all-pairs`.",
        few_rows after "6.1, 6.2, 6.3, 6.4, 6.5, 6.6"
            => "4 and 5 ranks, and all particles in a single row or in a few rows: the state after each of 10 steps, \
                which must have the same bits as in `all-pairs`.",
        fast after "6.1, 6.2, 6.3, 6.4, 6.5, 6.6"
            = |_, ask| halo(&[5]).bits_of_all_pairs(ask, &scenes::fast(), 20)
            => "Particles that cross several ranks in a step: the state after each of 20 steps, which must have the \
                same bits as in `all-pairs`.",
        drifting after "6.1, 6.2, 6.3, 6.4, 6.5, 6.6"
            = |_, ask| often_cut().bits_of_all_pairs(ask, &[scenes::drifting()], 40)
            => "Three ranks that divide the rows again every 4 steps, and particles that fly from the bottom to the \
                top of the box: the state after each of 40 steps, which must have the same bits as in `all-pairs`.",
        cut_again after "6.1, 6.2, 6.3, 6.4, 6.5, 6.6"
            => "Three ranks, and particles that fly from the bottom to the top of the box: the number of times that \
                the ranks divide the rows again in 40 steps. It must be at least three.",
        remainder_last after "6.1, 6.2, 6.3, 6.4, 6.5, 6.6"
            => "24 rows on five ranks. Each rank has four rows, and the last rank has four more: the number of \
                particles on the last rank.",
        remainder_last_bits after "6.1, 6.2, 6.3, 6.4, 6.5, 6.6"
            = |_, ask| with_remainder().bits_of_all_pairs(ask, &[scenes::dense()], 10)
            => "A dense box on five ranks, the last of which has all remaining rows: the state after each of 10 \
                steps, which must have the same bits as in `all-pairs`.",
        dense_averages after "6.1, 6.2, 6.3, 6.4, 6.5, 6.6"
            = |_, ask| halo(&[1, 2, 4]).averages(ask, &scenes::dense(), 20)
            => "A dense box on 1, 2 and 4 ranks: absmin, absavg and neighbours per particle over 20 steps.",
        official after "6.1, 6.2, 6.3, 6.4, 6.5, 6.6" = |_, ask| halo(&[1, 2, 3, 4]).official(ask)
            => "The official scene on 1 to 4 ranks: the state after each of 200 steps, which must have the same bits \
                as in `all-pairs`.",
        program after "6.1, 6.2, 6.3, 6.4, 6.5, 6.6"
            => "The lab's own program on ranks: (1) the official output, (2) whether the whole job ends after one rank \
                is killed.",
    }
}

/// Returns runs of a variant on each of these numbers of ranks. An unsolved starter stops at the
/// `todo!` of this task.
fn runs(variant: &str, ranks: &[usize]) -> RunsOnRanks {
    RunsOnRanks::new("6.7", VARIANTS, variant, ranks)
        .first(|_| _ = keep_share(&Grid::with_bins_along(1.0, 1), 1, 0, &|_| ()))
}

fn halo(ranks: &[usize]) -> RunsOnRanks {
    runs("halo", ranks)
}

fn by_other_ways(ask: &mut impl Ask, variant: &str) {
    let [fast, _] = scenes::fast();
    runs(variant, &[3]).threads(3).bits_of_all_pairs(ask, &[scenes::dense(), fast], 20);
}

fn few_rows(_: &mut Random, ask: &mut impl Ask) {
    // Blocks of other ranks have rows without particles, or no rows.
    let all = [scenes::corner(0.0), scenes::corner(45.0 * CUTOFF), scenes::one_row()];
    halo(&[4, 5]).bits_of_all_pairs(ask, &all, 10);
}

fn often_cut() -> RunsOnRanks {
    halo(&[3]).set("rebalance", 4.0)
}

fn cut_again(_: &mut Random, ask: &mut impl Ask) {
    let names = ["times the rows were cut again"];
    often_cut().counters(ask, &scenes::drifting(), 40, &names, |_, found| match found {
        [times] if *times >= 3.0 => Ok(()),
        _ => Err(format!("the rows were cut again {found:?} times, but must be cut again at least 3 times, because \
                          the particles crossed the box")),
    });
}

/// Returns the number of rows of each of five ranks: equal numbers, and the remainder for the last
/// rank.
fn with_remainder() -> RunsOnRanks {
    halo(&[5]).set("bin-size", 2.0).set("remainder-last", 1.0)
}

/// Asks about 24 rows: 4 for each rank, and 4 more for the last.
fn remainder_last(_: &mut Random, ask: &mut impl Ask) {
    let scene = Scene::official(500, 1).expect("the scene is valid");
    let names = ["particles, fullest rank"];
    with_remainder().counters(ask, &scene, 1, &names, |_, found| {
        let grid = Grid::with_bins_along(scene.size(), 24);
        let mut model = Model::new(&scene);
        model.step();
        let last = model.particles.iter().filter(|particle| grid.row(particle.y) >= 16).count();
        if found == [last as f64] {
            return Ok(());
        }
        Err(format!("the last rank has {found:?} particles, but must have {last}, the number of particles in the last \
                     eight rows"))
    });
}

/// Runs the lab's own program, the student's or the solution's.
fn program(_: &mut Random, ask: &mut impl Ask) {
    ask.in_tests_only(|| {
        let program = option_env!("CARGO_BIN_EXE_lab6").or(option_env!("CARGO_BIN_EXE_solution6"));
        let program = program.expect("the lab has its own program");
        let on_ranks = |ranks| OnRanks::new("6.7", program, "halo", ranks);
        on_ranks(3).official_bytes();
        on_ranks(3).ends_when_a_rank_is_killed();
    });
}
