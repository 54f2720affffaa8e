//! The partition of the box into strips, one for each rank.

use std::ops::Range;

use mpi::Rank;
use solution2::Grid;
use solution6::Cuts;

/// The partition of the box: which ranks exchange ghosts, and how much work a rank has.
pub trait Partition {
    /// Returns the ranks that exchange ghosts with `rank`, in ascending order.
    ///
    /// They are all other ranks whose strips are not empty and are within `width` of the strip of
    /// `rank`. If a is a partner of b, then b is a partner of a. A rank with an empty strip has no
    /// partners.
    fn partners(strips: &Strips, rank: usize, width: f64) -> Vec<Rank>;

    /// Returns the cost of a step for a rank with `particles` particles and `pairs` listed pairs.
    fn load(particles: usize, pairs: usize) -> u64;

    /// Divides the load of a rank among the rows of the box; the rank has `counts[row]` particles
    /// in each row.
    fn weigh_rows(counts: &[u64], load: u64) -> Vec<u64>;
}

/// The box, cut across y into a strip for each rank.
// ANCHOR: strips
#[derive(Clone, Debug, PartialEq)]
pub struct Strips {
    /// The edges of the strips, ascending from −∞ to ∞: strip k is `edges[k] ≤ y < edges[k + 1]`.
    ///
    /// There is no particle beyond the walls, so a particle on a wall belongs to the strip at that
    /// wall. A strip between equal edges is empty.
    pub edges: Vec<f64>,
}
// ANCHOR_END: strips

impl Strips {
    /// Returns the strips that these blocks of rows form.
    pub fn of(grid: &Grid, cuts: &Cuts) -> Self {
        let edges = cuts.starts.iter().map(|&row| match row {
            0 => f64::NEG_INFINITY,
            row if row == grid.rows() => f64::INFINITY,
            row => row as f64 * grid.bin_side(),
        });
        Self { edges: edges.collect() }
    }

    /// Returns the number of strips.
    pub fn ranks(&self) -> usize {
        self.edges.len() - 1
    }

    /// Returns the strip of `rank`.
    #[inline]
    pub fn strip(&self, rank: usize) -> Range<f64> {
        self.edges[rank]..self.edges[rank + 1]
    }

    /// Returns the rank whose strip contains `y`.
    #[inline]
    pub fn owner(&self, y: f64) -> usize {
        self.edges[1..self.ranks()].partition_point(|edge| *edge <= y)
    }
}
