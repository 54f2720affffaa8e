//! Which particles stand in which cell, when particles are sorted by cell.

use std::ops::Range;

use super::grid::Grid;

/// Particles in sorted order, cell by cell. Cells run along x first: the particles of a cell and
/// of its right neighbour are next to each other in memory.
pub struct Cells {
    /// Where the cells lie.
    pub grid: Grid,
    /// How the cells are stored.
    pub kind: Kind,
    /// For each particle the number of its stored cell.
    pub home: Vec<u32>,
}

/// How cells are stored.
pub enum Kind {
    /// Every cell: cell k holds the particles `starts[k] .. starts[k + 1]`.
    Dense {
        /// One more than there are cells.
        starts: Vec<u32>,
    },
    /// Only occupied cells: the k-th of them is cell `keys[k]` = row · columns + column
    /// and holds the particles `starts[k] .. starts[k + 1]`.
    Sparse {
        /// Ascending.
        keys: Vec<u64>,
        /// One more than there are keys.
        starts: Vec<u32>,
    },
}

impl Cells {
    /// Number of cells stored.
    pub fn len(&self) -> usize {
        self.starts().len() - 1
    }

    /// Whether no cell is stored: before the first sort.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    fn starts(&self) -> &[u32] {
        match &self.kind {
            Kind::Dense { starts } | Kind::Sparse { starts, .. } => starts,
        }
    }

    /// The particles of the k-th stored cell.
    #[inline]
    pub fn own(&self, k: usize) -> Range<usize> {
        let starts = self.starts();
        starts[k] as usize..starts[k + 1] as usize
    }

    /// The particles of cells `left ..= right` of a row.
    #[inline(always)]
    pub fn in_row(&self, row: u32, left: u32, right: u32) -> Range<usize> {
        let first = u64::from(row) * u64::from(self.grid.columns);
        let last = first + u64::from(right);
        let first = first + u64::from(left);
        match &self.kind {
            Kind::Dense { starts } => {
                starts[first as usize] as usize..starts[last as usize + 1] as usize
            }
            Kind::Sparse { keys, starts } => {
                let begin = keys.partition_point(|&key| key < first);
                let end = begin + keys[begin..].iter().take_while(|&&key| key <= last).count();
                starts[begin] as usize..starts[end] as usize
            }
        }
    }

    /// Row and column of the k-th stored cell.
    #[inline]
    pub fn row_and_column(&self, k: usize) -> (u32, u32) {
        let key = match &self.kind {
            Kind::Dense { .. } => k as u64,
            Kind::Sparse { keys, .. } => keys[k],
        };
        let columns = u64::from(self.grid.columns);
        ((key / columns) as u32, (key % columns) as u32)
    }

    /// The particles of a cell's three rows of three: below, its own, above.
    pub fn around(&self, k: usize) -> [Range<usize>; 3] {
        let (row, column) = self.row_and_column(k);
        let left = column.saturating_sub(1);
        let right = (column + 1).min(self.grid.columns - 1);
        let row_of = |row: Option<u32>| match row {
            Some(row) if row < self.grid.rows => self.in_row(row, left, right),
            _ => 0..0,
        };
        [row_of(row.checked_sub(1)), row_of(Some(row)), row_of(Some(row + 1))]
    }

    /// The particles ahead of particle `i`: those that follow it in its own cell and those of the right
    /// neighbour, one range, and those of the three cells next to its own in the next row, another. So every
    /// pair in the same or in adjacent cells is met once, from the particle that comes first.
    #[inline(always)]
    pub fn ahead(&self, i: usize) -> [Range<usize>; 2] {
        let k = self.home[i] as usize;
        match &self.kind {
            Kind::Dense { starts } => {
                // The last column and the last row are empty: there is always a next one, and
                // left of the first column is the last one.
                let width = self.grid.columns as usize;
                let next = starts[k + width - 1] as usize..starts[k + width + 2] as usize;
                [i + 1..starts[k + 2] as usize, next]
            }
            Kind::Sparse { keys, .. } => self.ahead_of(keys[k], i),
        }
    }

    /// [`ahead`](Self::ahead) of particle `i` in cell number `key`, where not all cells are stored.
    #[inline(never)]
    fn ahead_of(&self, key: u64, i: usize) -> [Range<usize>; 2] {
        let columns = u64::from(self.grid.columns);
        let row = (key / columns) as u32;
        let column = (key % columns) as u32;
        let own = self.in_row(row, column, column + 1);
        [i + 1..own.end, self.in_row(row + 1, column.saturating_sub(1), column + 1)]
    }

    /// The particles of all cells that touch the rectangle [left, right, bottom, top], row by row.
    #[inline(always)]
    pub fn rows_of(&self, rectangle: &[f64; 4]) -> Rows {
        let [left, right, bottom, top] = *rectangle;
        Rows {
            left: self.grid.column(left),
            right: self.grid.column(right),
            row: self.grid.row(bottom),
            last: self.grid.row(top),
        }
    }

    /// Ranges of stored cells that hold about `target` particles each: pieces of work. They
    /// depend on the scene alone.
    pub fn pieces(&self, target: usize) -> Vec<Range<usize>> {
        let starts = self.starts();
        let n = starts.last().map_or(0, |&n| n as usize);
        let mut begin = 0;
        let pieces = (1..=n.div_ceil(target)).map(|k| {
            let end = starts.partition_point(|&start| (start as usize) < (k * target).min(n));
            std::mem::replace(&mut begin, end)..end
        });
        pieces.filter(|piece| !piece.is_empty()).collect()
    }

    /// The particles of a range of stored cells.
    pub fn particles(&self, cells: &Range<usize>) -> Range<usize> {
        let starts = self.starts();
        starts[cells.start] as usize..starts[cells.end] as usize
    }
}

/// A walk through the rows of a rectangle of cells.
pub struct Rows {
    left: u32,
    right: u32,
    row: u32,
    last: u32,
}

impl Rows {
    /// The particles of the next row.
    #[inline(always)]
    pub fn next(&mut self, cells: &Cells) -> Option<Range<usize>> {
        if self.row > self.last {
            return None;
        }
        if let Kind::Sparse { keys, .. } = &cells.kind {
            // Rows without a particle are stepped over, however many they are.
            let columns = u64::from(cells.grid.columns);
            let from = u64::from(self.row) * columns + u64::from(self.left);
            let key = keys.get(keys.partition_point(|&key| key < from))?;
            self.row = (key / columns) as u32;
            if self.row > self.last {
                return None;
            }
        }
        self.row += 1;
        Some(cells.in_row(self.row - 1, self.left, self.right))
    }
}
