//! The worked examples of single tasks: a few rows, three ranks, a dozen particles.

use std::cell::Cell;

use common::soft::Particle;
use common_mpi::{Wire, calls_made};
use lab6::{
    Cuts, balanced, exchange_all, exchange_beside, interior_rows, keep_share, neighbours,
    sort_leavers,
};
use mpi::topology::SimpleCommunicator;
use oracle::{Ask, Random, Table, ascending, begins_send, spaced};
use oracle_mpi::on_each;
use solution2::Grid;

fn cuts(starts: &[usize]) -> Cuts {
    Cuts { starts: starts.to_vec() }
}

/// Lists the blocks of all ranks.
fn blocks(cuts: &Cuts) -> String {
    spaced((1..cuts.starts.len()).map(|end| format!("{:?}", cuts.block(end - 1))))
}

fn ids<'a>(wires: impl IntoIterator<Item = &'a Wire>) -> String {
    spaced(wires.into_iter().map(|wire| wire.id))
}

pub(crate) fn table_of_blocks(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let mut table = Table::new(["particles in each row", "ranks", "blocks", "particles"]);
        for (counts, ranks) in [
            (vec![2, 2, 2, 2, 2, 2], 3),
            (vec![7, 3, 1, 1, 0, 0], 3),
            (vec![0, 0, 12, 0, 0, 0], 3),
            (vec![5, 4, 3, 2, 1, 0, 0, 0, 0, 1], 4),
            (vec![2, 2, 2, 1, 1], 3),
        ] {
            let cuts = balanced(&counts, ranks);
            let held = |rank: usize| counts[cuts.block(rank)].iter().sum::<u64>();
            table.row([&spaced(&counts), &ranks, &blocks(&cuts), &spaced((0..ranks).map(held))]);
        }
        table.to_string()
    });
}

pub(crate) fn table_of_neighbours(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let mut table = Table::new(["blocks", "rank", "block", "rank before", "rank after"]);
        for starts in [&[0, 2, 4, 6][..], &[0, 3, 3, 6]] {
            let cuts = cuts(starts);
            for rank in 0..3 {
                let beside = neighbours(&cuts, rank);
                let [before, after] =
                    beside.map(|rank| rank.map_or("none".into(), |rank| rank.to_string()));
                table.row([
                    &blocks(&cuts),
                    &rank,
                    &format!("{:?}", cuts.block(rank)),
                    &before,
                    &after,
                ]);
            }
        }
        table.to_string()
    });
}

/// Shows lists in both directions. Rank 1 has lists for both other ranks, and names the higher rank
/// first.
pub(crate) fn both_ways(random: &mut Random, ask: &mut impl Ask) {
    on_each(ask, "6.3", &[3], random, |rank, _, ask| {
        let outgoing =
            [vec![(1, vec![2, 3])], vec![(2, vec![7]), (0, vec![4, 5, 6])], vec![(1, vec![8, 9])]];
        let own = &outgoing[rank.number];
        let rows = rank.call("exchange_beside", |world| exchange(world, own));
        let table = rank.columns(&rows);
        if rank.is_root() {
            ask.example(|| table);
        }
    });
}

/// Returns the rows of a rank's column.
fn exchange(
    world: &SimpleCommunicator,
    outgoing: &[(i32, Vec<u32>)],
) -> Vec<(&'static str, String)> {
    let mut calls = Vec::new();
    let (incoming, result) = exchange_beside(world, outgoing, || {
        calls.push(calls_made());
        "done"
    });
    let before = calls.first().map_or(&[][..], |calls| calls);
    let sent: Vec<Vec<u32>> = outgoing.iter().map(|(_, list)| list.clone()).collect();
    vec![
        ("to rank: list", by_rank(outgoing, &sent)),
        ("work is called", format!("{} time", calls.len())),
        ("  then receives under way", begun(before, |call| call == "MPI_Irecv")),
        ("  and sends under way", begun(before, begins_send)),
        ("work returns", result.into()),
        ("from rank: list", by_rank(outgoing, &incoming)),
    ]
}

/// Counts the calls that `is_one` accepts, after the last call that does not begin a message.
fn begun(calls: &[&str], is_one: fn(&str) -> bool) -> String {
    let last = calls.iter().rev().take_while(|call| call.starts_with("MPI_I"));
    last.filter(|call| is_one(call)).count().to_string()
}

