//! The partition of the square into strips, one for each rank.

use common_mpi::Traffic;
use mpi::collective::SystemOperation;
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;
use solution6::{Cuts, balanced};

use crate::wire::DiscWire;

/// Number of rows for each rank. Cuts are between rows.
const ROWS_PER_RANK: usize = 512;

/// The square, divided into horizontal strips, one for each rank.
///
/// A strip consists of rows of equal height. The rows cover the positions that the discs had when
/// the strips were cut. Discs below the first row belong to the first row, and discs above the last
/// row to the last row. A rank's strip may be empty.
#[derive(Clone, Debug, PartialEq)]
pub struct Strips {
    /// The lower end of the first row.
    pub bottom: f64,
    /// Height of a row. It is 0 if all discs had the same y; then there is one row.
    pub height: f64,
    /// The rows of each rank.
    pub cuts: Cuts,
}

/// The ranks whose strips a disc can be in during this step: all from `first` to `last`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Reach {
    /// The lowest rank.
    pub first: usize,
    /// The highest rank.
    pub last: usize,
}

impl Reach {
    /// Whether `rank` is one of these ranks.
    pub fn contains(&self, rank: usize) -> bool {
        (self.first..=self.last).contains(&rank)
    }

    /// Whether there are two or more ranks.
    pub fn is_shared(&self) -> bool {
        self.first < self.last
    }
}

impl Strips {
    /// Returns strips with equal numbers of discs, as far as cuts between rows allow.
    ///
    /// `own` are the discs of this rank. All ranks call this function together and get the same
    /// strips.
    pub fn balanced(world: &SimpleCommunicator, own: &[DiscWire], traffic: &mut Traffic) -> Self {
        let low = own.iter().map(|disc| disc.y).fold(f64::INFINITY, f64::min);
        let high = own.iter().map(|disc| disc.y).fold(f64::NEG_INFINITY, f64::max);
        // One reduction finds both ends, because the least −y is the negative of the greatest y.
        let own_ends = [low, -high];
        let mut ends = [0.0; 2];
        world.all_reduce_into(&own_ends[..], &mut ends[..], SystemOperation::min());
        traffic.sent(&ends);
        let bottom = ends[0];
        let top = -ends[1];
        let ranks = world.size() as usize;
        let rows = if top > bottom { ROWS_PER_RANK * ranks } else { 1 };
        let one_strip = Cuts { starts: vec![0, rows] };
        let mut strips = Self { bottom, height: (top - bottom) / rows as f64, cuts: one_strip };
        let mut counts = vec![0_u64; rows];
        let mut all = vec![0_u64; rows];
        own.iter().for_each(|disc| counts[strips.row(disc.y)] += 1);
        world.all_reduce_into(&counts[..], &mut all[..], SystemOperation::sum());
        traffic.sent(&counts);
        strips.cuts = balanced(&all, ranks);
        strips
    }

    fn rows(&self) -> usize {
        *self.cuts.starts.last().expect("cuts have a start and an end")
    }

    fn row(&self, y: f64) -> usize {
        // The conversion turns negative numbers into 0, and also NaN, the result for height 0.
        (((y - self.bottom) / self.height) as usize).min(self.rows() - 1)
    }

    /// Returns the rank whose strip contains height `y`. The rank never decreases as y grows.
    #[inline]
    pub fn rank_of(&self, y: f64) -> usize {
        self.cuts.owner(self.row(y))
    }

    /// Returns the *partners* of `rank`: the ranks that it may have to send a disc to.
    ///
    /// Their strips begin within `range` of the strip of `rank`. If a is a partner of b, then b is
    /// a partner of a. A rank with an empty strip has no partners.
    pub fn partners(&self, rank: usize, range: f64) -> Vec<usize> {
        if self.cuts.block(rank).is_empty() {
            return Vec::new();
        }
        let mut partners = Vec::new();
        for other in 0..self.cuts.starts.len() - 1 {
            let below = self.cuts.block(rank.min(other));
            let above = self.cuts.block(rank.max(other));
            let between = above.start.saturating_sub(below.end) as f64 * self.height;
            if other != rank && !self.cuts.block(other).is_empty() && between <= range {
                partners.push(other);
            }
        }
        partners
    }
}
