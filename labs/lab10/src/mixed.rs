//! Single precision where it suffices: places relative to their cell.
//!
//! A place in a box of 10⁸ cutoffs has no digit left for the distance of two neighbours if it is
//! held in single precision. Relative to a cell of one cutoff it has seven, wherever the cell is.
//! Distances and forces are computed from those; sums, velocities and the move are in double.

use common::soft::{CUTOFF, DT, MASS, MIN_R, Particle, Scene, Simulation};
use solution1::bounce;

use crate::{Cells, Extent, Grid, Kind, Workers};

/// Particles in a piece of work, roughly.
const PIECE: usize = 1024;

/// Where a particle is: a cell, and the place from its lower left corner.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Place {
    /// The cell's column.
    pub column: u32,
    /// The cell's row.
    pub row: u32,
    /// From the cell's left edge, in units of length.
    pub x: f32,
    /// From the cell's lower edge.
    pub y: f32,
}

/// The vector from one place to another in the same or an adjacent cell, in single precision;
/// `side` is a cell's. Its error must not depend on where the cells are: take differences of
/// columns before anything is multiplied.
///
/// Book: chapter 10, *Seven digits*.
#[inline]
pub fn vector(from: &Place, to: &Place, side: f32) -> (f32, f32) {
    todo!("task 10.11: a distance across cells")
}

#[derive(Clone, Copy, Default)]
struct Body {
    place: Place,
    vx: f64,
    vy: f64,
    id: u32,
}

/// The engine of variant `mixed`.
pub struct Mixed {
    workers: Workers,
    divide: u32,
    size: f64,
    grid: Grid,
    bodies: Vec<Body>,
}

impl Mixed {
    /// An engine for `threads` threads, each official step divided into `divide`.
    pub fn new(threads: usize, divide: u32) -> Self {
        let extent = Extent { left: 0.0, bottom: 0.0, width: 1.0, height: 1.0 };
        let grid = Grid::new(&extent, CUTOFF);
        Self { workers: Workers::new(threads), divide, size: 1.0, grid, bodies: Vec::new() }
    }

    /// The cell of one coordinate, and the rest.
    fn split(&self, x: f64) -> (u32, f32) {
        let side = self.grid.side();
        let cell = ((x / side) as u32).min(self.grid.columns - 1);
        (cell, single(x - f64::from(cell) * side))
    }

    /// Moves one coordinate: (cell, place in it, velocity) after `dt`.
    fn advance(&self, cell: u32, x: f32, v: f64, dt: f64) -> (u32, f32, f64) {
        let side = self.grid.side();
        let place = f64::from(x) + v * dt;
        let cells = (place / side).floor();
        let next = f64::from(cell) + cells;
        if next >= 1.0 && next + 2.0 < f64::from(self.grid.columns) {
            return (next as u32, single(place - cells * side), v);
        }
        let (x, v) = bounce(f64::from(cell) * side + place, v, self.size);
        let (cell, x) = self.split(x);
        (cell, x, v)
    }

    /// Sorts the particles by cell, rows first.
    fn sort(&mut self) -> Cells {
        let columns = u64::from(self.grid.columns);
        let key = |body: &Body| u64::from(body.place.row) * columns + u64::from(body.place.column);
        // Nearly sorted as they are from the last step: a merge sort sees that.
        self.bodies.sort_by_key(key);
        let kind = if self.grid.cells() <= 8 * self.bodies.len() as u64 + 64 {
            let mut starts = vec![0; self.grid.cells() as usize + 1];
            self.bodies.iter().for_each(|body| starts[key(body) as usize + 1] += 1);
            (1..starts.len()).for_each(|k| starts[k] += starts[k - 1]);
            Kind::Dense { starts }
        } else {
            let (mut keys, mut starts) = (Vec::new(), Vec::new());
            for (i, body) in self.bodies.iter().enumerate() {
                if keys.last() != Some(&key(body)) {
                    keys.push(key(body));
                    starts.push(i as u32);
                }
            }
            starts.push(self.bodies.len() as u32);
            Kind::Sparse { keys, starts }
        };
        Cells { grid: self.grid, kind, home: Vec::new() }
    }

    fn one_step(&mut self, dt: f64) {
        let cells = self.sort();
        let (this, side) = (&*self, single(self.grid.side()));
        let moved = self.workers.map(cells.pieces(PIECE), |piece| {
            let mut moved = Vec::with_capacity(cells.particles(&piece).len());
            for k in piece.filter(|&k| !cells.own(k).is_empty()) {
                let rows = cells.around(k);
                for i in cells.own(k) {
                    let body = this.bodies[i];
                    let (mut ax, mut ay) = (0.0_f64, 0.0_f64);
                    for j in rows.iter().cloned().flatten() {
                        let (dx, dy) = vector(&body.place, &this.bodies[j].place, side);
                        let coef = coefficient(dx * dx + dy * dy);
                        ax += f64::from(coef * dx);
                        ay += f64::from(coef * dy);
                    }
                    let Place { column, row, x, y } = body.place;
                    let (column, x, vx) = this.advance(column, x, body.vx + ax * dt, dt);
                    let (row, y, vy) = this.advance(row, y, body.vy + ay * dt, dt);
                    moved.push(Body { place: Place { column, row, x, y }, vx, vy, id: body.id });
                }
            }
            moved
        });
        self.bodies = moved.concat();
    }
}

/// In single precision, finite even where a box is so wide that its cells are not cutoffs any more.
fn single(length: f64) -> f32 {
    length.min(f64::from(f32::MAX)) as f32
}

/// The factor of the pair acceleration, in single precision; 0 beyond the cutoff.
#[inline(always)]
fn coefficient(r2: f32) -> f32 {
    const C: f32 = CUTOFF as f32;
    const LEAST: f32 = (MIN_R * MIN_R) as f32;
    if r2 > C * C {
        return 0.0;
    }
    let r2 = if r2 > LEAST { r2 } else { LEAST };
    (1.0 - C / r2.sqrt()) / r2 / MASS as f32
}

impl Simulation for Mixed {
    fn load(&mut self, scene: &Scene) {
        self.size = scene.size();
        let extent = Extent { left: 0.0, bottom: 0.0, width: self.size, height: self.size };
        // Single precision may put a pair at the cutoff a little further apart.
        self.grid = Grid::new(&extent, CUTOFF * (1.0 + 1e-5));
        let body = |p: &Particle| {
            let ((column, x), (row, y)) = (self.split(p.x), self.split(p.y));
            Body { place: Place { column, row, x, y }, vx: p.vx, vy: p.vy, id: p.id }
        };
        self.bodies = scene.particles().iter().map(body).collect();
    }

    fn step(&mut self) {
        for _ in 0..self.divide {
            self.one_step(DT / f64::from(self.divide));
        }
    }

    fn read(&self, first: usize, out: &mut [Particle]) {
        let side = self.grid.side();
        for body in &self.bodies {
            let place = (body.id as usize).checked_sub(first);
            if let Some(slot) = place.and_then(|place| out.get_mut(place)) {
                // Rounding may put somebody at the wall beyond it.
                let at = |cell: u32, x: f32| {
                    (f64::from(cell) * side + f64::from(x)).clamp(0.0, self.size)
                };
                let Place { column, row, x, y } = body.place;
                *slot = Particle {
                    x: at(column, x),
                    y: at(row, y),
                    vx: body.vx,
                    vy: body.vy,
                    id: body.id,
                };
            }
        }
    }
}
