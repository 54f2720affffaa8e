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

/// The rows of a rank, as the lab says.
fn block_of(Cut { rows, ranks }: Cut, rank: usize) -> Range<usize> {
    rank * rows / ranks..(rank + 1) * rows / ranks
}

/// The rank of a row.
fn owner_of(Cut { rows, ranks }: Cut, row: usize) -> usize {
    ((row + 1) * ranks - 1) / rows
}

/// All cuts of few rows among few ranks; then of more of both, some blocks and the owners of some rows.
pub(super) fn cuts(random: &mut Random, ask: Ask<'_>) {
    const FEW: usize = 30;
    for (rows, ranks) in (1..=FEW).flat_map(|rows| (1..=FEW).map(move |ranks| (rows, ranks))) {
        let (cut, name) = (Cut { rows, ranks }, format!("{rows} rows on {ranks} ranks"));
        let blocks =
            (0..ranks).map(|rank| cut.block(rank)).flat_map(|block| [block.start, block.end]);
        let right = (0..ranks).map(|rank| block_of(cut, rank));
        let right = right.flat_map(|block| [block.start, block.end]);
        ask(&format!("{name}: start and end of each block"), whole(blocks), whole(right));
        let owners = (0..rows).map(|row| cut.owner(row));
        let right = (0..rows).map(|row| owner_of(cut, row));
        ask(&format!("{name}: the rank that has each row"), whole(owners), whole(right));
    }
    for case in 0..60 {
        // Many of both, rows without end, and so many ranks that no search comes to an end.
        let most = [(70_000, 70_000), (1 << 40, 300), (1 << 20, 1 << 40)][case % 3];
        let cut = Cut { rows: 1 + random.size(most.0), ranks: 1 + random.size(most.1) };
        let Cut { rows, ranks } = cut;
        for rank in [0, ranks - 1, random.below(ranks), random.below(ranks)] {
            let (block, right) = (cut.block(rank), block_of(cut, rank));
            let name =
                format!("{rows} rows on {ranks} ranks: start and end of the block of rank {rank}");
            ask(&name, whole([block.start, block.end]), whole([right.start, right.end]));
        }
        for row in [0, rows - 1, random.below(rows), random.below(rows)] {
            let name = format!("{rows} rows on {ranks} ranks: the rank that has row {row}");
            ask(&name, whole([cut.owner(row)]), whole([owner_of(cut, row)]));
        }
    }
}

/// The blocks of some ranks in a grid of any size.
struct Blocks {
    grid: Grid,
    cut: Cut,
}

impl Blocks {
    /// Blocks of as many rows each.
    fn drawn(random: &mut Random) -> Self {
        let ranks = [2, 1 + random.size(256), 1 + random.size(600)][random.below(3)];
        let rows = ranks * (1 + random.below(256 / ranks + 1));
        Self::of(rows, ranks, random)
    }

    /// A row or none for each of many ranks.
    fn thin(random: &mut Random) -> Self {
        let rows = 1 + random.below(12);
        let ranks = rows * (2 + random.below(3));
        Self::of(rows, ranks, random)
    }

    fn of(rows: usize, ranks: usize, random: &mut Random) -> Self {
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
        block_of(self.cut, rank)
    }

