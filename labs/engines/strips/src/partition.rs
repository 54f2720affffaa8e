//! The box in strips, one for each rank.

use std::ops::Range;

use mpi::Rank;
use solution2::Grid;
use solution6::Cuts;

/// How the box is shared out: which ranks need ghosts of each other, and what the work of a rank is.
pub trait Partition {
    /// The ranks that need ghosts of `rank` and send it theirs, in ascending order: all others whose strip is not
    /// empty and no further than `width` from that of `rank`. If a finds b then b finds a. A rank with an empty strip
    /// has none.
    fn partners(strips: &Strips, rank: usize, width: f64) -> Vec<Rank>;

    /// The cost of a step for a rank with `particles` particles and `pairs` listed pairs.
    fn load(particles: usize, pairs: usize) -> u64;

    /// The load of a rank, shared out to the rows of the box, in which it has `counts` particles.
    fn weigh_rows(counts: &[u64], load: u64) -> Vec<u64>;
}

/// The box, cut across y into a strip for each rank.
// ANCHOR: strips
#[derive(Clone, Debug, PartialEq)]
pub struct Strips {
    /// Strip k is `edges[k] ≤ y < edges[k + 1]`. Ascending, from −∞ to ∞: beyond the walls there
    /// is nothing, and a particle on a wall belongs to the strip beside it. Where two edges are
    /// equal, the strip between them is empty.
    pub edges: Vec<f64>,
}
// ANCHOR_END: strips

impl Strips {
    /// The strips of blocks of rows.
    pub fn of(grid: &Grid, cuts: &Cuts) -> Self {
        let edges = cuts.starts.iter().map(|&row| match row {
            0 => f64::NEG_INFINITY,
            row if row == grid.rows() => f64::INFINITY,
            row => row as f64 * grid.bin_side(),
        });
        Self { edges: edges.collect() }
    }

    /// How many strips there are.
    pub fn ranks(&self) -> usize {
        self.edges.len() - 1
    }

    /// The strip of `rank`.
    #[inline]
    pub fn strip(&self, rank: usize) -> Range<f64> {
        self.edges[rank]..self.edges[rank + 1]
    }

    /// The rank whose strip `y` lies in.
    #[inline]
    pub fn owner(&self, y: f64) -> usize {
        self.edges[1..self.ranks()].partition_point(|edge| *edge <= y)
    }
}
