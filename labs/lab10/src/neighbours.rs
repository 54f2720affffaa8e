//! A neighbour list that is kept from one rebuild to the next.

use std::f64::consts::PI;

use common::soft::CUTOFF;
use pulp::Arch;

use crate::list::{Block, Fill};
use crate::wear::Wear;
use crate::workers::pieces;
use crate::{Bodies, Cells, Extent, Grid, Sorter, Workers, best_skin};

/// Particles that are computed and moved together, roughly.
const PIECE: usize = 1024;
/// Most pieces: a row of cells grows with the root of their number, and a piece should be longer
/// than what it looks ahead.
const PIECES: usize = 256;
/// Most blocks.
const BLOCKS: usize = 16;

/// The pairs that may come near each other until the list is worn out.
#[derive(Default)]
pub(crate) struct Neighbours {
    sorter: Sorter,
    /// The pairs, band by band of the sorted particles.
    pub(crate) blocks: Vec<Block>,
    pub(crate) wear: Wear,
    /// Steps since it was built.
    age: u32,
}

impl Neighbours {
    /// Forgets the list: the particles are others, or in another order.
    pub(crate) fn forget(&mut self) {
        self.blocks.clear();
        (self.wear, self.age) = (Wear::default(), 0);
    }

    /// Grows older by a step in which nobody goes further than `way`.
    pub(crate) fn age(&mut self, way: f64) {
        self.wear.way += way;
        self.age += 1;
    }

    /// The skin that makes a step of length `dt` cheapest, by the last list if there is one.
    pub(crate) fn cheapest_skin(&self, bodies: &Bodies, dt: f64) -> f64 {
        if self.blocks.is_empty() {
            let extent = Extent::of(bodies);
            let area = (extent.width + CUTOFF) * (extent.height + CUTOFF);
            return best_skin(bodies.len() as f64 / area, bodies.fastest() * dt);
        }
        let reach = CUTOFF + self.wear.skin;
        let density = self.per_particle(bodies.len()) / (PI * reach * reach);
        best_skin(density, self.wear.way / f64::from(self.age.max(1)))
    }

    /// Sorts `bodies`, in a box of side `size`, and lists all pairs within the cutoff and `skin`.
    /// Brings back how many pairs were looked at.
    pub(crate) fn rebuild(
        &mut self,
        bodies: &mut Bodies,
        spare: &mut Bodies,
        skin: f64,
        size: f64,
        workers: &Workers,
    ) -> u64 {
        // The place of a particle is rounded; a list must not miss a pair for that.
        let reach = (CUTOFF + skin) * (1.0 + 1e-9) + 1e-15 * size;
        let grid = Grid::new(&Extent::among(bodies, workers), reach);
        let dense = grid.cells() <= 4 * bodies.len() as u64 + 64;
        let cells = self.sorter.sort(bodies, spare, grid, dense, 0.0, workers);
        std::mem::swap(bodies, spare);
        self.list(bodies, &cells, reach, workers);
        self.sorter.take_back(cells);
        (self.wear, self.age) = (Wear::of(skin), 0);
        self.blocks.iter().map(|block| block.tested).sum()
    }

    fn list(&mut self, bodies: &Bodies, cells: &Cells, reach: f64, workers: &Workers) {
        let pieces = cells.pieces(pieces(bodies.len(), PIECE, PIECES));
        let bands: Vec<_> = pieces.chunks(pieces.len().div_ceil(BLOCKS).max(2)).collect();
        self.blocks.resize_with(bands.len(), Block::default);
        let arch = Arch::new();
        let work = self.blocks.iter_mut().zip(bands).collect();
        workers.map(work, |(block, pieces): (&mut Block, _)| {
            arch.dispatch(Fill { block, bodies, cells, pieces, reach });
        });
    }

    /// How many pairs are listed.
    pub(crate) fn pairs(&self) -> usize {
        self.blocks.iter().map(|block| block.pairs.len()).sum()
    }

    /// Neighbours within the cutoff and the skin per particle, of `n`.
    pub(crate) fn per_particle(&self, n: usize) -> f64 {
        2.0 * self.pairs() as f64 / n as f64
    }
}
