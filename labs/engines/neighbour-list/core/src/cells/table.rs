//! A table with the range of sorted particles in each cell.

use std::ops::Range;

use super::grid::Grid;

/// The cells of sorted particles.
///
/// Cells are numbered row by row, so the particles of a cell and of its right neighbour are
/// adjacent in memory.
pub struct Cells {
    /// The grid of these cells.
    pub grid: Grid,
    /// The stored cells: all cells, or only the occupied cells.
    pub kind: Kind,
    /// The index of each particle's cell among the stored cells.
    pub home: Vec<u32>,
}

/// The cells that are stored.
pub enum Kind {
    /// All cells: cell k contains the particles `starts[k] .. starts[k + 1]`.
    Dense {
        /// Index of the first particle of each cell, and at the end the number of particles.
        starts: Vec<u32>,
    },
    /// Only the occupied cells. The k-th occupied cell is cell `keys[k]` = row · columns + column.
    /// It contains the particles `starts[k] .. starts[k + 1]`.
    Sparse {
        /// The numbers of the occupied cells, ascending.
        keys: Vec<u64>,
        /// Index of the first particle of each occupied cell, and at the end the number of
        /// particles.
        starts: Vec<u32>,
    },
}

impl Cells {
    /// Returns the number of stored cells.
    pub fn len(&self) -> usize {
        self.starts().len() - 1
    }

    /// Whether no cell is stored, as before the first sort.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    fn starts(&self) -> &[u32] {
        match &self.kind {
            Kind::Dense { starts } | Kind::Sparse { starts, .. } => starts,
        }
    }

    /// Returns the particles of the k-th stored cell.
    #[inline]
    pub fn own(&self, k: usize) -> Range<usize> {
        let starts = self.starts();
        starts[k] as usize..starts[k + 1] as usize
    }

    /// Returns the particles of the cells in columns `left ..= right` of a row.
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

    /// Returns the row and the column of the k-th stored cell.
    #[inline]
    pub fn row_and_column(&self, k: usize) -> (u32, u32) {
        let key = match &self.kind {
            Kind::Dense { .. } => k as u64,
            Kind::Sparse { keys, .. } => keys[k],
        };
        let columns = u64::from(self.grid.columns);
        ((key / columns) as u32, (key % columns) as u32)
    }

    /// Returns the particles of the k-th stored cell and of the eight cells around it, one range
    /// for each row.
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

    /// Returns the particles ahead of particle `i`, in two ranges.
    ///
    /// ```text
    /// row + 1    [ a ][ b ][ c ]    second range: particles of a, b and c
    /// row             [ i ][ r ]    first range: particles after i in its cell, and r
    /// ```
    ///
    /// Every pair in the same cell or in adjacent cells is thus found once, from the particle that
    /// comes first.
    #[inline(always)]
    pub fn ahead(&self, i: usize) -> [Range<usize>; 2] {
        let k = self.home[i] as usize;
        match &self.kind {
            Kind::Dense { starts } => {
                // The last column and the last row are empty. So every cell has a row above it, and
                // the cell before the first cell of a row is the empty last cell of the previous
                // row.
                let width = self.grid.columns as usize;
                let next = starts[k + width - 1] as usize..starts[k + width + 2] as usize;
                [i + 1..starts[k + 2] as usize, next]
            }
            Kind::Sparse { keys, .. } => self.ahead_of(keys[k], i),
        }
    }

    /// Computes [`ahead`](Self::ahead) for particle `i` in cell `key`, if only occupied cells are
    /// stored.
    #[inline(never)]
    fn ahead_of(&self, key: u64, i: usize) -> [Range<usize>; 2] {
        let columns = u64::from(self.grid.columns);
        let row = (key / columns) as u32;
        let column = (key % columns) as u32;
        let own = self.in_row(row, column, column + 1);
        [i + 1..own.end, self.in_row(row + 1, column.saturating_sub(1), column + 1)]
    }

    /// Returns the rows of cells that touch the rectangle [left, right, bottom, top].
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

    /// Divides the stored cells into ranges with about `target` particles each.
    ///
    /// The ranges depend on the scene only, not on the number of threads.
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

    /// Returns the particles of a range of stored cells.
    pub fn particles(&self, cells: &Range<usize>) -> Range<usize> {
        let starts = self.starts();
        starts[cells.start] as usize..starts[cells.end] as usize
    }
}

/// An iterator over the rows of a rectangle of cells. The iterator does not borrow the [`Cells`],
/// which are an argument of [`next`](Self::next).
pub struct Rows {
    left: u32,
    right: u32,
    row: u32,
    last: u32,
}

impl Rows {
    /// Returns the particles of the next row, or `None` after the last row.
    #[inline(always)]
    pub fn next(&mut self, cells: &Cells) -> Option<Range<usize>> {
        if self.row > self.last {
            return None;
        }
        if let Kind::Sparse { keys, .. } = &cells.kind {
            // Rows without particles are skipped in one step, because there may be very many such
            // rows.
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
