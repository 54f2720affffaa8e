//! A neighbour list that is kept from one rebuild to the next.

use std::f64::consts::PI;
use std::marker::PhantomData;

use common::soft::CUTOFF;
use pulp::Arch;
use workers::Workers;

use super::block::{Block, Collect, Filter};
use super::budget::Budget;
use crate::cells::{Cells, Extent, Grid, Sorter};
use crate::kernels::{Pair, Primitives, dispatch};
use crate::particles::Bodies;
use crate::threads::{LEAST, pieces};

/// Most blocks.
const BLOCKS: usize = 16;

/// The pairs that may come near each other until the list has expired.
#[derive(Default)]
pub struct Neighbours<P> {
    sorter: Sorter,
    /// Where the particles were when the list was built.
    pub cells: Option<Cells>,
    /// The pairs, band by band of the sorted particles.
    pub blocks: Vec<Block>,
    /// What is left of its skin.
    pub budget: Budget,
    /// What rounding may add to a distance.
    rounding: f64,
    primitives: PhantomData<P>,
}

impl<P: Primitives> Neighbours<P> {
    /// The particles as they were before the last sort, whose memory the next one will use.
    pub fn unsorted(&mut self) -> &mut Bodies {
        &mut self.sorter.spare
    }

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
            return P::best_skin(bodies.len() as f64 / area, displacement);
        }
        P::best_skin(self.density(bodies.len()), displacement)
    }

    /// Particles per area around a particle, of `n`, by the list.
    pub fn density(&self, n: usize) -> f64 {
        let reach = CUTOFF + self.budget.skin;
        self.per_particle(n) / (PI * reach * reach)
    }

    /// Sorts `bodies`, in a box of side `size`, and lists all pairs within the cutoff and `skin`.
    /// Returns how many pairs were tested.
    pub fn rebuild(&mut self, bodies: &mut Bodies, skin: f64, size: f64, workers: &Workers) -> u64 {
        self.rounding = 1e-15 * size;
        let reach = self.reach(skin);
        let grid = Grid::new(&Extent::among(bodies, workers), reach);
        if let Some(cells) = self.cells.take() {
            self.sorter.take_back(cells);
        }
        let cells = self.sorter.sort(bodies, grid, workers);
        self.list(bodies, &cells, reach, workers);
        self.cells = Some(cells);
        self.budget = Budget::of(skin);
        self.blocks.iter().map(|block| block.tested).sum()
    }

    fn list(&mut self, bodies: &Bodies, cells: &Cells, reach: f64, workers: &Workers) {
        let n = bodies.len();
        let length = pieces(n, LEAST, BLOCKS);
        self.blocks.resize_with(n.div_ceil(length), Block::default);
        workers.map(self.blocks.iter_mut().enumerate().collect(), |(k, block)| {
            let block: &mut Block = block;
            block.particles = k * length..n.min((k + 1) * length);
            dispatch(Collect { block, bodies, cells, reach, primitives: self.primitives });
        });
    }

    /// How far to look for a pair that may touch when it is closer by `skin`. Positions are
    /// rounded; a list must not miss a pair for that.
    pub fn reach(&self, skin: f64) -> f64 {
        (CUTOFF + skin) * (1.0 + 1e-9) + self.rounding
    }

    /// Builds the inner list: the pairs within the cutoff and `skin`, and `more`, in order. Returns how
    /// many pairs were tested.
    pub fn rebuild_inner(
        &mut self,
        skin: f64,
        more: &[Pair],
        bodies: &Bodies,
        workers: &Workers,
    ) -> u64 {
        let reach = self.reach(skin);
        let arch = Arch::new();
        let primitives = self.primitives;
        workers.map(self.blocks.iter_mut().collect(), |block: &mut Block| {
            arch.dispatch(Filter { block, bodies, reach, more, primitives });
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
