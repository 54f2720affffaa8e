//! The worked examples: a dozen particles on three ranks, each with two of six rows of bins.

use std::ops::Range;

use common::soft::{Averages, Particle, Scene, Statistics};
use common_mpi::{Wire, displacements};
use lab5::{
    Cut, Parcel, border_copies, broadcast, gather_at_root, reduce, replace_ghosts,
    scatter_from_root, sort_by_receiver, take_leavers_of_block,
};
use mpi::Count;
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;
use oracle::{Ask, Random, Table, ascending, scenes, spaced};
use oracle_mpi::on_each;
use solution2::{Grid, VecBins, take_leavers};

use super::blocks::blocks_of;

/// Six rows on three ranks.
const CUT: Cut = Cut { rows: 6, ranks: 3 };

fn grid() -> Grid {
    Grid::with_bins_along(6.0, 6)
}

fn ids<'a>(wires: impl IntoIterator<Item = &'a Wire>) -> String {
    ascending(wires.into_iter().map(|wire| wire.id))
}

fn ids_of(particles: &[Particle]) -> String {
    ascending(particles.iter().map(|particle| particle.id))
}

/// Returns the wires of these particles.
fn wires(particles: &[Particle], ids: &[usize]) -> Vec<Wire> {
    ids.iter().map(|&id| Wire::from(&particles[id])).collect()
}

/// Returns the bins of a rank that owns `block`: its rows, and one more row on either side.
fn bins_of(particles: &[Particle], block: &Range<usize>) -> VecBins {
    let visible = block.start.saturating_sub(1)..(block.end + 1).min(6);
    let mut bins = VecBins::new(grid());
    particles.iter().filter(|p| visible.contains(&grid().row(p.y))).for_each(|p| bins.put(*p));
    bins
}

/// Lists the ids in each nonempty row of bins, with ghosts in parentheses.
fn content(bins: &VecBins, block: &Range<usize>) -> String {
    let row = |row: usize| {
        let inside = bins.bins()[row * 6..(row + 1) * 6].iter().flatten();
        let ids = ascending(inside.map(|particle| particle.id));
        if block.contains(&row) { ids } else { format!("({ids})") }
    };
    let visible = block.start.saturating_sub(1)..(block.end + 1).min(6);
    visible.map(row).collect::<Vec<_>>().join("|")
}

pub(crate) fn rows_and_owners(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let mut table = Table::new(["rows", "ranks", "rank of each row", "block of each rank"]);
        for (rows, ranks) in [(6, 3), (10, 4), (7, 3), (3, 4), (2, 5)] {
            let cut = Cut { rows, ranks };
            let owners = spaced((0..rows).map(|row| cut.owner(row)));
            let blocks = spaced((0..ranks).map(|rank| format!("{:?}", cut.block(rank))));
            table.row([&rows, &ranks, &owners, &blocks]);
        }
        table.to_string()
    });
}

pub(crate) fn local_and_remote(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let [_, after] = scenes::dozen();
        let mut table = Table::new(["rank", "rows", "left their bins", "local", "remote"]);
        for (rank, changed) in [vec![1, 3], vec![5], vec![8, 11]].into_iter().enumerate() {
            let block = blocks_of(CUT)[rank].clone();
            let mut local: Vec<Particle> = changed.iter().map(|&id: &usize| after[id]).collect();
            let left = ids_of(&local);
            let mut remote = Vec::new();
            take_leavers_of_block(&grid(), &block, &mut local, &mut remote);
            table.row([&rank, &format!("{block:?}"), &left, &ids_of(&local), &ids_of(&remote)]);
        }
        table.to_string()
    });
}

pub(crate) fn copies_of_border_rows(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let [before, _] = scenes::dozen();
        let mut table = Table::new(["rank", "particles in its rows, ghosts in ()", "copies"]);
        for rank in 0..3 {
            let block = blocks_of(CUT)[rank].clone();
            let bins = bins_of(&before, &block);
            table.row([&rank, &content(&bins, &block), &ids(&border_copies(&bins, &CUT, &block))]);
        }
        table.to_string()
    });
}

pub(crate) fn gathered(random: &mut Random, ask: &mut impl Ask) {
    on_each(ask, "5.4", &[3], random, |rank, _, ask| {
        let [before, _] = scenes::dozen();
        let own = wires(&before, [&[1, 2][..], &[], &[9, 10, 11]][rank.number]);
        let lists = rank.call("gather_at_root", |world| gather_at_root(world, &own));
        let rows = [("sends", spaced(own.iter().map(|wire| wire.id))), ("gets", lists_of(&lists))];
        let table = rank.columns(&rows);
        if rank.is_root() {
            ask.example(|| table);
        }
    });
}