/// Lists the lists with the ranks of `outgoing`.
fn by_rank(outgoing: &[(i32, Vec<u32>)], lists: &[Vec<u32>]) -> String {
    let all = lists.iter().zip(outgoing);
    all.map(|(list, (rank, _))| format!("{rank}: {}", spaced(list))).collect::<Vec<_>>().join("|")
}

pub(crate) fn from_all_to_all(random: &mut Random, ask: &mut impl Ask) {
    on_each(ask, "6.4", &[3], random, |rank, _, ask| {
        let lists: [[&[u32]; 3]; 3] =
            [[&[], &[2, 3], &[]], [&[4], &[5], &[6, 7]], [&[11], &[], &[]]];
        let own = lists[rank.number].map(<[u32]>::to_vec);
        let got = rank.call("exchange_all", |world| exchange_all(world, &own));
        let sent = own.iter().map(spaced).collect::<Vec<_>>().join("|");
        let table = rank.columns(&[("sends", sent), ("gets", spaced(got))]);
        if rank.is_root() {
            ask.example(|| table);
        }
    });
}

pub(crate) fn table_of_interiors(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let mut table = Table::new(["rows of the box", "block", "interior rows", ""]);
        for (block, what) in [
            (0..2, "row 0 is at a wall, row 1 is beside another block"),
            (2..4, "both rows are beside another block"),
            (1..5, "rows 1 and 4 are beside another block"),
            (4..6, "row 5 is at a wall, row 4 is beside another block"),
            (0..6, "one rank has all rows"),
            (3..4, "a single row"),
            (3..3, "a block without rows"),
        ] {
            let interior = spaced(interior_rows(&block, 6));
            table.row([&6, &format!("{block:?}"), &interior, &what]);
        }
        table.to_string()
    });
}

/// Shows the leavers on five ranks. Rank 2 has no rows.
pub(crate) fn table_of_leavers(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let grid = Grid::with_bins_along(8.0, 8);
        let cuts = cuts(&[0, 2, 4, 4, 6, 8]);
        let mut table = Table::new([
            "rank",
            "block",
            "left it, id:row",
            "to the rank before",
            "to the rank after",
            "further, id:rank",
        ]);
        for (rank, neighbours, left) in [
            (0, [None, Some(1)], vec![(1, 2), (2, 7), (3, 3)]),
            (1, [Some(0), Some(3)], vec![(4, 4), (5, 1), (6, 7), (7, 0), (8, 5)]),
            (4, [Some(3), None], vec![(12, 5), (13, 3), (14, 0)]),
        ] {
            let leaver =
                |&(id, row): &(u64, u32)| Wire { id, y: f64::from(row) + 0.5, ..Wire::default() };
            let leavers: Vec<Wire> = left.iter().map(leaver).collect();
            let sorted = sort_leavers(&grid, &cuts, neighbours, &leavers);
            let [before, after] = sorted.near.map(|list| ids(&list));
            let left = spaced(left.iter().map(|(id, row)| format!("{id}:{row}")));
            let far = spaced(sorted.far.iter().map(|(to, wire)| format!("{}:{to}", wire.id)));
            table.row([&rank, &format!("{:?}", cuts.block(rank)), &left, &before, &after, &far]);
        }
        table.to_string()
    });
}

/// Rows of the particles, by their ids.
const ROWS: [u32; 12] = [5, 0, 0, 2, 1, 0, 3, 0, 2, 4, 0, 1];

pub(crate) fn table_of_shares(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let headings =
            ["rank", "row of particles 0 to 11", "scene replayed", "block", "particles kept"];
        let mut table = Table::new(headings);
        for rank in 0..3 {
            let replays = Cell::new(0);
            let replay = |visit: &mut dyn FnMut(Particle)| {
                replays.set(replays.get() + 1);
                in_rows().for_each(visit);
            };
            let (cuts, share) = keep_share(&Grid::with_bins_along(6.0, 6), 3, rank, &replay);
            let times = format!("{} times", replays.get());
            let kept = ascending(share.iter().map(|p| p.id));
            table.row([&rank, &spaced(ROWS), &times, &format!("{:?}", cuts.block(rank)), &kept]);
        }
        table.to_string()
    });
}

/// Returns a particle in the middle of each of these rows.
fn in_rows() -> impl Iterator<Item = Particle> {
    let rows = (0..).zip(ROWS);
    rows.map(|(id, row)| Particle { id, y: f64::from(row) + 0.5, ..Particle::default() })
}