    fn owner(&self, row: usize) -> usize {
        owner_of(self.cut, row)
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

    /// Asks whether a list has the right particles, in any order, as they were; where it has not, about the first.
    fn same(&self, name: &str, found: Vec<Wire>, right: Vec<Wire>, ask: Ask<'_>) {
        let [found, right] = [found, right].map(|mut wires| {
            wires.sort_by_key(|wire| wire.id);
            wires
        });
        let equal = found.iter().zip(&right).take_while(|(found, right)| found == right).count();
        let fault = match (found.get(equal), right.get(equal)) {
            (None, None) => vec![],
            (Some(found), Some(right)) if found.id == right.id => self.fault(right, 3),
            (Some(found), Some(right)) if right.id < found.id => self.fault(right, 1),
            (Some(found), _) => self.fault(found, 2),
            (None, Some(right)) => self.fault(right, 1),
        };
        let question = format!(
            "{name}: the first particle at fault: its number and its row, and 1 if it is missing, 2 if it is one too \
             many, 3 if it is not as it was"
        );
        ask(&question, fault, vec![]);
    }

    fn fault(&self, wire: &Wire, kind: usize) -> Vec<f64> {
        whole([wire.id as usize, self.row(wire.y), kind])
    }
}

/// As they are sent.
fn wires<'a>(particles: impl IntoIterator<Item = &'a Particle>) -> Vec<Wire> {
    particles.into_iter().map(Wire::from).collect()
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
        let (stay, leave): (Vec<Particle>, Vec<Particle>) =
            particles.into_iter().partition(|p| block.contains(&blocks.row(p.y)));
        let name = format!("case {case}, rows {block:?} of {rows}");
        blocks.same(&format!("{name}, local"), wires(&changed), wires(&stay), ask);
        let right = wires(leave.iter().chain([&before]));
        let name = format!("{name}, remote, where particle {} was before", before.id);
        blocks.same(&name, wires(&remote), right, ask);
    }
}

/// What a rank copies for its neighbours.
pub(super) fn copies(random: &mut Random, ask: Ask<'_>) {
    for case in 0..60 {
        let blocks = if case % 4 == 1 { Blocks::thin(random) } else { Blocks::drawn(random) };
        // Every second rank has rows: where ranks outnumber them, a single one.
        let rank = match case % 2 {
            1 => blocks.owner(random.below(blocks.cut.rows)),
            _ => random.below(blocks.cut.ranks),
        };
        let mut block = blocks.block(rank);
        // Now and then a block without rows.
        if case % 10 == 9 {
            block.end = block.start;
        }
        // Now and then hundreds in a bin.
        let particles = blocks.particles(random, if case % 10 == 4 { 4097 } else { 300 });
        let mut bins = VecBins::new(blocks.grid);
        let seen = blocks.visible(&block);
        particles.iter().filter(|p| seen.contains(&blocks.row(p.y))).for_each(|p| bins.put(*p));
        let copies = border_copies(&bins, &blocks.cut, &block);
        let border = |row: usize| block.contains(&row) && !blocks.neighbours(row).is_empty();
        let right = wires(particles.iter().filter(|p| border(blocks.row(p.y))));
        let name = format!("{}, rows {block:?}: copies", blocks.name(case));
        blocks.same(&name, copies, right, ask);
    }
}

/// Which rank gets what.
pub(super) fn parcels(random: &mut Random, ask: Ask<'_>) {
    for case in 0..60 {
        let blocks = if case % 4 == 1 { Blocks::thin(random) } else { Blocks::drawn(random) };
        let ranks = blocks.cut.ranks;
        let mut parcels = vec![Parcel::default(); ranks];
        let mut expected = vec![Vec::new(); ranks];
        for p in blocks.particles(random, 300) {
            let row = blocks.row(p.y);
            let (owner, neighbours) = (blocks.owner(row), blocks.neighbours(row));
            // Now and then numbers beyond 32 bits.
            let far = if case % 4 == 2 { random.below(1 << 20) as u64 } else { 0 };
            let wire = Wire { id: u64::from(p.id) + (far << 32), ..Wire::from(&p) };
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
            blocks.same(&name, list.clone(), expected, ask);
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
        replace_ghosts(&mut bins, &block, &wires(&arrived));
        let stay = before.iter().filter(|p| block.contains(&blocks.row(p.y)));
        let right = wires(stay.chain(&arrived));
        let name = format!("{}, rows {block:?}, new ones from 1000 on", blocks.name(case));
        blocks.same(&format!("{name}: what is in the bins"), wires(bins.particles()), right, ask);
        let astray = bins.bins().iter().enumerate().flat_map(|(bin, inside)| {
            inside.iter().filter(move |p| blocks.grid.bin(p) != bin).map(|p| p.id as usize)
        });
        ask(&format!("{name}: those in another bin than they lie in"), whole(astray), vec![]);
    }
}