pub(crate) fn scattered(random: &mut Random, ask: &mut impl Ask) {
    on_each(ask, "5.6", &[3], random, |rank, _, ask| {
        let [before, _] = scenes::dozen();
        let lists = [&[4, 5][..], &[3], &[]].map(|ids| wires(&before, ids));
        let own = if rank.is_root() { &lists[..] } else { &[] };
        let list = rank.call("scatter_from_root", |world| scatter_from_root(world, own));
        let rows = [("sends", lists_of(own)), ("gets", spaced(list.iter().map(|wire| wire.id)))];
        let table = rank.columns(&rows);
        if rank.is_root() {
            ask.example(|| table);
        }
    });
}

/// Shows lists with a bar between them; empty if there is no list.
fn lists_of(lists: &[Vec<Wire>]) -> String {
    lists.iter().map(ids).collect::<Vec<_>>().join("|")
}

/// Shows the lists that the root receives from the two gathers, and the parcels that it makes of
/// them.
pub(crate) fn receivers(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let [_, after] = scenes::dozen();
        let parcel = |leavers: &[usize], copies: &[usize]| Parcel {
            leavers: wires(&after, leavers),
            copies: wires(&after, copies),
        };
        let parcels = [parcel(&[3], &[1, 2]), parcel(&[], &[4, 5, 6, 7]), parcel(&[8, 11], &[9])];
        let lists = sort_by_receiver(&grid(), &CUT, &parcels);
        let mut table = Table::new(["rank", "leavers", "copies", "its list"]);
        for (rank, (parcel, list)) in parcels.iter().zip(&lists).enumerate() {
            table.row([&rank, &ids(&parcel.leavers), &ids(&parcel.copies), &ids(list)]);
        }
        table.to_string()
    });
}

pub(crate) fn new_ghosts(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let [before, after] = scenes::dozen();
        let mut table =
            Table::new(["rank", "before, ghosts in ()", "arrive", "after, ghosts in ()"]);
        let arrivals = [&[3, 4, 5, 11][..], &[1, 2, 3, 8, 9], &[6, 7, 8]];
        for (rank, arrive) in arrivals.into_iter().enumerate() {
            let block = blocks_of(CUT)[rank].clone();
            // The rank's own particles have moved, and the leavers are gone; ghosts are unchanged.
            let is_ghost = |p: &&Particle| !block.contains(&grid().row(p.y));
            let own = |p: &Particle| !is_ghost(&p) && !is_ghost(&&after[p.id as usize]);
            let moved = before.iter().filter(|p| own(p)).map(|p| after[p.id as usize]);
            let state: Vec<Particle> =
                before.iter().filter(is_ghost).copied().chain(moved).collect();
            let mut bins = bins_of(&state, &block);
            let held = content(&bins, &block);
            replace_ghosts(&mut bins, &block, &wires(&after, arrive));
            table.row([&rank, &held, &spaced(arrive), &content(&bins, &block)]);
        }
        table.to_string()
    });
}

/// Shows one exchange of the dozen particles: every buffer before and after each call.
pub(crate) fn one_exchange(random: &mut Random, ask: &mut impl Ask) {
    on_each(ask, "5.8", &[3], random, |rank, _, ask| {
        let rows = rank.call("an exchange", |world| exchange(world, rank.number));
        let table = rank.columns(&rows);
        if rank.is_root() {
            ask.example(|| table);
        }
    });
}

