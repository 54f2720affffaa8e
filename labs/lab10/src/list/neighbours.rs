//! A neighbour list that is kept from one rebuild to the next.

use std::f64::consts::PI;

use common::soft::CUTOFF;
use pulp::Arch;

use super::block::{Block, Collect, Shorten};
use super::budget::Budget;
use crate::cells::{Cells, Extent, Grid, Sorter};
use crate::kernels::{Pair, dispatch};
use crate::particles::Bodies;
use crate::skin::best_skin;
use crate::threads::{LEAST, Workers, pieces};

/// Particles that are computed and moved together, roughly.
const PIECE: usize = 1000;
/// Most pieces of a block: a row of cells grows with the root of the number of particles, and a piece
/// should be longer than what it looks ahead.
const PIECES: usize = 16;
/// Most blocks.
const BLOCKS: usize = 16;

/// The pairs that may come near each other until the list is worn out.
#[derive(Default)]
pub struct Neighbours {
    sorter: Sorter,
    /// Where the particles were when the list was built.
    pub cells: Option<Cells>,
    /// The pairs, band by band of the sorted particles.
    pub blocks: Vec<Block>,
    /// What is left of its skin.
    pub budget: Budget,
    /// What rounding may add to a distance.
    rounding: f64,
}

impl Neighbours {
    /// Forgets the list: other particles, or another order.
    pub fn forget(&mut self) {
        self.blocks.clear();
        self.budget = Budget::default();
    }

    /// The skin that makes a step cheapest in which a particle goes `displacement`, by the last
    /// list if there is one.
    pub fn cheapest_skin(&self, bodies: &Bodies, displacement: f64) -> f64 {
        if self.blocks.is_empty() {
            let extent = Extent::of(bodies);
            let area = (extent.width + CUTOFF) * (extent.height + CUTOFF);
            return best_skin(bodies.len() as f64 / area, displacement);
        }
        best_skin(self.density(bodies.len()), displacement)
    }

    /// Particles per area around a particle, of `n`, by the list.
    pub fn density(&self, n: usize) -> f64 {
        let reach = CUTOFF + self.budget.skin;
        self.per_particle(n) / (PI * reach * reach)
    }

    /// Sorts `bodies`, in a box of side `size`, and lists all pairs within the cutoff and `skin`.
    /// Brings back how many pairs were looked at.
    pub fn rebuild(
        &mut self,
        bodies: &mut Bodies,
        spare: &mut Bodies,
        skin: f64,
        size: f64,
        workers: &Workers,
    ) -> u64 {
        self.rounding = 1e-15 * size;
        let reach = self.reach(skin);
        let grid = Grid::new(&Extent::among(bodies, workers), reach);
        let dense = grid.is_dense(bodies.len());
        if let Some(cells) = self.cells.take() {
            self.sorter.take_back(cells);
        }
        let cells = self.sorter.sort(bodies, spare, grid, dense, workers);
        self.list(bodies, &cells, reach, workers);
        self.cells = Some(cells);
        self.budget = Budget::of(skin);
        self.blocks.iter().map(|block| block.tested).sum()
    }

    fn list(&mut self, bodies: &Bodies, cells: &Cells, reach: f64, workers: &Workers) {
        let length = pieces(bodies.len(), LEAST, BLOCKS);
        let each = (length / PIECE).clamp(1, PIECES);
        let all = cells.pieces(length.div_ceil(each));
        let bands: Vec<_> = all.chunks(each).collect();
        self.blocks.resize_with(bands.len(), Block::default);
        let work = self.blocks.iter_mut().zip(bands).collect();
        workers.map(work, |(block, pieces): (&mut Block, _)| {
            dispatch(Collect { block, bodies, cells, pieces, reach });
        });
    }

    /// How far to look for a pair that may touch when it is closer by `skin`. The place of a
    /// particle is rounded; a list must not miss a pair for that.
    pub fn reach(&self, skin: f64) -> f64 {
        (CUTOFF + skin) * (1.0 + 1e-9) + self.rounding
    }

    /// Makes the short list: the pairs within the cutoff and `skin`, and `more`, in order. Brings
    /// back how many pairs were looked at.
    pub fn shorten(&mut self, skin: f64, more: &[Pair], bodies: &Bodies, workers: &Workers) -> u64 {
        let (reach, arch) = (self.reach(skin), Arch::new());
        workers.map(self.blocks.iter_mut().collect(), |block: &mut Block| {
            arch.dispatch(Shorten { block, bodies, reach, more });
        });
        self.pairs() as u64
    }

    /// How many pairs are listed.
    pub fn pairs(&self) -> usize {
        self.blocks.iter().map(|block| block.outer.len()).sum()
    }

    /// Neighbours within the cutoff and the skin per particle, of `n`.
    pub fn per_particle(&self, n: usize) -> f64 {
        2.0 * self.pairs() as f64 / n as f64
    }
}
