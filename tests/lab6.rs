use std::process::ExitCode;

use common::soft::{CUTOFF, Particle, Scene};
use common_mpi::{Wire, as_rank};
use lab6::{
    Cuts, balanced, exchange_all, exchange_beside, interior_rows, keep_share, sort_leavers,
};
use mpi::collective::SystemOperation;
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;
use oracle::mpiexec::{self, Ended, OnRanks, join_columns, print_column};
use oracle::scenes::{self, on_edges};
use oracle::{Model, Random, ask, right, spaced};
use solution2::Grid;
use watched::test;

#[path = "lab6/messages.rs"]
mod messages;
#[path = "lab6/questions.rs"]
mod questions;

/// The lab's own program: the student's or the solution's.
const PROGRAM: &str =
    match (option_env!("CARGO_BIN_EXE_lab6"), option_env!("CARGO_BIN_EXE_solution6")) {
        (Some(program), _) | (None, Some(program)) => program,
        (None, None) => panic!("the lab has no program"),
    };

fn on_ranks(ranks: usize) -> OnRanks {
    OnRanks::new("6.7", PROGRAM, "halo", ranks)
}

/// Has each rank of a job do `check`, on each of these numbers of ranks.
fn on_each(task: &str, counts: &[usize], check: impl FnOnce(&SimpleCommunicator)) -> Ended {
    mpiexec::on_each(task, counts, || {
        as_rank(|world| {
            check(world);
            ExitCode::SUCCESS
        });
    })
}

fn cuts(starts: &[usize]) -> Cuts {
    Cuts { starts: starts.to_vec() }
}

#[test]
fn task_6_1_blocks_are_cut_where_the_lab_says() {
    questions::balance(&mut Random::new(60), &mut right);
}

#[test]
fn task_6_1_table_of_blocks() {
    let mut table = String::new();
    for (counts, ranks) in [
        (vec![2, 2, 2, 2, 2, 2], 3),
        (vec![7, 3, 1, 1, 0, 0], 3),
        (vec![0, 0, 12, 0, 0, 0], 3),
        (vec![5, 4, 3, 2, 1, 0, 0, 0, 0, 1], 4),
    ] {
        let cuts = balanced(&counts, ranks);
        table += &format!("particles in each row: {}\n", spaced(&counts));
        for rank in 0..ranks {
            let block = cuts.block(rank);
            let held: u64 = counts[block.clone()].iter().sum();
            table += &format!("  rank {rank} has rows {block:?}, {held} particles\n");
        }
    }
    insta::assert_snapshot!(table);
}

#[test]
fn task_6_2_neighbours_have_the_rows_next_door() {
    questions::neighbours(&mut Random::new(62), &mut right);
}

#[test]
fn task_6_3_lists_reach_the_neighbours_while_work_is_done() {
    on_each("6.3", &[1, 2, 3, 5], |world| {
        messages::beside(world, &mut Random::new(63), &mut right);
    });
}

#[test]
fn task_6_4_every_list_reaches_its_rank() {
    on_each("6.4", &[1, 2, 3, 5], |world| {
        messages::all(world, &mut Random::new(64), &mut right);
    });
}

#[test]
fn task_6_5_interior_rows_have_their_neighbours_at_home() {
    questions::interiors(&mut right);
}

#[test]
fn task_6_6_leavers_go_to_neighbours_or_further() {
    questions::leavers(&mut Random::new(66), &mut right);
}

/// The messages of one step of the dozen particles of chapters 5 and 6, two rows to a rank.
#[test]
fn task_6_6_the_example_of_the_book() {
    let job = on_each("6.6", &[3], |world| {
        let rank = world.rank() as usize;
        let (grid, cuts) = (Grid::with_bins_along(6.0, 6), cuts(&[0, 2, 4, 6]));
        let neighbours = [rank.checked_sub(1), Some(rank + 1).filter(|rank| *rank < 3)];
        let [before, after] = scenes::dozen();
        let is_own = |p: &&Particle| cuts.owner(grid.row(p.y)) == rank;
        let own: Vec<&Particle> = before.iter().filter(is_own).collect();
        let moved = own.iter().map(|p| &after[p.id as usize]);
        let leavers: Vec<Wire> = moved.filter(|p| !is_own(p)).map(Wire::from).collect();
        let sorted = sort_leavers(&grid, &cuts, neighbours, &leavers);

        let mut rows = vec![("own particles", spaced(own.iter().map(|p| p.id)))];
        let borders = [2 * rank, 2 * rank + 1];
        let ghosts = borders.map(|border| {
            let of_row = own.iter().filter(|p| grid.row(p.y) == border);
            of_row.map(|p| Wire::from(*p)).collect::<Vec<_>>()
        });
        let names = ["ghosts to the rank before", "ghosts to the rank after"];
        // Forces meanwhile on the particles of interior rows, on the others when the ghosts are there.
        let block = 2 * rank..2 * rank + 2;
        let interior = interior_rows(&block, 6);
        let lies_inside = |p: &&&Particle| interior.contains(&grid.row(p.y));
        let meanwhile = || spaced(own.iter().filter(lies_inside).map(|p| p.id));
        let (arrived, summed) = both_ways(world, neighbours, ghosts, names, &mut rows, meanwhile);
        rows.push(("meanwhile, forces on", summed));
        rows.push(("ghosts from both", arrived));
        let later = own.iter().filter(|p| !lies_inside(p));
        rows.push(("then forces on", spaced(later.map(|p| p.id))));
        rows.push(("moved; out of the block", spaced(leavers.iter().map(|wire| wire.id))));
        let names = ["movers to the rank before", "movers to the rank after"];
        let (arrived, ()) = both_ways(world, neighbours, sorted.near, names, &mut rows, || ());
        rows.push(("movers from both", arrived));

        let (own_far, mut all_far) = (sorted.far.len() as u64, 0);
        world.all_reduce_into(&own_far, &mut all_far, SystemOperation::sum());
        rows.push(("count of far movers", own_far.to_string()));
        rows.push(("  count of all ranks", all_far.to_string()));
        let mut lists = vec![Vec::new(); 3];
        sorted.far.into_iter().for_each(|(to, wire)| lists[to].push(wire));
        let arrived = exchange_all(world, &lists);
        rows.push(("  after Alltoallv", spaced(arrived.iter().map(|wire| wire.id))));
        print_column(world.rank(), &rows);
    });
    insta::assert_snapshot!(join_columns(&job.stdout));
}

