//! The blocks of some ranks in a grid of any size, and which particles are in them.

use std::ops::Range;

use common::soft::Particle;
use common_mpi::Wire;
use lab5::Cut;
use oracle::scenes::on_edges;
use oracle::{Ask, Random};
use solution2::Grid;

/// The rows of a rank, as the lab's text says.
pub(crate) fn block_of(Cut { rows, ranks }: Cut, rank: usize) -> Range<usize> {
    rank * rows / ranks..(rank + 1) * rows / ranks
}

/// The rank of a row.
pub(crate) fn owner_of(Cut { rows, ranks }: Cut, row: usize) -> usize {
    ((row + 1) * ranks - 1) / rows
}

/// A grid whose rows are cut into blocks.
pub(crate) struct Blocks {
    pub(crate) grid: Grid,
    pub(crate) cut: Cut,
}

impl Blocks {
    /// Blocks of as many rows each.
    pub(crate) fn drawn(random: &mut Random) -> Self {
        let ranks = [2, 1 + random.size(256), 1 + random.size(600)][random.below(3)];
        let rows = ranks * (1 + random.below(256 / ranks + 1));
        Self::of(rows, ranks, random)
    }

    /// A row or none for each of many ranks.
    pub(crate) fn thin(random: &mut Random) -> Self {
        let rows = 1 + random.below(12);
        let ranks = rows * (2 + random.below(3));
        Self::of(rows, ranks, random)
    }

    fn of(rows: usize, ranks: usize, random: &mut Random) -> Self {
        let grid = Grid::with_bins_along(random.between(0.1, 9.0), rows);
        Self { grid, cut: Cut { rows, ranks } }
    }

    /// Particles anywhere, many of them on edges of bins.
    pub(crate) fn particles(&self, random: &mut Random, most: usize) -> Vec<Particle> {
        let n = random.size(most);
        on_edges(random, n, self.grid.size(), self.grid.rows())
    }

    pub(crate) fn row(&self, y: f64) -> usize {
        self.grid.row(y)
    }

    pub(crate) fn block(&self, rank: usize) -> Range<usize> {
        block_of(self.cut, rank)
    }

    pub(crate) fn owner(&self, row: usize) -> usize {
        owner_of(self.cut, row)
    }

    /// The other ranks that see a row.
    pub(crate) fn neighbours(&self, row: usize) -> Vec<usize> {
        let rows = [row.checked_sub(1), Some(row + 1).filter(|row| *row < self.cut.rows)];
        let owners = rows.into_iter().flatten().map(|row| self.owner(row));
        owners.filter(|owner| *owner != self.owner(row)).collect()
    }

    /// The rows that a rank sees.
    pub(crate) fn visible(&self, block: &Range<usize>) -> Range<usize> {
        block.start.saturating_sub(1)..(block.end + 1).min(self.cut.rows)
    }

    pub(crate) fn name(&self, case: usize) -> String {
        format!("case {case}, {} rows on {} ranks", self.cut.rows, self.cut.ranks)
    }
}

/// Particles as they are sent.
pub(crate) fn wires<'a>(particles: impl IntoIterator<Item = &'a Particle>) -> Vec<Wire> {
    particles.into_iter().map(Wire::from).collect()
}

/// Asks whether a list has the right particles, in any order and unchanged. Where it has not, the first
/// particle at fault is named, with its row in `grid`.
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
                    particle(right, "is not as it was")
                }
                (Some(found), Some(right)) if right.id < found.id => particle(right, "is missing"),
                (None, Some(right)) => particle(right, "is missing"),
                (Some(found), _) => particle(found, "is one too many"),
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
