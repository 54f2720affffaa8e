//! Which particles stand in which cell, when particles are sorted by cell.

use std::ops::Range;

use super::grid::Grid;

/// A visitor that looks ahead of each particle.
///
/// A closure would do, but the compiler may leave a closure outside a vector kernel, where it is
/// translated for the oldest processor. A method can be told to go in.
pub trait Ahead {
    /// Particle `i` and the particles ahead of it: `i + 1 .. end` and `next`.
    fn visit(&mut self, i: usize, end: usize, next: Range<usize>);
}

/// The places of a sorted order, cell by cell. Cells run along x first: the particles of a cell and
/// of its right neighbour are next to each other in memory.
pub struct Cells {
    /// Where the cells lie.
    pub grid: Grid,
    /// How the cells are stored.
    pub kind: Kind,
    /// The cell of each particle, if every cell is stored.
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

    /// Visits every particle in the stored cells of `range` with the particles ahead of it, so that
    /// every pair in the same or in adjacent cells is met from one side only: what follows it in
    /// its own cell and the right neighbour, one range, and the three cells of the next row,
    /// another.
    #[inline(always)]
    pub fn for_each_ahead(&self, range: Range<usize>, visitor: &mut impl Ahead) {
        let Grid { columns, rows, .. } = self.grid;
        match &self.kind {
            Kind::Dense { starts } => {
                let width = columns as usize;
                for i in self.particles(&range) {
                    // The last column and the last row are empty: there is always a next one, and
                    // left of the first column is the last one.
                    let k = self.home[i] as usize;
                    let next = starts[k + width - 1] as usize..starts[k + width + 2] as usize;
                    visitor.visit(i, starts[k + 2] as usize, next);
                }
            }
            Kind::Sparse { keys, starts } => {
                for k in range {
                    let (row, column) = self.place(k);
                    let joined = keys.get(k + 1) == Some(&(keys[k] + 1));
                    let next = if row + 1 < rows {
                        self.in_row(row + 1, column.saturating_sub(1), column + 1)
                    } else {
                        0..0
                    };
                    let end = starts[k + 1 + usize::from(joined)] as usize;
                    for i in self.own(k) {
                        visitor.visit(i, end, next.clone());
                    }
                }
            }
        }
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
        let mut pieces = Vec::new();
        let mut begin = 0;
        while begin < self.len() {
            let enough = starts[begin] + target as u32;
            // Mostly not far from here, so not halving all cells each time.
            let mut far = target.max(1);
            while starts.get(begin + far).is_some_and(|&start| start < enough) {
                far *= 2;
            }
            let last = self.len().min(begin + far);
            let end = begin + 1 + starts[begin + 1..last].partition_point(|&s| s < enough);
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
