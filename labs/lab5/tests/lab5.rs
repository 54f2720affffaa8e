//! Lab 5's graders.

use std::ops::Range;
use std::process::ExitCode;

use common::soft::{CUTOFF, Particle, Scene, Statistics};
use common_mpi::{Wire, as_rank, calls_made, displacements, together};
use lab5::{
    Cut, Parcel, border_copies, broadcast, gather_at_root, reduce, replace_ghosts,
    scatter_from_root, sort_by_receiver, take_leavers_of_block,
};
use mpi::Count;
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;
use oracle::mpiexec::{self, Ended, OnRanks, join_columns, print_column};
use oracle::scenes::{self, on_edges};
use oracle::{Random, ask, right, spaced};
use solution2::{Grid, VecBins, take_leavers};
use watched::test;

#[path = "lab5/questions.rs"]
mod questions;

/// The lab's own program: the student's or the solution's.
const PROGRAM: &str =
    match (option_env!("CARGO_BIN_EXE_lab5"), option_env!("CARGO_BIN_EXE_solution5")) {
        (Some(program), _) | (None, Some(program)) => program,
        (None, None) => panic!("the lab has no program"),
    };

fn on_ranks(ranks: usize) -> OnRanks {
    OnRanks::new("5.8", PROGRAM, "through-root", ranks)
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

fn ids(wires: &[Wire]) -> Vec<u64> {
    let mut ids: Vec<_> = wires.iter().map(|wire| wire.id).collect();
    ids.sort_unstable();
    ids
}

/// Lists may be long, so only the first item that differs is shown.
fn same_items(found: &[Wire], expected: &[Wire], what: &str) {
    assert_eq!(found.len(), expected.len(), "{what}: how many items arrived");
    for (k, (found, expected)) in found.iter().zip(expected).enumerate() {
        assert_eq!(found, expected, "{what}: item {k}");
    }
}

/// What a rank has: another number of items for each rank.
fn items(rank: i32, factor: u64) -> Vec<Wire> {
    let ids = 0..(rank as u64 * 7 + 4) % 5 * factor;
    ids.map(|id| Wire { x: f64::from(rank), id, ..Wire::default() }).collect()
}

/// The wires of these particles.
fn wires(particles: &[Particle], ids: &[usize]) -> Vec<Wire> {
    ids.iter().map(|&id| Wire::from(&particles[id])).collect()
}

#[test]
fn task_5_1_blocks_are_cut_where_the_lab_says_and_owners_have_their_rows() {
    questions::cuts(&mut Random::new(51), &mut right);
}

#[test]
fn task_5_1_table_of_rows_and_owners() {
    let mut table = String::from("rows  ranks  rank of each row             block of each rank\n");
    for (rows, ranks) in [(6, 3), (10, 4), (7, 3), (3, 4), (2, 5)] {
        let cut = Cut { rows, ranks };
        let owners = spaced((0..rows).map(|row| cut.owner(row)));
        let blocks = spaced((0..ranks).map(|rank| format!("{:?}", cut.block(rank))));
        table += &format!("{rows:>4}  {ranks:>5}  {owners:<27}  {blocks}\n");
    }
    insta::assert_snapshot!(table);
}

#[test]
fn task_5_2_particles_outside_the_block_are_remote() {
    questions::leavers(&mut Random::new(52), &mut right);
}

#[test]
fn task_5_3_every_particle_of_a_border_row_is_copied_once() {
    questions::copies(&mut Random::new(53), &mut right);
}

#[test]
fn task_5_4_the_root_gets_everything_in_the_order_of_ranks() {
    on_each("5.4", &[1, 2, 3, 5], |world| {
        // Nothing at all, a few items on some ranks, more than 16 bits count, and then less.
        for factor in [0, 1, 20_000, 1] {
            let list = |rank: i32| items(rank, factor);
            let own = list(world.rank());
            let what = format!("gather_at_root with {} items", own.len());
            let lists = together(&what, || gather_at_root(world, &own));
            if world.rank() == 0 {
                assert_eq!(
                    lists.len(),
                    world.size() as usize,
                    "lists on the root, one for each rank"
                );
                for (rank, found) in (0..).zip(&lists) {
                    same_items(found, &list(rank), &format!("what rank {rank} sent to the root"));
                }
            } else {
                assert_eq!(
                    lists.len(),
                    0,
                    "lists that rank {} gets: only the root has any",
                    world.rank()
                );
            }
        }
    });
}

#[test]
fn task_5_4_it_takes_two_collective_operations() {
    on_each("5.4", &[3], |world| {
        let own = items(world.rank(), 1);
        together("gather_at_root", || gather_at_root(world, &own));
        assert_eq!(
            calls_made(),
            ["MPI_Gather", "MPI_Gatherv"],
            "the calls of rank {} in gather_at_root: the numbers are gathered, then the items",
            world.rank()
        );
    });
}

#[test]
fn task_5_5_every_rank_gets_what_it_owns_and_what_it_sees() {
    questions::parcels(&mut Random::new(55), &mut right);
}

#[test]
fn task_5_5_table_of_receivers() {
    // The example of chapter 5: what the two gathers bring to the root, and what it makes of it.
    let (grid, cut) = (Grid::with_bins_along(6.0, 6), Cut { rows: 6, ranks: 3 });
    let [_, after] = scenes::dozen();
    let parcel = |leavers: &[usize], copies: &[usize]| Parcel {
        leavers: wires(&after, leavers),
        copies: wires(&after, copies),
    };
    let parcels = [parcel(&[3], &[1, 2]), parcel(&[], &[4, 5, 6, 7]), parcel(&[8, 11], &[9])];
    let lists = sort_by_receiver(&grid, &cut, &parcels);
    let mut table = String::from("rank  leavers  copies   its list\n");
    for (rank, (parcel, list)) in parcels.iter().zip(&lists).enumerate() {
        let [leavers, copies, list] =
            [&parcel.leavers, &parcel.copies, list].map(|wires| spaced(ids(wires)));
        table += &format!("{rank:>4}  {leavers:<7}  {copies:<7}  {list}\n");
    }
    insta::assert_snapshot!(table);
}

#[test]
fn task_5_6_every_rank_gets_what_is_its_own() {
    on_each("5.6", &[1, 2, 3, 5], |world| {
        for factor in [0, 1, 20_000, 1] {
            let list = |rank: i32| items(rank, factor);
            let root = world.rank() == 0;
            let lists: Vec<_> =
                if root { (0..world.size()).map(list).collect() } else { Vec::new() };
            let what = format!("scatter_from_root, for {} items", list(world.rank()).len());
            let found = together(&what, || scatter_from_root(world, &lists));
            let what = format!("what the root sent to rank {}", world.rank());
            same_items(&found, &list(world.rank()), &what);
        }
    });
}

#[test]
fn task_5_7_old_ghosts_go_and_new_ones_come() {
    questions::ghosts(&mut Random::new(57), &mut right);
}

#[test]
fn task_5_8_all_ranks_get_the_scene() {
    on_each("5.8", &[1, 3], |world| {
        // More than sixteen bits count, and then less than before.
        for (n, side) in [(70_000, 3.0), (1, 6.0), (12, 0.1)] {
            let expected = on_edges(&mut Random::new(n), n as usize, side, 9);
            let scene = Scene::new(side, expected.clone()).expect("the scene is sound");
            let root = world.rank() == 0;
            let (size, found) = together("broadcast", || broadcast(world, root.then_some(&scene)));
            let rank = world.rank();
            assert_eq!(size, side, "the side of the box on rank {rank}");
            assert_eq!(found.len(), expected.len(), "how many particles rank {rank} got");
            for (found, expected) in found.iter().zip(&expected) {
                assert_eq!(found, expected, "a particle on rank {rank}");
            }
        }
    });
}

/// One exchange of the dozen particles of chapter 5: every buffer before and after each call.
#[test]
fn task_5_8_the_example_of_the_book() {
    let job = on_each("5.8", &[3], |world| {
        let (rank, root) = (world.rank(), world.rank() == 0);
        let (grid, cut) = (Grid::with_bins_along(6.0, 6), Cut { rows: 6, ranks: 3 });
        let [before, after] = scenes::dozen();
        let scene = Scene::new(6.0, before).expect("the scene is sound");
        let (_, particles) = together("broadcast", || broadcast(world, root.then_some(&scene)));
        // Within a list any order is right.
        let numbers = |wires: &[Wire]| spaced(ids(wires));
        let parts = |lists: &[Vec<Wire>]| {
            lists.iter().map(|list| numbers(list)).collect::<Vec<_>>().join("|")
        };
        let sorted = |particles: &[Particle]| {
            let wires: Vec<Wire> = particles.iter().map(Wire::from).collect();
            numbers(&wires)
        };
        let mut rows = vec![("scene after Bcast", format!("{} particles", particles.len()))];

        let block = cut.block(rank as usize);
        let visible = block.start.saturating_sub(1)..(block.end + 1).min(6);
        let mut bins = VecBins::new(grid);
        particles.iter().filter(|p| visible.contains(&grid.row(p.y))).for_each(|p| bins.put(*p));
        rows.push(("its rows; ghosts in ()", content(&bins, &block)));

        let mut changed = Vec::new();
        for (bin, inside) in bins.bins_mut().iter_mut().enumerate() {
            if block.contains(&(bin / 6)) {
                inside.iter_mut().for_each(|p| *p = after[p.id as usize]);
                take_leavers(&grid, bin, inside, &mut changed);
            }
        }
        rows.push(("moved; left their bins", sorted(&changed)));
        let mut remote = Vec::new();
        take_leavers_of_block(&grid, &block, &mut changed, &mut remote);
        rows.push(("  local", sorted(&changed)));
        rows.push(("  remote", sorted(&remote)));
        changed.into_iter().for_each(|p| bins.put(p));
        rows.push(("local ones are back", content(&bins, &block)));

        let leavers: Vec<Wire> = remote.iter().map(Wire::from).collect();
        let copies = border_copies(&bins, &cut, &block);
        rows.push(("copies", numbers(&copies)));
        let at_root = |text: String| if root { text } else { String::new() };
        let mut gathered = |what: &'static str, own: &[Wire]| {
            let lists = together(what, || gather_at_root(world, own));
            let counts: Vec<Count> = lists.iter().map(|list| list.len() as Count).collect();
            rows.push((what, own.len().to_string()));
            rows.push(("  counts", at_root(spaced(&counts))));
            rows.push(("  displacements", at_root(spaced(displacements(&counts)))));
            rows.push(("  buffer after Gatherv", at_root(parts(&lists))));
            lists
        };
        let all_leavers = gathered("leavers: Gather counts", &leavers);
        let all_copies = gathered("copies: Gather counts", &copies);
        let parcels: Vec<Parcel> = all_leavers
            .into_iter()
            .zip(all_copies)
            .map(|(leavers, copies)| Parcel { leavers, copies })
            .collect();
        let lists = if root { sort_by_receiver(&grid, &cut, &parcels) } else { Vec::new() };
        let counts: Vec<Count> = lists.iter().map(|list| list.len() as Count).collect();
        rows.push(("buffer to scatter", at_root(parts(&lists))));
        rows.push(("  counts", at_root(spaced(&counts))));
        rows.push(("  displacements", at_root(spaced(displacements(&counts)))));
        let arrived = together("scatter_from_root", || scatter_from_root(world, &lists));
        rows.push(("after Scatter: a count", arrived.len().to_string()));
        rows.push(("after Scatterv", numbers(&arrived)));
        // Without a look at its rows: no old ghost goes.
        let mut stale = VecBins::new(grid);
        let arrivals: Vec<Particle> = arrived.iter().map(Particle::from).collect();
        bins.particles().chain(&arrivals).for_each(|p| stale.put(*p));
        replace_ghosts(&mut bins, &block, &arrived);
        rows.push(("its rows; ghosts in ()", content(&bins, &block)));
        rows.push(("  had old ones stayed", content(&stale, &block)));
        print_column(rank, &rows);
    });
    insta::assert_snapshot!(join_columns(&job.stdout));
}

