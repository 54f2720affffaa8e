//! The neighbour list, with the memory that it keeps from one rebuild to the next.

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

/// Greatest number of blocks.
const BLOCKS: usize = 16;

/// The pairs that may come within the cutoff before the list expires.
#[derive(Default)]
pub struct Neighbours<P> {
    sorter: Sorter,
    /// The cells of the particles when the list was built.
    pub cells: Option<Cells>,
    /// The pairs, in a block for each range of sorted particles.
    pub blocks: Vec<Block>,
    /// The skin, and the part of the skin that is used up.
    pub budget: Budget,
    /// The greatest amount by which rounding changes a distance.
    rounding: f64,
    primitives: PhantomData<P>,
}

impl<P: Primitives> Neighbours<P> {
    /// Returns the particles in their order before the last sort, in the memory that the next sort
    /// will use.
    pub fn unsorted(&mut self) -> &mut Bodies {
        &mut self.sorter.spare
    }

    /// Forgets the list, because the particles or their order have changed.
    pub fn forget(&mut self) {
        self.blocks.clear();
        self.budget = Budget::default();
    }

    /// Returns the skin that makes steps cheapest, if particles go at most `displacement` in a
    /// step.
    ///
    /// The density is estimated from the last list, or from the extent of the particles if there is
    /// no list.
    pub fn cheapest_skin(&self, bodies: &Bodies, displacement: f64) -> f64 {
        if self.blocks.is_empty() {
            let extent = Extent::of(bodies);
            let area = (extent.width + CUTOFF) * (extent.height + CUTOFF);
            return P::best_skin(bodies.len() as f64 / area, displacement);
        }
        P::best_skin(self.density(bodies.len()), displacement)
    }

    /// Returns the mean number of particles per unit area around a particle, from the list of `n`
    /// particles.
    pub fn density(&self, n: usize) -> f64 {
        let reach = CUTOFF + self.budget.skin;
        self.per_particle(n) / (PI * reach * reach)
    }

    /// Sorts `bodies`, in a box of side `size`, and lists all pairs within the cutoff plus `skin`.
    ///
    /// Returns the number of pairs that were tested.
    pub fn rebuild(&mut self, bodies: &mut Bodies, skin: f64, size: f64, workers: &Workers) -> u64 {
        self.sort(bodies, skin, size, workers);
        self.collect(bodies, workers)
    }

    /// Sorts `bodies` into cells for a new list.
    pub(crate) fn sort(&mut self, bodies: &mut Bodies, skin: f64, size: f64, workers: &Workers) {
        self.rounding = 1e-15 * size;
        let reach = self.reach(skin);
        let grid = Grid::new(&Extent::among(bodies, workers), reach);
        if let Some(cells) = self.cells.take() {
            self.sorter.take_back(cells);
        }
        self.cells = Some(self.sorter.sort(bodies, grid, workers));
        self.budget = Budget::of(skin);
    }

    /// Lists the pairs of `bodies`, which [`sort`](Self::sort) has sorted. Returns the number of
    /// pairs that were tested.
    ///
    /// # Panics
    /// If the bodies have not been sorted.
    pub(crate) fn collect(&mut self, bodies: &Bodies, workers: &Workers) -> u64 {
        let cells = self.cells.as_ref().expect("the bodies are sorted");
        let reach = self.reach(self.budget.skin);
        let n = bodies.len();
        let length = pieces(n, LEAST, BLOCKS);
        self.blocks.resize_with(n.div_ceil(length), Block::default);
        workers.map(self.blocks.iter_mut().enumerate().collect(), |(k, block)| {
            let block: &mut Block = block;
            block.particles = k * length..n.min((k + 1) * length);
            dispatch(Collect { block, bodies, cells, reach, primitives: self.primitives });
        });
        self.blocks.iter().map(|block| block.tested).sum()
    }

    /// Returns the distance within which pairs are listed, for this `skin`.
    ///
    /// The distance is slightly more than the cutoff plus `skin`, because rounded positions must
    /// not hide a pair.
    pub fn reach(&self, skin: f64) -> f64 {
        (CUTOFF + skin) * (1.0 + 1e-9) + self.rounding
    }

    /// Builds the inner list: the pairs within the cutoff plus `skin`, and the pairs `more`, which
    /// are in order.
    ///
    /// Returns the number of pairs that were tested.
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

    /// Returns the number of listed pairs.
    pub fn pairs(&self) -> usize {
        self.blocks.iter().map(|block| block.outer.len()).sum()
    }

    /// Returns the mean number of listed neighbours of a particle, for `n` particles.
    pub fn per_particle(&self, n: usize) -> f64 {
        2.0 * self.pairs() as f64 / n as f64
    }
}
