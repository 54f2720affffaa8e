//! Single precision where it is enough: positions are relative to their cell.
//!
//! In a box of 10⁸ cutoffs, single precision has too few digits for the distance between two
//! neighbours. A position relative to a cell of one cutoff has seven digits, in every cell.
//! Distances and forces are computed from such positions. Sums, velocities and moves are in double
//! precision.

mod cells;
mod position;

use common::soft::{CUTOFF, DT, MASS, MIN_R, Particle, Scene, Simulation};
use neighbour_list::Workers;

use cells::{Body, CellBox};
use position::vector;

/// Approximate number of particles in a piece of work.
const PIECE: usize = 1024;

/// The engine with positions in single precision, and sums and velocities in double precision.
pub struct Mixed {
    workers: Workers,
    divide: u32,
    cells: CellBox,
    bodies: Vec<Body>,
}

impl Mixed {
    /// Makes an engine for `threads` threads. Each official step is divided into `divide` small
    /// steps.
    pub fn new(threads: usize, divide: u32) -> Self {
        Self {
            workers: Workers::if_possible(threads),
            divide,
            cells: CellBox::new(1.0),
            bodies: Vec::new(),
        }
    }

    fn one_step(&mut self, dt: f64) {
        let sorted = self.cells.sort(&mut self.bodies);
        let Self { bodies, cells, .. } = self;
        let side = cells.side();
        let moved = self.workers.map(sorted.pieces(PIECE), |piece| {
            let mut moved = Vec::with_capacity(sorted.particles(&piece).len());
            for k in piece.filter(|&k| !sorted.own(k).is_empty()) {
                let rows = sorted.around(k);
                for body in &bodies[sorted.own(k)] {
                    let mut ax = 0.0_f64;
                    let mut ay = 0.0_f64;
                    for j in rows.iter().cloned().flatten() {
                        let (dx, dy) = vector(&body.position, &bodies[j].position, side);
                        let coef = coefficient(dx * dx + dy * dy);
                        ax += f64::from(coef * dx);
                        ay += f64::from(coef * dy);
                    }
                    moved.push(cells.advance(body, ax, ay, dt));
                }
            }
            moved
        });
        self.bodies = moved.concat();
    }
}

/// Returns the factor of the pair acceleration, in single precision; 0 beyond the cutoff.
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
        self.cells = CellBox::new(scene.size());
        self.bodies = scene.particles().iter().map(|p| self.cells.enter(p)).collect();
    }

    fn step(&mut self) {
        for _ in 0..self.divide {
            self.one_step(DT / f64::from(self.divide));
        }
    }

    fn read(&self, first: usize, out: &mut [Particle]) {
        for body in &self.bodies {
            let index = (body.id as usize).checked_sub(first);
            if let Some(slot) = index.and_then(|index| out.get_mut(index)) {
                *slot = self.cells.leave(body);
            }
        }
    }
}
