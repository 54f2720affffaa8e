//! The grid of square cells that covers the particles.

use workers::Workers;

use crate::particles::Bodies;

/// A grid of square cells over the rectangle that contains all particles.
///
/// Two particles at most [`Grid::side`] apart are in the same cell or in adjacent cells. The last
/// column and the last row are empty, so a loop over adjacent cells never has to test whether a
/// cell is at the edge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grid {
    left: f64,
    bottom: f64,
    side: f64,
    inverse: f64,
    /// Number of columns, including the empty column.
    pub columns: u32,
    /// Number of rows, including the empty row.
    pub rows: u32,
}

/// The smallest rectangle around all particles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extent {
    /// Least x.
    pub left: f64,
    /// Least y.
    pub bottom: f64,
    /// Greatest x − least x.
    pub width: f64,
    /// Greatest y − least y.
    pub height: f64,
}

impl Extent {
    /// Returns the extent of `bodies`.
    pub fn of(bodies: &Bodies) -> Self {
        Self::among(bodies, &Workers::default())
    }

    /// Returns the extent of `bodies`, computed by the threads of `workers`.
    pub fn among(bodies: &Bodies, workers: &Workers) -> Self {
        const PIECE: usize = 1 << 15;
        let pieces = bodies.x.chunks(PIECE).zip(bodies.y.chunks(PIECE)).collect();
        let bounds = workers.map(pieces, |(x, y)| [least_and_most(x), least_and_most(y)]);
        let [mut x, mut y] = [(f64::MAX, f64::MIN); 2];
        for [of_x, of_y] in bounds {
            x = (of_x.0.min(x.0), of_x.1.max(x.1));
            y = (of_y.0.min(y.0), of_y.1.max(y.1));
        }
        Self { left: x.0, bottom: y.0, width: x.1 - x.0, height: y.1 - y.0 }
    }
}

/// Returns the least and the greatest of `values`.
///
/// There are eight partial results. With a single result, each comparison would wait for the
/// previous comparison.
fn least_and_most(values: &[f64]) -> (f64, f64) {
    let mut least = [f64::MAX; 8];
    let mut most = [f64::MIN; 8];
    let eights = values.chunks_exact(8);
    let rest = eights.remainder().iter().enumerate();
    for eight in eights {
        for l in 0..8 {
            least[l] = if eight[l] < least[l] { eight[l] } else { least[l] };
            most[l] = if eight[l] > most[l] { eight[l] } else { most[l] };
        }
    }
    for (l, &value) in rest {
        least[l] = least[l].min(value);
        most[l] = most[l].max(value);
    }
    (least.into_iter().fold(f64::MAX, f64::min), most.into_iter().fold(f64::MIN, f64::max))
}

impl Grid {
    /// Makes a grid over `extent` whose cells have at least this `side`.
    ///
    /// The side is enlarged slightly, so that rounding cannot put two particles at distance `side`
    /// two cells apart. The side is enlarged further if there would be more rows or columns than a
    /// 31-bit number can count.
    pub fn new(extent: &Extent, side: f64) -> Self {
        const MOST: f64 = 1e9;
        let side = (side * (1.0 + 1e-6)).max(extent.width.max(extent.height) / MOST);
        let count = |length: f64| (length / side) as u32 + 2;
        Self {
            left: extent.left,
            bottom: extent.bottom,
            side,
            inverse: 1.0 / side,
            columns: count(extent.width),
            rows: count(extent.height),
        }
    }

    /// Returns the length of a cell's side.
    pub fn side(&self) -> f64 {
        self.side
    }

    /// Returns the number of cells.
    pub fn cells(&self) -> u64 {
        u64::from(self.columns) * u64::from(self.rows)
    }

    /// Whether the grid has so few empty cells, for `n` particles, that all cells can be stored.
    pub fn is_dense(&self, n: usize) -> bool {
        self.cells() <= 8 * n as u64 + 64
    }

    /// Returns the column of coordinate `x`, or the nearest column if `x` is outside the grid.
    #[inline(always)]
    pub fn column(&self, x: f64) -> u32 {
        (((x - self.left) * self.inverse) as u32).min(self.columns - 2)
    }

    /// Returns the row of coordinate `y`, or the nearest row if `y` is outside the grid.
    #[inline(always)]
    pub fn row(&self, y: f64) -> u32 {
        (((y - self.bottom) * self.inverse) as u32).min(self.rows - 2)
    }
}
