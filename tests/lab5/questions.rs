//! Questions about functions that need no other rank, with random inputs, and the answers of a
//! plain model.

use std::ops::Range;

use common::soft::Particle;
use common_mpi::Wire;
use lab5::{Cut, Parcel, border_copies, replace_ghosts, sort_by_receiver, take_leavers_of_block};
use oracle::{Ask, Random, integers, within};
use solution2::VecBins;

use super::blocks::{Blocks, blocks_of, owners_of, same, wires};

/// Asks for all cuts of few rows among few ranks.
pub(crate) fn few_rows(_: &mut Random, ask: &mut impl Ask) {
    const MOST: usize = 30;
    for (rows, ranks) in (1..=MOST).flat_map(|rows| (1..=MOST).map(move |ranks| (rows, ranks))) {
        let (cut, name) = (Cut { rows, ranks }, format!("{rows} rows on {ranks} ranks"));
        let ends = |block: Range<usize>| [block.start, block.end];
        ask.exact(
            &format!("{name}: start and end of each block"),
            || integers((0..ranks).flat_map(|rank| ends(cut.block(rank)))),
            || integers(blocks_of(cut).into_iter().flat_map(ends)),
        );
        ask.exact(
            &format!("{name}: rank that owns each row"),
            || integers((0..rows).map(|row| cut.owner(row))),
            || integers(owners_of(&blocks_of(cut))),
        );
    }
}

/// Asks for cuts of many rows among many ranks: huge numbers of rows, and so many ranks that a
/// linear search does not finish.
pub(crate) fn many_rows(random: &mut Random, ask: &mut impl Ask) {
    for case in 0..60 {
        let most = [(70_000, 70_000), (1 << 40, 300), (1 << 20, 1 << 40), (3, 1 << 50)][case % 4];
        let cut = Cut { rows: 1 + random.size(most.0), ranks: 1 + random.size(most.1) };
        let Cut { rows, ranks } = cut;
        let name = format!("{rows} rows on {ranks} ranks");
        for rank in [0, ranks - 1, random.below(ranks), random.below(ranks)] {
            let block = || cut.block(rank);
            let question = format!("{name}: start and end of the block of rank {rank}");
            let found = || integers([block().start, block().end]);
            ask.judge(&question, found, |found| {
                begins_there("the block starts", found.first(), rank, cut)?;
                begins_there("the block ends", found.get(1), rank + 1, cut)
            });
        }
        for row in [0, rows - 1, random.below(rows), random.below(rows)] {
            let question = format!("{name}: rank that owns row {row}");
            // A search through the ranks would take hours.
            let found = || integers([within("5.1", 20, move || cut.owner(row))]);
            ask.judge(&question, found, |found| owns(found, row, cut));
        }
    }
}

/// Checks that the blocks of the ranks below `rank` have the correct number of rows: rank / ranks
/// of all rows, rounded down.
fn begins_there(what: &str, found: Option<&f64>, rank: usize, cut: Cut) -> Result<(), String> {
    let found = found.copied().unwrap_or(-1.0);
    let part = rank as u128 * cut.rows as u128;
    let rounded_down = found >= 0.0 && {
        let row = found as u128;
        (row * cut.ranks as u128..(row + 1) * cut.ranks as u128).contains(&(part))
    };
    let exact = part as f64 / cut.ranks as f64;
    if rounded_down {
        Ok(())
    } else {
        Err(format!("{what} at row {found}, but must be at row {exact}, rounded down"))
    }
}

/// Checks that a rank's block contains the row: the block begins at the row or before it, and the
/// next block begins after it.
fn owns(found: &[f64], row: usize, cut: Cut) -> Result<(), String> {
    let &[rank] = found else { return Err("the answer has no rank".into()) };
    let behind = (row as u128 + 1) * cut.ranks as u128;
    let begins = rank as u128 * cut.rows as u128;
    if rank >= 0.0 && begins < behind && begins + cut.rows as u128 >= behind {
        return Ok(());
    }
    let exact = [rank, rank + 1.0].map(|rank| rank * cut.rows as f64 / cut.ranks as f64);
    Err(format!(
        "the answer is rank {rank}, but this rank owns the rows from {} up to {}, both rounded down",
        exact[0], exact[1]
    ))
}

/// Asks for the particles that have stayed in a block, and for the particles that have left it.
pub(crate) fn leavers(random: &mut Random, ask: &mut impl Ask) {
    for case in 0..100 {
        let blocks = Blocks::drawn(random);
        let rows = blocks.cut.rows;
        let start = random.below(rows + 1);
        let block = match case % 5 {
            // An empty block may begin anywhere.
            0 => [0..0, rows..rows, start..start][case / 5 % 3].clone(),
            _ => start..start + random.below(rows - start + 1),
        };
        // Sometimes there are more particles than 16 bits can count.
        let particles = blocks.particles(random, if case % 25 == 24 { 70_000 } else { 300 });
        // The remote particles from before must remain.
        let before = Particle { id: u32::MAX, ..Particle::default() };
        let (mut changed, mut remote) = (particles.clone(), vec![before]);
        take_leavers_of_block(&blocks.grid, &block, &mut changed, &mut remote);
        let is_local = |p: &&Particle| block.contains(&blocks.row(p.y));
        let name = format!("case {case}, rows {block:?} of {rows}");
        let right = || wires(particles.iter().filter(is_local));
        same(&blocks.grid, &format!("{name}, local particles"), wires(&changed), right, ask);
        let right = || wires(particles.iter().filter(|p| !is_local(p)).chain([&before]));
        let name =
            format!("{name}, remote particles, which follow particle {} in the list", before.id);
        same(&blocks.grid, &name, wires(&remote), right, ask);
    }
}

