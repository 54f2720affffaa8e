//! Squares over the part of the box where particles are.

use workers::Workers;

use crate::particles::Bodies;

/// A grid of square cells over the rectangle that holds all particles.
///
/// Two particles no further apart than [`Grid::side`] are in the same or in adjacent cells. The last
/// column and the last row are empty: a walk over the cells around need not ask whether a cell
/// is at the edge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grid {
    left: f64,
    bottom: f64,
    side: f64,
    inverse: f64,
    /// Cells along x, with the empty one.
    pub columns: u32,
    /// Cells along y, with the empty one.
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
    /// The extent of `bodies`.
    pub fn of(bodies: &Bodies) -> Self {
        Self::among(bodies, &Workers::default())
    }

    /// The same by many threads.
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

/// Eight at a time: one after another each comparison would wait for the one before.
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
    /// Cells of at least `side` over `extent`.
    ///
    /// A little is added, so that rounding cannot put two particles at distance `side` two cells
    /// apart; and cells grow where there would be more than fit a 31-bit row or column.
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

    /// Length of a cell's side.
    pub fn side(&self) -> f64 {
        self.side
    }

    /// Number of cells.
    pub fn cells(&self) -> u64 {
        u64::from(self.columns) * u64::from(self.rows)
    }

    /// Whether all cells may be stored, for `n` particles: there are not many more empty ones.
    pub fn is_dense(&self, n: usize) -> bool {
        self.cells() <= 8 * n as u64 + 64
    }

    /// The column of coordinate `x`; outside the grid the nearest one.
    #[inline(always)]
    pub fn column(&self, x: f64) -> u32 {
        (((x - self.left) * self.inverse) as u32).min(self.columns - 2)
    }

    /// The row of coordinate `y`; outside the grid the nearest one.
    #[inline(always)]
    pub fn row(&self, y: f64) -> u32 {
        (((y - self.bottom) * self.inverse) as u32).min(self.rows - 2)
    }
}