/// The ids in each row of bins that holds any, those of ghosts in parentheses.
fn content(bins: &VecBins, block: &Range<usize>) -> String {
    let columns = bins.grid().columns();
    let row = |row: usize| {
        let inside = bins.bins()[row * columns..(row + 1) * columns].iter().flatten();
        let wires: Vec<Wire> = inside.map(Wire::from).collect();
        let ids = spaced(ids(&wires));
        if block.contains(&row) { ids } else { format!("({ids})") }
    };
    let visible = block.start.saturating_sub(1)..(block.end + 1).min(bins.grid().rows());
    visible.map(row).collect::<Vec<_>>().join("|")
}

#[test]
fn task_5_8_the_bits_of_all_pairs_in_a_dense_box() {
    for ranks in 1..=5 {
        on_ranks(ranks).bits_of_all_pairs(&scenes::dense(), 20);
    }
}

#[test]
fn task_5_8_the_bits_of_all_pairs_with_narrow_bins() {
    for ranks in [2, 3, 5] {
        on_ranks(ranks).option("--param", "bin-size=1").bits_of_all_pairs(&scenes::dense(), 20);
    }
}

#[test]
fn task_5_8_more_ranks_than_rows() {
    for ranks in [4, 7] {
        on_ranks(ranks).option("--param", "bin-size=3").bits_of_all_pairs(&scenes::dense(), 10);
    }
    on_ranks(3).bits_of_all_pairs(&scenes::crowd(3), 5);
}