/// Asks for the copies that a rank makes for its neighbours.
pub(crate) fn copies(random: &mut Random, ask: &mut impl Ask) {
    for case in 0..60 {
        let blocks = if case % 4 == 1 { Blocks::thin(random) } else { Blocks::drawn(random) };
        // Every second case has a rank with rows. If there are more ranks than rows, the rank has a
        // single row.
        let rank = match case % 2 {
            1 => blocks.owner(random.below(blocks.cut.rows)),
            _ => random.below(blocks.cut.ranks),
        };
        let mut block = blocks.block(rank);
        // Sometimes the block has no rows.
        if case % 10 == 9 {
            block.end = block.start;
        }
        // Sometimes a bin contains hundreds of particles.
        let particles = blocks.particles(random, if case % 10 == 4 { 4097 } else { 300 });
        let mut bins = VecBins::new(blocks.grid);
        let seen = blocks.visible(&block);
        particles.iter().filter(|p| seen.contains(&blocks.row(p.y))).for_each(|p| bins.put(*p));
        let copies = border_copies(&bins, &blocks.cut, &block);
        let border = |row: usize| block.contains(&row) && blocks.is_seen(row, &block);
        let right = || wires(particles.iter().filter(|p| border(blocks.row(p.y))));
        let name = format!("{}, rows {block:?}, copies", blocks.name(case));
        same(&blocks.grid, &name, copies, right, ask);
    }
}

/// Asks which rank receives which particles.
pub(crate) fn parcels(random: &mut Random, ask: &mut impl Ask) {
    for case in 0..60 {
        let blocks = if case % 4 == 1 { Blocks::thin(random) } else { Blocks::drawn(random) };
        let ranks = blocks.cut.ranks;
        let mut parcels = vec![Parcel::default(); ranks];
        for p in blocks.particles(random, 300) {
            let owner = blocks.owner(blocks.row(p.y));
            // Sometimes numbers exceed 32 bits.
            let far = if case % 4 == 2 { random.below(1 << 20) as u64 } else { 0 };
            let wire = Wire { id: u64::from(p.id) + (far << 32), ..Wire::from(&p) };
            match random.below(3) {
                0 if ranks > 1 => {
                    parcels[(owner + 1 + random.below(ranks - 1)) % ranks].leavers.push(wire);
                }
                1 if !blocks.neighbours(blocks.row(p.y)).is_empty() => {
                    parcels[owner].copies.push(wire)
                }
                _ => {}
            }
        }
        let lists = sort_by_receiver(&blocks.grid, &blocks.cut, &parcels);
        let question = format!("{}: number of lists", blocks.name(case));
        ask.exact(&question, || integers([lists.len()]), || integers([ranks]));
        for rank in 0..ranks {
            let list = lists.get(rank).cloned().unwrap_or_default();
            let name = format!("{}, list for rank {rank}", blocks.name(case));
            same(&blocks.grid, &name, list, || receives(&blocks, &parcels, rank), ask);
        }
    }
}

/// Returns the part of these parcels that a rank receives: leavers into its rows, and all particles
/// of the neighbouring rows.
fn receives(blocks: &Blocks, parcels: &[Parcel], rank: usize) -> Vec<Wire> {
    let sees = |wire: &&Wire| blocks.neighbours(blocks.row(wire.y)).contains(&rank);
    let owns = |wire: &&Wire| blocks.owner(blocks.row(wire.y)) == rank;
    let leavers = parcels.iter().flat_map(|parcel| &parcel.leavers);
    let leavers = leavers.filter(|wire| owns(wire) || sees(wire));
    leavers.chain(parcels.iter().flat_map(|parcel| &parcel.copies).filter(sees)).copied().collect()
}

/// Asks for the particles in the rows that a rank sees, after new ghosts and new particles have
/// arrived.
pub(crate) fn ghosts(random: &mut Random, ask: &mut impl Ask) {
    for case in 0..60 {
        let thin = Blocks::single_rows(random);
        let last = thin.cut.ranks - 1;
        let (blocks, rank) = match case % 5 {
            1 => (thin, 1),
            2 => (thin, last - 1),
            _ => (Blocks::drawn(random), random.below(1 << 20)),
        };
        let block = blocks.block(rank % blocks.cut.ranks);
        let seen = blocks.visible(&block);
        let visible = |p: &Particle| seen.contains(&blocks.row(p.y));
        let mut bins = VecBins::new(blocks.grid);
        let before: Vec<_> = blocks.particles(random, 300).into_iter().filter(visible).collect();
        before.iter().for_each(|p| bins.put(*p));
        let new = |p: Particle| Particle { id: p.id + 1000, ..p };
        // Sometimes nothing arrives; old ghosts must go nevertheless.
        let most = if case % 5 == 0 { 0 } else { 300 };
        let arrived: Vec<_> =
            blocks.particles(random, most).into_iter().filter(visible).map(new).collect();
        replace_ghosts(&mut bins, &block, &wires(&arrived));
        let right = || {
            let stay = before.iter().filter(|p| block.contains(&blocks.row(p.y)));
            wires(stay.chain(&arrived))
        };
        let name = format!("{}, rows {block:?}, arrivals with ids from 1000 on", blocks.name(case));
        let question = format!("{name}, particles in the bins");
        same(&blocks.grid, &question, wires(bins.particles()), right, ask);
        let astray = || {
            let all = bins.bins().iter().enumerate();
            integers(all.flat_map(|(bin, inside)| {
                inside.iter().filter(move |p| blocks.grid.bin(p) != bin).map(|p| p.id as usize)
            }))
        };
        ask.exact(
            &format!("{name}: ids of the particles that are in a wrong bin"),
            astray,
            Vec::new,
        );
    }
}
