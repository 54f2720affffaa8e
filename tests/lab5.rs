use std::ops::Range;
use std::process::ExitCode;

use common::soft::{CUTOFF, Particle, Scene};
use common_mpi::{Wire, as_rank, displacements, together};
use lab5::{
    Cut, Parcel, border_copies, broadcast, gather_at_root, replace_ghosts, scatter_from_root,
    sort_by_receiver, take_leavers_of_block,
};
use mpi::Count;
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;
use oracle::mpiexec::{self, Ended, OnRanks, join_columns, print_column};
use oracle::scenes::{self, on_edges};
use oracle::{Random, ask, right, spaced, within};
use solution2::{Grid, VecBins, take_leavers};
use watched::test;

#[path = "lab5/messages.rs"]
mod messages;
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

/// The wires of these particles.
fn wires(particles: &[Particle], ids: &[usize]) -> Vec<Wire> {
    ids.iter().map(|&id| Wire::from(&particles[id])).collect()
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
fn task_5_1_blocks_are_cut_where_the_lab_says_and_owners_have_their_rows() {
    within("5.1", 20, || questions::cuts(&mut Random::new(51), &mut right));
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
        messages::gathers(world, &mut Random::new(54), &mut right);
    });
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
fn task_5_5_every_rank_gets_what_it_owns_and_what_it_sees() {
    questions::parcels(&mut Random::new(55), &mut right);
}

#[test]
fn task_5_6_every_rank_gets_what_is_its_own() {
    on_each("5.6", &[1, 2, 3, 5], |world| {
        messages::scatters(world, &mut Random::new(56), &mut right);
    });
}

#[test]
fn task_5_7_old_ghosts_go_and_new_ones_come() {
    questions::ghosts(&mut Random::new(57), &mut right);
}

#[test]
fn task_5_8_all_ranks_get_the_scene() {
    on_each("5.8", &[1, 3], |world| {
        messages::broadcasts(world, &mut Random::new(58), &mut right);
    });
}

#[test]
fn task_5_8_only_what_others_need_travels() {
    on_each("5.8", &[1, 3, 4], |world| messages::quiet_steps(world, &mut right));
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
    (1..=5).for_each(|ranks| on_ranks(ranks).bits_of_all_pairs(&scenes::dense(), 20));
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
    (1..=4).for_each(|ranks| on_ranks(ranks).official_bytes());
}

#[test]
fn task_5_8_a_killed_rank_ends_the_job() {
    on_ranks(3).ends_when_a_rank_is_killed();
}

#[test]
fn task_5_9_statistics_of_all_ranks() {
    sums_on(&[1, 3, 5]);
}

fn sums_on(counts: &[usize]) {
    on_each("5.9", counts, |world| {
        messages::sums(world, &mut Random::new(59), &mut right);
    });
}

#[test]
fn task_5_9_statistics_of_a_dense_box() {
    sums_on(&[2]);
    let averages = |ranks: usize| {
        OnRanks::new("5.9", PROGRAM, "through-root", ranks).averages(&scenes::dense(), 20)
    };
    let one = averages(1);
    for ranks in [2, 4] {
        assert_eq!(averages(ranks), one, "statistics of {ranks} ranks");
    }
}