#[test]
fn task_5_8_all_particles_on_one_rank() {
    on_ranks(4).bits_of_all_pairs(&scenes::corner(0.0), 10);
    on_ranks(3).bits_of_all_pairs(&scenes::corner(45.0 * CUTOFF), 10);
}

#[test]
fn task_5_8_particles_that_cross_several_ranks_in_a_step() {
    for scene in scenes::fast() {
        on_ranks(5).option("--param", "bin-size=1").bits_of_all_pairs(&scene, 20);
    }
}

#[test]
fn task_5_8_the_official_bytes() {
    for ranks in 1..=4 {
        on_ranks(ranks).official_bytes();
    }
}

#[test]
fn task_5_8_a_killed_rank_ends_the_job() {
    on_ranks(3).ends_when_a_rank_is_killed();
}

#[test]
fn task_5_9_statistics_of_all_ranks() {
    on_each("5.9", &[1, 3, 5], sums_of_all_ranks);
}

/// Counts of any size: those of a long run on a large machine do not fit into 32 bits.
fn sums_of_all_ranks(world: &SimpleCommunicator) {
    let (rank, ranks) = (world.rank(), world.size());
    let mut random = Random::new(59);
    for round in 0..8 {
        let mut count = || random.bits() >> (5 + 8 * (round % 8));
        let counts: Vec<[u64; 2]> = (0..ranks).map(|_| [count(), count()]).collect();
        let davg: Vec<f64> = (0..ranks).map(|_| random.magnitude(1e-3, 1e6)).collect();
        let of = |rank: i32| Statistics {
            dmin: 0.5 + f64::from((rank + 2 + round) % ranks) / 16.0,
            davg: davg[rank as usize],
            navg: counts[rank as usize][0],
            pair_tests: counts[rank as usize][1],
        };
        let mut found = together("reduce", || reduce(world, &of(rank)));
        let sum = |which: usize| counts.iter().map(|counts| counts[which]).sum();
        let davg: f64 = davg.iter().sum();
        let expected = Statistics { dmin: 0.5, davg, navg: sum(0), pair_tests: sum(1) };
        let expected = (rank == 0).then_some(expected);
        // Ranks may be added up in any order.
        found.iter_mut().for_each(|all| all.davg = ask::rounded(all.davg, davg, davg));
        assert_eq!(found, expected, "round {round}: statistics of {ranks} ranks on rank {rank}");
    }
}

#[test]
fn task_5_9_statistics_of_a_dense_box() {
    on_each("5.9", &[2], sums_of_all_ranks);
    let averages = |ranks: usize| {
        OnRanks::new("5.9", PROGRAM, "through-root", ranks).averages(&scenes::dense(), 20)
    };
    let one = averages(1);
    for ranks in [2, 4] {
        assert_eq!(averages(ranks), one, "statistics of {ranks} ranks");
    }
}
