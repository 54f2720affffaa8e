//! The neighbour list: who might touch whom until the next rebuild.

use std::ops::Range;

use crate::{Bodies, Cells};

/// The neighbours of a range of particles, one after another.
#[derive(Default)]
pub struct Block {
    /// The particles, in sorted order.
    pub particles: Range<usize>,
    /// Where the list of each of them ends in `neighbours`.
    pub ends: Vec<u32>,
    /// Their neighbours' places in the sorted order; each pair stands in both lists.
    pub neighbours: Vec<u32>,
    /// How many pairs were looked at to find them.
    pub tested: u64,
}

/// Appends to `list` every particle of `range` but `i` itself that is within `reach` of particle
/// `i` (at `reach` is within). All are places in the sorted order.
///
/// A branch on the distance would be guessed wrong about as often as not. Make room for all of
/// `range` first, write every candidate down, and let the next one overwrite it if it was too
/// far: then there is nothing to guess.
///
/// Book: chapter 10, *A list that lasts*.
#[inline(always)]
pub fn collect(list: &mut Vec<u32>, bodies: &Bodies, i: usize, range: Range<usize>, reach: f64) {
    // task 10.2: the neighbours of one particle
    let (xi, yi, first) = (bodies.x[i], bodies.y[i], range.start);
    let mut len = list.len();
    list.resize(len + range.len(), 0);
    for (k, (x, y)) in bodies.x[range.clone()].iter().zip(&bodies.y[range]).enumerate() {
        let (dx, dy) = (x - xi, y - yi);
        let j = first + k;
        list[len] = j as u32;
        len += usize::from((dx * dx + dy * dy <= reach * reach) & (j != i));
    }
    list.truncate(len);
    // end 10.2
}

impl Block {
    /// Lists all neighbours within `reach` of the particles in `cells`, a range of stored cells.
    #[inline(always)]
    pub fn fill(&mut self, bodies: &Bodies, all: &Cells, cells: Range<usize>, reach: f64) {
        self.particles = all.particles(&cells);
        self.ends.clear();
        self.neighbours.clear();
        self.tested = 0;
        for k in cells {
            let own = all.own(k);
            if own.is_empty() {
                continue;
            }
            let rows = all.around(k);
            for i in own {
                for row in &rows {
                    collect(&mut self.neighbours, bodies, i, row.clone(), reach);
                    self.tested += row.len() as u64;
                }
                self.ends.push(self.neighbours.len() as u32);
            }
        }
    }
}
