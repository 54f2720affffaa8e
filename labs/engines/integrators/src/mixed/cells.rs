//! Particles whose positions are relative to their cell.

use common::soft::{CUTOFF, Particle};
use neighbour_list::{Cells, Extent, Grid, Kind};
use solution1::bounce;

use super::position::Position;

/// A particle with its position in single precision and its velocity in double precision.
#[derive(Clone, Copy)]
pub(super) struct Body {
    pub(super) position: Position,
    pub(super) vx: f64,
    pub(super) vy: f64,
    pub(super) id: u32,
}

/// A box that is divided into cells.
#[derive(Clone, Copy)]
pub(super) struct CellBox {
    size: f64,
    grid: Grid,
}

impl CellBox {
    /// Divides a box of side `size` into cells.
    pub(super) fn new(size: f64) -> Self {
        let extent = Extent { left: 0.0, bottom: 0.0, width: size, height: size };
        // Cells are slightly larger than the cutoff, because rounding to single precision may move
        // the particles of a pair apart.
        Self { size, grid: Grid::new(&extent, CUTOFF * (1.0 + 1e-5)) }
    }

    /// Returns the side of a cell in single precision.
    pub(super) fn side(&self) -> f32 {
        single(self.grid.side())
    }

    /// Converts a particle of the scene.
    pub(super) fn enter(&self, p: &Particle) -> Body {
        let (column, x) = self.split(p.x);
        let (row, y) = self.split(p.y);
        Body { position: Position { column, row, x, y }, vx: p.vx, vy: p.vy, id: p.id }
    }

    /// Converts a particle back.
    pub(super) fn leave(&self, body: &Body) -> Particle {
        let Body { position: Position { column, row, x, y }, vx, vy, id } = *body;
        Particle { x: self.join(column, x), y: self.join(row, y), vx, vy, id }
    }

    /// Returns the particle after a kick with the acceleration (`ax`, `ay`) and a drift, both for a
    /// time `dt`.
    pub(super) fn advance(&self, body: &Body, ax: f64, ay: f64, dt: f64) -> Body {
        let Body { position: Position { column, row, x, y }, vx, vy, id } = *body;
        let (column, x, vx) = self.drift(column, x, vx + ax * dt, dt);
        let (row, y, vy) = self.drift(row, y, vy + ay * dt, dt);
        Body { position: Position { column, row, x, y }, vx, vy, id }
    }

    /// Moves one coordinate for a time `dt`. Returns the cell, the position in the cell, and the
    /// velocity.
    fn drift(&self, cell: u32, x: f32, v: f64, dt: f64) -> (u32, f32, f64) {
        let side = self.grid.side();
        let x = f64::from(x) + v * dt;
        let cells = (x / side).floor();
        let next = f64::from(cell) + cells;
        if next >= 1.0 && next + 2.0 < f64::from(self.grid.columns) {
            return (next as u32, single(x - cells * side), v);
        }
        let (x, v) = bounce(f64::from(cell) * side + x, v, self.size);
        let (cell, x) = self.split(x);
        (cell, x, v)
    }

    /// Returns the cell of a coordinate, and the position in the cell.
    fn split(&self, x: f64) -> (u32, f32) {
        let side = self.grid.side();
        let cell = ((x / side) as u32).min(self.grid.columns - 1);
        (cell, single(x - f64::from(cell) * side))
    }

    /// Returns the coordinate of a position in a cell.
    fn join(&self, cell: u32, x: f32) -> f64 {
        // Rounding may move a particle beyond the wall.
        (f64::from(cell) * self.grid.side() + f64::from(x)).clamp(0.0, self.size)
    }

    /// Sorts particles by cell, row by row.
    pub(super) fn sort(&self, bodies: &mut [Body]) -> Cells {
        let columns = u64::from(self.grid.columns);
        let key =
            |body: &Body| u64::from(body.position.row) * columns + u64::from(body.position.column);
        // Particles are nearly sorted from the last step, and a merge sort takes advantage of that.
        bodies.sort_by_key(key);
        let kind = if self.grid.is_dense(bodies.len()) {
            let mut starts = vec![0; self.grid.cells() as usize + 1];
            bodies.iter().for_each(|body| starts[key(body) as usize + 1] += 1);
            (1..starts.len()).for_each(|k| starts[k] += starts[k - 1]);
            Kind::Dense { starts }
        } else {
            let mut keys = Vec::new();
            let mut starts = Vec::new();
            for (i, body) in bodies.iter().enumerate() {
                if keys.last() != Some(&key(body)) {
                    keys.push(key(body));
                    starts.push(i as u32);
                }
            }
            starts.push(bodies.len() as u32);
            Kind::Sparse { keys, starts }
        };
        Cells { grid: self.grid, kind, home: Vec::new() }
    }
}

/// Converts to single precision. The result is finite even in a box so wide that its cells are
/// wider than a cutoff.
fn single(length: f64) -> f32 {
    length.min(f64::from(f32::MAX)) as f32
}
