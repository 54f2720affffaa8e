//! What tests and probe ask alike, with drawn inputs and what a plain model says: `ask` gets a question, what the
//! lab answers and what is right.

use std::cell::Cell;

use common::soft::Particle;
use common_mpi::Wire;
use lab6::{Cuts, balanced, interior_rows, keep_share, sort_leavers};
use solution2::Grid;

use super::ask::{Ask, truth, whole};
use super::on_edges;
use crate::Random;

/// Where blocks start in rows of few particles, and of more than 32 bits count; the sum fits into 64.
pub(super) fn balance(random: &mut Random, ask: Ask<'_>) {
    for case in 0..150 {
        let most = if case % 15 == 14 { 4097 } else { 40 };
        let (rows, ranks) = (1 + random.size(most), 1 + random.size(most));
        // All of them together still fit into 64 bits.
        let few = 2 + rows.ilog2() as usize + random.below(50);
        let gap = random.below(4);
        let count = |_| if random.below(4) < gap { 0 } else { random.bits() >> few };
        let counts: Vec<u64> = (0..rows).map(count).collect();
        let expected = starts(&counts, ranks);
        let shown = &counts[..rows.min(40)];
        let question =
            format!("where blocks start on {ranks} ranks, {rows} rows of {shown:?} particles");
        ask(&question, whole(balanced(&counts, ranks).starts), whole(expected));
    }
}

/// Where blocks start.
fn starts(counts: &[u64], ranks: usize) -> Vec<usize> {
    let all: u128 = counts.iter().map(|count| u128::from(*count)).sum();
    let (mut starts, mut before, mut row) = (vec![0], 0, 0);
    for rank in 1..ranks {
        while before < rank as u128 * all / ranks as u128 {
            before += u128::from(counts[row]);
            row += 1;
        }
        starts.push(row);
    }
    starts.push(counts.len());
    starts
}

/// What a rank keeps of a scene that is replayed, and how often: many particles in few rows, and few in many.
pub(super) fn shares(random: &mut Random, ask: Ask<'_>) {
    for n in [random.sizes(1025), vec![70_000, 1]].concat() {
        let most = [5, 300][random.below(2)];
        let (rows, ranks) = (1 + random.size(most), 1 + random.size(9));
        let grid = Grid::with_bins_along(random.magnitude(1e-6, 1e6), rows);
        let particles = on_edges(random, n, grid.size(), rows);
        let mut counts = vec![0; rows];
        particles.iter().for_each(|p| counts[grid.row(p.y)] += 1);
        // Where rows are cut is another task.
        let starts = balanced(&counts, ranks).starts;
        for rank in [0, random.below(ranks), ranks - 1] {
            let replays = Cell::new(0);
            let replay = |visit: &mut dyn FnMut(Particle)| {
                replays.set(replays.get() + 1);
                particles.iter().for_each(|p| visit(*p));
            };
            let (cuts, share) = keep_share(&grid, ranks, rank, &replay);
            let name = format!("rank {rank} of {ranks}, {n} particles in {rows} rows");
            ask(&format!("{name}: where blocks start"), whole(cuts.starts), whole(starts.clone()));
            let own = starts[rank]..starts[rank + 1];
            let own = particles.iter().filter(|p| own.contains(&grid.row(p.y)));
            let mut kept: Vec<usize> = share.iter().map(|p| p.id as usize).collect();
            kept.sort_unstable();
            let own = whole(own.map(|p| p.id as usize));
            ask(&format!("{name}: the particles that it keeps"), whole(kept), own);
            // Who replays once has kept all until it knew which are its own.
            let question = format!("{name}: how often it has replayed the scene");
            ask(&question, whole([replays.get()]), whole([2]));
        }
    }
}

/// Blocks of rows for `ranks` ranks, many of them empty.
pub(super) fn some_cuts(random: &mut Random, ranks: usize, rows: usize) -> Cuts {
    let mut starts: Vec<usize> = (1..ranks).map(|_| random.below(rows + 1)).collect();
    starts.extend([0, rows]);
    starts.sort_unstable();
    Cuts { starts }
}

/// The rank that has a row: of all blocks the one that is not empty and holds it.
fn owner(cuts: &Cuts, row: usize) -> usize {
    (0..cuts.starts.len() - 1).find(|rank| cuts.block(*rank).contains(&row)).unwrap_or(0)
}

