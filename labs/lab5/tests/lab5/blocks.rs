//! The blocks of some ranks in a grid of any size, and the particles in these blocks.

use std::ops::Range;

use common::soft::Particle;
use common_mpi::Wire;
use lab5::Cut;
use oracle::scenes::on_edges;
use oracle::{Ask, Random};
use solution2::Grid;

/// Returns the rows of each rank. The fractions of a row that are left over are carried from rank
/// to rank.
pub(crate) fn blocks_of(Cut { rows, ranks }: Cut) -> Vec<Range<usize>> {
    let mut blocks = Vec::with_capacity(ranks);
    let mut start = 0;
    // Rows that are carried to the next rank, in units of 1 / `ranks` of a row.
    let mut owed = 0;
    for _ in 0..ranks {
        owed += rows;
        let end = start + owed / ranks;
        owed %= ranks;
        blocks.push(start..end);
        start = end;
    }
    blocks
}

/// Returns the rank of each row.
pub(crate) fn owners_of(blocks: &[Range<usize>]) -> Vec<usize> {
    let ranks = blocks.iter().enumerate();
    ranks.flat_map(|(rank, block)| block.clone().map(move |_| rank)).collect()
}

/// A grid whose rows are cut into blocks.
pub(crate) struct Blocks {
    pub(crate) grid: Grid,
    pub(crate) cut: Cut,
    blocks: Vec<Range<usize>>,
    owners: Vec<usize>,
}

impl Blocks {
    /// Draws blocks with equal numbers of rows.
    pub(crate) fn drawn(random: &mut Random) -> Self {
        let ranks = [2, 1 + random.size(256), 1 + random.size(600)][random.below(3)];
        let rows = ranks * (1 + random.below(256 / ranks + 1));
        Self::of(rows, ranks, random)
    }

    /// Draws blocks of one row or none for each of many ranks.
    pub(crate) fn thin(random: &mut Random) -> Self {
        let rows = 1 + random.below(12);
        let ranks = rows * (2 + random.below(3));
        Self::of(rows, ranks, random)
    }

    /// Draws blocks of one row each, so that a ghost row may be the first or the last row of the box.
    pub(crate) fn single_rows(random: &mut Random) -> Self {
        let rows = 2 + random.below(10);
        Self::of(rows, rows, random)
    }

    fn of(rows: usize, ranks: usize, random: &mut Random) -> Self {
        let grid = Grid::with_bins_along(random.between(0.1, 9.0), rows);
        let cut = Cut { rows, ranks };
        let blocks = blocks_of(cut);
        let owners = owners_of(&blocks);
        Self { grid, cut, blocks, owners }
    }

    /// Draws particles anywhere, many of them on edges of bins.
    pub(crate) fn particles(&self, random: &mut Random, most: usize) -> Vec<Particle> {
        let n = random.size(most);
        on_edges(random, n, self.grid.size(), self.grid.rows())
    }

    pub(crate) fn row(&self, y: f64) -> usize {
        self.grid.row(y)
    }

    pub(crate) fn block(&self, rank: usize) -> Range<usize> {
        self.blocks[rank].clone()
    }

    pub(crate) fn owner(&self, row: usize) -> usize {
        self.owners[row]
    }

    /// Returns the other ranks that see a row.
    pub(crate) fn neighbours(&self, row: usize) -> Vec<usize> {
        let rows = [row.checked_sub(1), Some(row + 1).filter(|row| *row < self.cut.rows)];
        let owners = rows.into_iter().flatten().map(|row| self.owner(row));
        owners.filter(|owner| *owner != self.owner(row)).collect()
    }

    /// Returns whether any rank other than the owner of `block` sees a row.
    pub(crate) fn is_seen(&self, row: usize, block: &Range<usize>) -> bool {
        let others =
            self.blocks.iter().filter(|other| !other.is_empty() && other.start != block.start);
        others.into_iter().any(|other| self.visible(other).contains(&row))
    }

    /// Returns the rows that a rank sees.
    pub(crate) fn visible(&self, block: &Range<usize>) -> Range<usize> {
        block.start.saturating_sub(1)..(block.end + 1).min(self.cut.rows)
    }

    pub(crate) fn name(&self, case: usize) -> String {
        format!("case {case}, {} rows on {} ranks", self.cut.rows, self.cut.ranks)
    }
}

/// Converts particles for sending.
pub(crate) fn wires<'a>(particles: impl IntoIterator<Item = &'a Particle>) -> Vec<Wire> {
    particles.into_iter().map(Wire::from).collect()
}

/// Asks whether a list contains the correct particles, in any order and unchanged. The verdict
/// names the first wrong particle, with its row in `grid`.
pub(crate) fn same(
    grid: &Grid,
    name: &str,
    found: Vec<Wire>,
    right: impl FnOnce() -> Vec<Wire>,
    ask: &mut impl Ask,
) {
    let question = format!("{name}: id, x, y, vx, vy of each particle, in any order");
    ask.judge(
        &question,
        || numbers(&found),
        |found| {
            let found = found.chunks_exact(5).map(|n| Wire {
                x: n[1],
                y: n[2],
                vx: n[3],
                vy: n[4],
                id: n[0] as u64,
            });
            let [found, right] = [found.collect(), right()].map(by_id);
            let equal =
                found.iter().zip(&right).take_while(|(found, right)| found == right).count();
            let particle = |wire: &Wire, what: &str| {
                Err(format!("particle {}, in row {}, {what}", wire.id, grid.row(wire.y)))
            };
            match (found.get(equal), right.get(equal)) {
                (None, None) => Ok(()),
                (Some(found), Some(right)) if found.id == right.id => {
                    particle(right, "is different")
                }
                (Some(found), Some(right)) if right.id < found.id => particle(right, "is missing"),
                (None, Some(right)) => particle(right, "is missing"),
                (Some(found), _) => particle(found, "must not be in the list"),
            }
        },
    );
}

fn numbers(wires: &[Wire]) -> Vec<f64> {
    wires.iter().flat_map(|w| [w.id as f64, w.x, w.y, w.vx, w.vy]).collect()
}

fn by_id(mut wires: Vec<Wire>) -> Vec<Wire> {
    wires.sort_by_key(|wire| wire.id);
    wires
}