/// Sends a list to the rank before and one to the rank after, where there is such a rank, notes
/// them down in `rows`, and returns the ids of what arrives and the result of `work`.
fn both_ways<'a, R>(
    world: &SimpleCommunicator,
    neighbours: [Option<usize>; 2],
    lists: [Vec<Wire>; 2],
    names: [&'a str; 2],
    rows: &mut Vec<(&'a str, String)>,
    work: impl FnOnce() -> R,
) -> (String, R) {
    let mut outgoing = Vec::new();
    for ((neighbour, list), name) in neighbours.into_iter().zip(lists).zip(names) {
        let ids = neighbour.map(|_| spaced(list.iter().map(|wire| wire.id)));
        rows.push((name, ids.unwrap_or_default()));
        outgoing.extend(neighbour.map(|rank| (rank as i32, list)));
    }
    let (incoming, worked) = exchange_beside(world, &outgoing, work);
    (spaced(incoming.iter().flatten().map(|wire| wire.id)), worked)
}

#[test]
fn task_6_7_a_share_is_what_lies_in_the_own_block() {
    // Where rows are cut is another task.
    keep_share(&Grid::with_bins_along(1.0, 1), 1, 0, &|_| ());
    questions::shares(&mut Random::new(67), &mut right);
}

#[test]
fn task_6_7_the_bits_of_all_pairs_in_a_dense_box() {
    (1..=5).for_each(|ranks| on_ranks(ranks).bits_of_all_pairs(&scenes::dense(), 20));
}

#[test]
fn task_6_7_a_scene_that_each_rank_makes_for_itself() {
    // A scene that ranks are shown comes first: the other kind passes by the task.
    on_ranks(2).bits_of_all_pairs(&scenes::crowd(3), 1);
    for ranks in 1..=4 {
        on_ranks(ranks).bits_of_all_pairs_in_a_counter_scene(500, 120);
    }
}

#[test]
fn task_6_7_the_bits_of_all_pairs_by_every_route() {
    for variant in ["hybrid", "alltoallv"] {
        let grader = OnRanks::new("6.7", PROGRAM, variant, 3).option("-t", "3");
        grader.bits_of_all_pairs(&scenes::dense(), 20);
        grader.bits_of_all_pairs(&scenes::fast()[0], 5);
    }
}

#[test]
fn task_6_7_more_ranks_than_rows() {
    for ranks in [4, 7] {
        on_ranks(ranks).option("--param", "bin-size=3").bits_of_all_pairs(&scenes::dense(), 10);
    }
    on_ranks(3).bits_of_all_pairs(&scenes::crowd(3), 5);
}

#[test]
fn task_6_7_all_particles_in_a_few_rows() {
    for y in [0.0, 45.0 * CUTOFF] {
        on_ranks(4).bits_of_all_pairs(&scenes::corner(y), 10);
    }
    // Blocks of other ranks have rows and no particles, or no rows.
    on_ranks(5).bits_of_all_pairs(&scenes::one_row(), 10);
}

#[test]
fn task_6_7_particles_that_cross_several_ranks_in_a_step() {
    for scene in scenes::fast() {
        on_ranks(5).bits_of_all_pairs(&scene, 20);
    }
}

#[test]
fn task_6_7_rows_are_cut_anew_when_the_scene_drifts() {
    let scene = scenes::drifting();
    let grader = on_ranks(3).option("--param", "rebalance=4");
    grader.bits_of_all_pairs(&scene, 40);
    let [anew] = grader.counters(&scene, 40, ["times the rows were cut anew"]);
    assert!(anew >= 3.0, "the scene crossed the box and the rows were cut anew {anew} times");
}

#[test]
fn task_6_7_the_remainder_can_go_to_the_last_rank() {
    let scene = Scene::official(500, 1).expect("500 particles are a scene");
    let grader = on_ranks(5).option("--param", "bin-size=2").option("--param", "remainder-last=1");
    let [fullest] = grader.counters(&scene, 1, ["particles, fullest rank"]);
    // 24 rows: 4 for each rank, and 4 more for the last.
    let grid = Grid::with_bins_along(scene.size(), 24);
    let mut model = Model::new(&scene);
    model.step();
    let last = model.particles.iter().filter(|particle| grid.row(particle.y) >= 16).count();
    assert_eq!(fullest, last as f64);
    grader.bits_of_all_pairs(&scenes::dense(), 10);
}

#[test]
fn task_6_7_statistics_of_a_dense_box() {
    let averages = |ranks| on_ranks(ranks).averages(&scenes::dense(), 20);
    let one = averages(1);
    for ranks in [2, 4] {
        assert_eq!(averages(ranks), one, "statistics of {ranks} ranks");
    }
}

#[test]
fn task_6_7_the_official_bytes() {
    (1..=4).for_each(|ranks| on_ranks(ranks).official_bytes());
}

#[test]
fn task_6_7_a_killed_rank_ends_the_job() {
    on_ranks(3).ends_when_a_rank_is_killed();
}