/// The ranks before and after one.
fn beside(cuts: &Cuts, rank: usize) -> [Option<usize>; 2] {
    let (block, rows) = (cuts.block(rank), cuts.starts[cuts.starts.len() - 1]);
    if block.is_empty() {
        return [None, None];
    }
    let after = (block.end < rows).then(|| owner(cuts, block.end));
    [block.start.checked_sub(1).map(|row| owner(cuts, row)), after]
}

/// The rank before and the rank after one, where there are such.
pub(super) fn neighbours(random: &mut Random, ask: Ask<'_>) {
    for case in 0..200 {
        let most = if case % 10 == 9 { 70_000 } else { 10 };
        let (rows, ranks) =
            (1 + random.size(most), 1 + random.size(if most > 10 { 300 } else { 7 }));
        let cuts = some_cuts(random, ranks, rows);
        // The last ranks, too, whatever their number is.
        for rank in (0..ranks).rev().take(8) {
            let shown = &cuts.starts[ranks.saturating_sub(8)..];
            let question =
                format!("before and after rank {rank} of {ranks}, the last starts {shown:?}");
            // A number for none, so that all are alike.
            let told =
                |around: [Option<usize>; 2]| whole(around.map(|other| other.unwrap_or(usize::MAX)));
            ask(&question, told(lab6::neighbours(&cuts, rank)), told(beside(&cuts, rank)));
        }
    }
}

/// Any block of few rows: which of its rows have all their neighbours at home.
pub(super) fn interiors(ask: Ask<'_>) {
    for rows in 1..9 {
        for (start, end) in (0..=rows).flat_map(|start| (start..=rows).map(move |end| (start, end)))
        {
            let interior = interior_rows(&(start..end), rows);
            let home = |row: &usize| {
                let is_near = |other: usize| other >= rows || (start..end).contains(&other);
                is_near(*row) && is_near(row + 1) && row.checked_sub(1).is_none_or(is_near)
            };
            let name = format!("rows {start}..{end} of {rows}");
            let within =
                start <= interior.start && interior.start <= interior.end && interior.end <= end;
            ask(
                &format!("{name}: the interior"),
                whole(interior),
                whole((start..end).filter(home)),
            );
            let question = format!("{name}: does the interior lie within (1)?");
            ask(&question, vec![truth(within)], vec![1.0]);
        }
    }
}

/// Particles to the neighbours, and further.
pub(super) fn leavers(random: &mut Random, ask: Ask<'_>) {
    for case in 0..150 {
        let (rows, ranks) = (1 + random.size(300), 2 + random.size(600));
        let cuts = some_cuts(random, ranks, rows);
        let grid = Grid::with_bins_along(random.between(0.1, 9.0), rows);
        let rank = random.below(ranks);
        // Which ranks are neighbours is another task.
        let around = beside(&cuts, rank);
        let shift = random.below(40);
        let leavers: Vec<Wire> = on_edges(random, 60, grid.size(), rows)
            .iter()
            .filter(|p| !cuts.block(rank).contains(&grid.row(p.y)))
            .map(|p| Wire { id: u64::from(p.id) << shift, ..Wire::from(p) })
            .collect();
        let found = sort_leavers(&grid, &cuts, around, &leavers);
        let (mut near, mut far) = ([const { Vec::new() }; 2], Vec::new());
        for wire in &leavers {
            let to = owner(&cuts, grid.row(wire.y));
            match around.iter().position(|other| *other == Some(to)) {
                Some(side) => near[side].push(wire.id as usize),
                None => far.extend([wire.id as usize, to]),
            }
        }
        let name = format!("case {case}, leavers of rank {rank} of {ranks}, {rows} rows");
        for ((side, found), near) in ["before", "after"].into_iter().zip(&found.near).zip(near) {
            let ids = whole(found.iter().map(|wire| wire.id as usize));
            ask(&format!("{name}: to the neighbour {side}, as they come"), ids, whole(near));
        }
        let found_far = whole(found.far.iter().flat_map(|(to, wire)| [wire.id as usize, *to]));
        ask(&format!("{name}: further, particle and rank in turn"), found_far, whole(far));
        let all: Vec<&Wire> =
            found.near.iter().flatten().chain(found.far.iter().map(|(_, wire)| wire)).collect();
        let changed =
            all.iter().filter(|wire| !leavers.contains(wire)).map(|wire| wire.id as usize);
        ask(&format!("{name}: those that are not as they left"), whole(changed), vec![]);
    }
}
