//! Task 13.2: strips of the box, and which ranks need ghosts of each other.

use std::ops::Range;

use mpi::Rank;
use solution2::Grid;
use solution6::Cuts;

/// The box, cut across y into a strip for each rank.
#[derive(Clone, Debug, PartialEq)]
pub struct Strips {
    /// Strip k is `edges[k] ≤ y < edges[k + 1]`. Ascending, from −∞ to ∞: beyond the walls there
    /// is nothing, and a particle on a wall belongs to the strip beside it. Where two edges are
    /// equal, the strip between them is empty.
    pub edges: Vec<f64>,
}

impl Strips {
    /// The strips of blocks of rows.
    pub fn of(grid: &Grid, cuts: &Cuts) -> Self {
        let edge = |row: usize| match row {
            0 => f64::NEG_INFINITY,
            row if row == grid.rows() => f64::INFINITY,
            row => row as f64 * grid.bin_side(),
        };
        Self { edges: cuts.starts.iter().map(|row| edge(*row)).collect() }
    }

    /// The strip of `rank`.
    pub fn strip(&self, rank: usize) -> Range<f64> {
        self.edges[rank]..self.edges[rank + 1]
    }

    /// The rank whose strip `y` lies in.
    pub fn owner(&self, y: f64) -> usize {
        let ranks = self.edges.len() - 1;
        self.edges[1..ranks].partition_point(|edge| *edge <= y)
    }

    /// The ranks that need ghosts of `rank` and send it theirs: all other ranks whose strip is no
    /// further than `width` from that of `rank` (at `width` is not further), in ascending order.
    ///
    /// Mostly they are the rank before and the rank after. But strips may be thinner than `width`,
    /// and then ghosts go further than to the next one. An empty strip has no particles: its rank
    /// needs no ghosts and has none to send.
    ///
    /// Every rank finds its own partners by itself, without a message. So a must find b exactly if
    /// b finds a.
    ///
    /// Book: chapter 13, *Which ranks are partners*.
    pub fn partners(&self, rank: usize, width: f64) -> Vec<Rank> {
        todo!("task 13.2: the ranks within the width of the ghosts")
    }
}
