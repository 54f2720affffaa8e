//! What tests and probe ask alike, with drawn inputs and what a plain model says: `ask` gets a question, what the
//! lab answers and what is right.

use std::ops::Range;

use common::soft::Particle;
use common_mpi::Wire;
use lab5::{Cut, Parcel, border_copies, replace_ghosts, sort_by_receiver, take_leavers_of_block};
use solution2::{Grid, VecBins};

use super::ask::{Ask, whole};
use super::on_edges;
use crate::Random;

/// Few rows and ranks, and many of both: of each cut some blocks, and the owners of some rows.
pub(super) fn cuts(random: &mut Random, ask: Ask<'_>) {
    for case in 0..60 {
        // Many of both, few, and rows without end.
        let most = [70_000, 40, 300][case % 3];
        let rows = if case % 3 == 2 { random.below(1 << 40) } else { random.size(most) };
        let cut = Cut { rows: 1 + rows, ranks: 1 + random.size(most) };
        let Cut { rows, ranks } = cut;
        for rank in [0, ranks - 1, random.below(ranks), random.below(ranks)] {
            let block = cut.block(rank);
            let name =
                format!("{rows} rows on {ranks} ranks: start and end of the block of rank {rank}");
            let expected = [rank, rank + 1].map(|rank| rank * rows / ranks);
            ask(&name, whole([block.start, block.end]), whole(expected));
        }
        for row in [0, rows - 1, random.below(rows), random.below(rows)] {
            let name = format!("{rows} rows on {ranks} ranks: the rank that has row {row}");
            ask(&name, whole([cut.owner(row)]), whole([((row + 1) * ranks - 1) / rows]));
        }
    }
}

/// The blocks of some ranks, all of as many rows, in a grid of any size.
struct Blocks {
    grid: Grid,
    cut: Cut,
}

impl Blocks {
    fn drawn(random: &mut Random) -> Self {
        let ranks = [2, 1 + random.size(256), 1 + random.size(600)][random.below(3)];
        let rows = ranks * (1 + random.below(256 / ranks + 1));
        let grid = Grid::with_bins_along(random.between(0.1, 9.0), rows);
        Self { grid, cut: Cut { rows, ranks } }
    }

    fn particles(&self, random: &mut Random, most: usize) -> Vec<Particle> {
        let n = random.size(most);
        on_edges(random, n, self.grid.size(), self.grid.rows())
    }

    fn row(&self, y: f64) -> usize {
        self.grid.row(y)
    }

    fn block(&self, rank: usize) -> Range<usize> {
        let each = self.cut.rows / self.cut.ranks;
        rank * each..(rank + 1) * each
    }

    fn owner(&self, row: usize) -> usize {
        row / (self.cut.rows / self.cut.ranks)
    }

    /// The other ranks that see a row.
    fn neighbours(&self, row: usize) -> Vec<usize> {
        let rows = [row.checked_sub(1), Some(row + 1).filter(|row| *row < self.cut.rows)];
        let owners = rows.into_iter().flatten().map(|row| self.owner(row));
        owners.filter(|owner| *owner != self.owner(row)).collect()
    }

    /// The rows that a rank sees.
    fn visible(&self, block: &Range<usize>) -> Range<usize> {
        block.start.saturating_sub(1)..(block.end + 1).min(self.cut.rows)
    }

    fn name(&self, case: usize) -> String {
        format!("case {case}, {} rows on {} ranks", self.cut.rows, self.cut.ranks)
    }
}

/// What has stayed in a block, and what has left it.
pub(super) fn leavers(random: &mut Random, ask: Ask<'_>) {
    for case in 0..100 {
        let blocks = Blocks::drawn(random);
        let rows = blocks.cut.rows;
        let start = random.below(rows + 1);
        let block = start..start + random.below(rows - start + 1);
        // Now and then more than sixteen bits count.
        let particles = blocks.particles(random, if case % 25 == 24 { 70_000 } else { 300 });
        // Who was remote before still is.
        let before = Particle { id: u32::MAX, ..Particle::default() };
        let (mut changed, mut remote) = (particles.clone(), vec![before]);
        take_leavers_of_block(&blocks.grid, &block, &mut changed, &mut remote);
        for (list, stay) in [(&changed, true), (&remote, false)] {
            let right = particles.iter().filter(|p| block.contains(&blocks.row(p.y)) == stay);
            let right: Vec<&Particle> = right.chain((!stay).then_some(&before)).collect();
            let name = format!("{}, block {block:?}", blocks.name(case));
            lists(&format!("{name}, {}", if stay { "local" } else { "remote" }), list, &right, ask);
        }
    }
}

/// Asks for the ids of some particles; where they are wrong, of the first that is too much or too little.
fn lists(name: &str, found: &[Particle], right: &[&Particle], ask: Ask<'_>) {
    let mut found: Vec<Particle> = found.to_vec();
    found.sort_by_key(|p| p.id);
    let wrong = right.iter().zip(&found).find(|(right, found)| **right != *found);
    if let Some((right, found)) = wrong {
        let question = format!(
            "{name}: the first particle in the list that is wrong; particle {} at y = {:?}, particle {} at y = {:?}",
            found.id, found.y, right.id, right.y
        );
        return ask(&question, vec![f64::from(found.id)], vec![f64::from(right.id)]);
    }
    ask(&format!("{name}: how many"), whole([found.len()]), whole([right.len()]));
}

