//! Which particles stand in which cell, when particles are sorted by cell.

use std::ops::Range;

use crate::Grid;

/// Somebody who looks at a cell and ahead of it.
///
/// A closure would do, but the compiler may leave a closure outside a vector kernel, where it is
/// translated for the oldest processor. A method can be told to go in.
pub(crate) trait Ahead {
    /// The particles of a cell, where those of its right neighbour end, those of the next row.
    fn visit(&mut self, own: Range<usize>, end: usize, next: Range<usize>);
}

/// The places of a sorted order, cell by cell. Cells run along x first: the particles of a cell and
/// of its right neighbour are next to each other in memory.
pub struct Cells {
    /// Where the cells lie.
    pub grid: Grid,
    /// How the cells are stored.
    pub kind: Kind,
}

/// How cells are stored.
pub enum Kind {
    /// Every cell: cell k holds the particles `starts[k] .. starts[k + 1]`.
    Dense {
        /// One more than there are cells.
        starts: Vec<u32>,
    },
    /// Only cells that hold somebody: the k-th of them is cell `keys[k]` = row · columns + column
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
    #[inline]
    pub fn in_row(&self, row: u32, left: u32, right: u32) -> Range<usize> {
        let first = u64::from(row) * u64::from(self.grid.columns);
        let (first, last) = (first + u64::from(left), first + u64::from(right));
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
    pub fn place(&self, k: usize) -> (u32, u32) {
        let key = match &self.kind {
            Kind::Dense { .. } => k as u64,
            Kind::Sparse { keys, .. } => keys[k],
        };
        let columns = u64::from(self.grid.columns);
        ((key / columns) as u32, (key % columns) as u32)
    }

    /// The particles of a cell's three rows of three: below, its own, above.
    pub fn around(&self, k: usize) -> [Range<usize>; 3] {
        let (row, column) = self.place(k);
        let (left, right) = (column.saturating_sub(1), (column + 1).min(self.grid.columns - 1));
        let row_of = |row: Option<u32>| match row {
            Some(row) if row < self.grid.rows => self.in_row(row, left, right),
            _ => 0..0,
        };
        [row_of(row.checked_sub(1)), row_of(Some(row)), row_of(Some(row + 1))]
    }

    /// Visits the stored cells of `range` that hold somebody, each with the particles ahead of it,
    /// so that every pair of adjacent cells is met from one side only: where its right neighbour
    /// ends (whose particles follow the cell's own), and the three cells of the next row.
    #[inline(always)]
    pub(crate) fn for_each_ahead(&self, range: Range<usize>, visitor: &mut impl Ahead) {
        let Grid { columns, rows, .. } = self.grid;
        match &self.kind {
            Kind::Dense { starts } => {
                let width = columns as usize;
                let mut column = range.start % width;
                for k in range {
                    let own = starts[k] as usize..starts[k + 1] as usize;
                    if !own.is_empty() {
                        let right = usize::from(column + 1 < width);
                        let next = k + width;
                        let next = if next + 1 < starts.len() {
                            let left = usize::from(column > 0);
                            starts[next - left] as usize..starts[next + right + 1] as usize
                        } else {
                            0..0
                        };
                        visitor.visit(own, starts[k + 1 + right] as usize, next);
                    }
                    column = if column + 1 < width { column + 1 } else { 0 };
                }
            }
            Kind::Sparse { keys, starts } => {
                for k in range {
                    let (row, column) = self.place(k);
                    let right = column + 1 < columns;
                    let joined = right && keys.get(k + 1) == Some(&(keys[k] + 1));
                    let next = if row + 1 < rows {
                        self.in_row(row + 1, column.saturating_sub(1), column + u32::from(right))
                    } else {
                        0..0
                    };
                    visitor.visit(self.own(k), starts[k + 1 + usize::from(joined)] as usize, next);
                }
            }
        }
    }

    /// The particles of all cells that touch the rectangle, row by row.
    pub fn in_rectangle(&self, x: (f64, f64), y: (f64, f64), mut visit: impl FnMut(Range<usize>)) {
        let (left, right) = (self.grid.column(x.0), self.grid.column(x.1));
        let (mut row, last) = (self.grid.row(y.0), self.grid.row(y.1));
        while row <= last {
            if let Kind::Sparse { keys, .. } = &self.kind {
                // Rows without a particle are stepped over, however many they are.
                let columns = u64::from(self.grid.columns);
                let from = u64::from(row) * columns + u64::from(left);
                let Some(key) = keys.get(keys.partition_point(|&key| key < from)) else { return };
                row = (key / columns) as u32;
                if row > last {
                    return;
                }
            }
            visit(self.in_row(row, left, right));
            row += 1;
        }
    }

    /// Ranges of stored cells that hold about `target` particles each: pieces of work. They
    /// depend on the scene alone.
    pub fn pieces(&self, target: usize) -> Vec<Range<usize>> {
        let starts = self.starts();
        let mut pieces = Vec::new();
        let mut begin = 0;
        while begin < self.len() {
            let enough = starts[begin] + target as u32;
            let end = begin + 1 + starts[begin + 1..self.len()].partition_point(|&s| s < enough);
            pieces.push(begin..end);
            begin = end;
        }
        pieces
    }

    /// The particles of a range of stored cells.
    pub fn particles(&self, cells: &Range<usize>) -> Range<usize> {
        let starts = self.starts();
        starts[cells.start] as usize..starts[cells.end] as usize
    }
}