/// Returns the rows of a rank's column.
fn exchange(world: &SimpleCommunicator, rank: usize) -> Vec<(&'static str, String)> {
    let [before, after] = scenes::dozen();
    let scene = Scene::new(6.0, before).expect("the scene is valid");
    let (_, particles) = broadcast(world, (rank == 0).then_some(&scene));
    let mut rows = vec![("scene after Bcast", format!("{} particles", particles.len()))];

    let block = blocks_of(CUT)[rank].clone();
    let mut bins = bins_of(&particles, &block);
    rows.push(("its rows; ghosts in ()", content(&bins, &block)));
    let mut changed = Vec::new();
    for (bin, inside) in bins.bins_mut().iter_mut().enumerate() {
        if block.contains(&(bin / 6)) {
            inside.iter_mut().for_each(|p| *p = after[p.id as usize]);
            take_leavers(&grid(), bin, inside, &mut changed);
        }
    }
    rows.push(("moved; left their bins", ids_of(&changed)));
    let mut remote = Vec::new();
    take_leavers_of_block(&grid(), &block, &mut changed, &mut remote);
    rows.push(("  local", ids_of(&changed)));
    rows.push(("  remote", ids_of(&remote)));
    changed.into_iter().for_each(|p| bins.put(p));
    rows.push(("local ones are back", content(&bins, &block)));

    let copies = border_copies(&bins, &CUT, &block);
    rows.push(("copies", ids(&copies)));
    let leavers: Vec<Wire> = remote.iter().map(Wire::from).collect();
    let all_leavers = gather_rows(world, "leavers: Gather counts", &leavers, &mut rows);
    let all_copies = gather_rows(world, "copies: Gather counts", &copies, &mut rows);
    let arrived = scatter_rows(world, all_leavers, all_copies, &mut rows);
    // These bins keep the old ghosts, because arrivals are only added.
    let mut stale = VecBins::new(grid());
    let arrivals: Vec<Particle> = arrived.iter().map(Particle::from).collect();
    bins.particles().chain(&arrivals).for_each(|p| stale.put(*p));
    replace_ghosts(&mut bins, &block, &arrived);
    rows.push(("its rows; ghosts in ()", content(&bins, &block)));
    rows.push(("  had old ones stayed", content(&stale, &block)));
    rows
}

/// Gathers a list of each rank, and adds the root's result to the rows.
fn gather_rows(
    world: &SimpleCommunicator,
    what: &'static str,
    own: &[Wire],
    rows: &mut Vec<(&'static str, String)>,
) -> Vec<Vec<Wire>> {
    let lists = gather_at_root(world, own);
    rows.push((what, own.len().to_string()));
    counts_of(world, &lists, rows);
    rows.push(("  buffer after Gatherv", at_root(world, lists_of(&lists))));
    lists
}

/// Sorts all lists by receivers, scatters them, and adds each rank's result to the rows. Returns
/// the list that this rank received.
fn scatter_rows(
    world: &SimpleCommunicator,
    leavers: Vec<Vec<Wire>>,
    copies: Vec<Vec<Wire>>,
    rows: &mut Vec<(&'static str, String)>,
) -> Vec<Wire> {
    let parcels =
        leavers.into_iter().zip(copies).map(|(leavers, copies)| Parcel { leavers, copies });
    let parcels: Vec<Parcel> = parcels.collect();
    let is_root = world.rank() == 0;
    let lists = if is_root { sort_by_receiver(&grid(), &CUT, &parcels) } else { Vec::new() };
    rows.push(("buffer to scatter", at_root(world, lists_of(&lists))));
    counts_of(world, &lists, rows);
    let arrived = scatter_from_root(world, &lists);
    rows.push(("after Scatter: a count", arrived.len().to_string()));
    rows.push(("after Scatterv", ids(&arrived)));
    arrived
}

fn counts_of(
    world: &SimpleCommunicator,
    lists: &[Vec<Wire>],
    rows: &mut Vec<(&'static str, String)>,
) {
    let counts: Vec<Count> = lists.iter().map(|list| list.len() as Count).collect();
    rows.push(("  counts", at_root(world, spaced(&counts))));
    rows.push(("  displacements", at_root(world, spaced(displacements(&counts)))));
}

/// Returns a text on the root, and an empty text elsewhere.
fn at_root(world: &SimpleCommunicator, text: String) -> String {
    if world.rank() == 0 { text } else { String::new() }
}

pub(crate) fn reduced(random: &mut Random, ask: &mut impl Ask) {
    on_each(ask, "5.9", &[3], random, |rank, _, ask| {
        let (dmin, davg) = [(0.75, 1.5), (0.5, 2.25), (1.0, 0.0)][rank.number];
        let (navg, pair_tests) = [(2, 40), (4, 50), (0, 30)][rank.number];
        let own = Statistics { dmin, davg, navg, pair_tests };
        let all = rank.call("reduce", |world| reduce(world, &own));
        let rows = [
            ("own dmin, davg, navg, pair tests", numbers(Some(own))),
            ("reduced", numbers(all)),
            ("average distance", all.map_or("-".into(), average)),
        ];
        let table = rank.columns(&rows);
        if rank.is_root() {
            ask.example(|| table);
        }
    });
}

fn numbers(statistics: Option<Statistics>) -> String {
    statistics
        .map_or("none".into(), |s| format!("{} {} {} {}", s.dmin, s.davg, s.navg, s.pair_tests))
}

fn average(all: Statistics) -> String {
    let averages = Averages::of(12, &[all]).expect("the run has a step");
    averages.absavg.to_string()
}