/// The ids of wires, in their order.
fn ids(wires: &[Wire]) -> Vec<f64> {
    let mut ids: Vec<_> = wires.iter().map(|wire| wire.id as usize).collect();
    ids.sort_unstable();
    whole(ids)
}

/// Whether each wire is like the particle with its number.
fn like(wires: &[Wire], particles: &[Particle]) -> Vec<f64> {
    let differs = |wire: &&Wire| particles.get(wire.id as usize).is_none_or(|p| **wire != p.into());
    whole(wires.iter().filter(differs).map(|wire| wire.id as usize))
}

/// What a rank copies for its neighbours.
pub(super) fn copies(random: &mut Random, ask: Ask<'_>) {
    for case in 0..60 {
        let blocks = Blocks::drawn(random);
        let rank = random.below(blocks.cut.ranks);
        // Now and then a block without rows.
        let block = if case % 10 == 9 { 0..0 } else { blocks.block(rank) };
        // Now and then hundreds in a bin.
        let particles = blocks.particles(random, if case % 10 == 4 { 4097 } else { 300 });
        let mut bins = VecBins::new(blocks.grid);
        let seen = blocks.visible(&block);
        particles.iter().filter(|p| seen.contains(&blocks.row(p.y))).for_each(|p| bins.put(*p));
        let copies = border_copies(&bins, &blocks.cut, &block);
        let border = |row: usize| block.contains(&row) && !blocks.neighbours(row).is_empty();
        let expected = particles.iter().filter(|p| border(blocks.row(p.y)));
        let name = format!("{}, rows {block:?}", blocks.name(case));
        let expected = whole(expected.map(|p| p.id as usize));
        ask(&format!("{name}: the particles of which there are copies"), ids(&copies), expected);
        ask(&format!("{name}: copies unlike their particle"), like(&copies, &particles), vec![]);
    }
}

/// Which rank gets what.
pub(super) fn parcels(random: &mut Random, ask: Ask<'_>) {
    for case in 0..60 {
        let blocks = Blocks::drawn(random);
        let ranks = blocks.cut.ranks;
        let mut parcels = vec![Parcel::default(); ranks];
        let mut expected = vec![Vec::new(); ranks];
        for p in blocks.particles(random, 300) {
            let (row, far) = (blocks.row(p.y), random.below(40));
            let (owner, neighbours) = (blocks.owner(row), blocks.neighbours(row));
            // Ids of any size.
            let wire = Wire { id: u64::from(p.id) << far, ..Wire::from(&p) };
            let mut goes = neighbours.clone();
            match random.below(3) {
                0 if ranks > 1 => {
                    parcels[(owner + 1 + random.below(ranks - 1)) % ranks].leavers.push(wire);
                    goes.push(owner);
                }
                1 if !neighbours.is_empty() => parcels[owner].copies.push(wire),
                _ => continue,
            }
            goes.into_iter().for_each(|rank| expected[rank].push(wire));
        }
        let lists = sort_by_receiver(&blocks.grid, &blocks.cut, &parcels);
        ask(&format!("{}: lists", blocks.name(case)), whole([lists.len()]), whole([ranks]));
        for (rank, (list, expected)) in lists.iter().zip(expected).enumerate() {
            let name = format!("{}: what goes to rank {rank}", blocks.name(case));
            ask(&name, ids(list), ids(&expected));
        }
    }
}

/// What is in the rows that a rank sees, after new ghosts and new particles have come.
pub(super) fn ghosts(random: &mut Random, ask: Ask<'_>) {
    for case in 0..60 {
        let blocks = Blocks::drawn(random);
        let block = blocks.block(random.below(blocks.cut.ranks));
        let seen = blocks.visible(&block);
        let visible = |p: &Particle| seen.contains(&blocks.row(p.y));
        let mut bins = VecBins::new(blocks.grid);
        let before: Vec<_> = blocks.particles(random, 300).into_iter().filter(visible).collect();
        before.iter().for_each(|p| bins.put(*p));
        let new = |p: Particle| Particle { id: p.id + 1000, ..p };
        // Now and then nothing comes, and old ghosts go all the same.
        let most = if case % 5 == 0 { 0 } else { 300 };
        let arrived: Vec<_> =
            blocks.particles(random, most).into_iter().filter(visible).map(new).collect();
        let wires: Vec<Wire> = arrived.iter().map(Wire::from).collect();
        replace_ghosts(&mut bins, &block, &wires);
        let stay = before.iter().filter(|p| block.contains(&blocks.row(p.y)));
        let expected = whole(stay.chain(&arrived).map(|p| p.id as usize));
        let name = format!("{}, rows {block:?}: new ones, from 1000 on", blocks.name(case));
        let mut found: Vec<_> = bins.particles().map(|p| p.id as usize).collect();
        found.sort_unstable();
        ask(&format!("{name}, and old ones in its bins"), whole(found), expected);
        let astray = bins.bins().iter().enumerate().flat_map(|(bin, inside)| {
            inside.iter().filter(move |p| blocks.grid.bin(p) != bin).map(|p| p.id as usize)
        });
        ask(&format!("{name}: those in another bin than they lie in"), whole(astray), vec![]);
    }
}
