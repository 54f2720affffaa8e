//! Ways to go through time: the official step, velocity Verlet, PEFRL and Runge-Kutta.
//!
//! They differ in how often they ask for forces in a step and in how the error shrinks with the
//! step. On a force as rough as ours, which has a corner at the cutoff, a high order does not
//! keep its reproducibility: each pair that crosses the cutoff within a step costs it.

use common::soft::{CUTOFF, DT, NoStatistics, Particle, Scene, Simulation};
use solution1::bounce;

use crate::{BATCH, Bodies, Contacts, Extent, Grid, Sorter, Workers};

/// How a step is taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// A kick, then a drift: the official step.
    SymplecticEuler,
    /// Half a kick, a drift, half a kick.
    VelocityVerlet,
    /// Position Extended Forest-Ruth Like (Omelyan, Mryglod and Folk 2002).
    Pefrl,
    /// The classical fourth-order method of Runge and Kutta.
    RungeKutta,
}

/// The engine of the integrator variants.
pub struct Integrated {
    method: Method,
    divide: u32,
    stretch: f64,
    size: f64,
    bodies: Bodies,
    field: Field,
    evaluations: u64,
}

/// Accelerations of all particles at given places.
struct Field {
    workers: Workers,
    sorter: Sorter,
    stand: Bodies,
    sorted: Bodies,
    ax: Vec<f64>,
    ay: Vec<f64>,
}

impl Field {
    /// Computes the accelerations at places `x`, `y`.
    fn at(&mut self, x: &[f64], y: &[f64]) {
        let n = x.len();
        self.stand.resize(n);
        self.stand.x.copy_from_slice(x);
        self.stand.y.copy_from_slice(y);
        for (i, id) in self.stand.id.iter_mut().enumerate() {
            *id = i as u32;
        }
        let extent = Extent::of(&self.stand);
        let grid = Grid::new(&extent, CUTOFF);
        let dense = grid.cells() <= 16 * n as u64 + 64;
        let cells =
            self.sorter.sort(&self.stand, &mut self.sorted, grid, dense, 0.0, &self.workers);
        let sorted = &self.sorted;
        let results = self.workers.map(cells.pieces(1024), |piece| {
            let particles = cells.particles(&piece);
            let (mut ax, mut ay) = (vec![0.0; particles.len()], vec![0.0; particles.len()]);
            let mut contacts = Contacts::default();
            for k in piece {
                let own = cells.own(k);
                if own.is_empty() {
                    continue;
                }
                let rows = cells.around(k);
                for i in own {
                    for row in &rows {
                        for from in row.clone().step_by(BATCH) {
                            if contacts.is_full() {
                                contacts.settle(&mut ax, &mut ay, &mut NoStatistics);
                            }
                            for j in from..(from + BATCH).min(row.end) {
                                let (dx, dy) =
                                    (sorted.x[j] - sorted.x[i], sorted.y[j] - sorted.y[i]);
                                contacts.offer((i - particles.start) as u32, dx, dy);
                            }
                        }
                    }
                }
            }
            contacts.settle(&mut ax, &mut ay, &mut NoStatistics);
            (particles, ax, ay)
        });
        self.ax.resize(n, 0.0);
        self.ay.resize(n, 0.0);
        for (particles, ax, ay) in results {
            for ((i, ax), ay) in particles.zip(ax).zip(ay) {
                let id = sorted.id[i] as usize;
                (self.ax[id], self.ay[id]) = (ax, ay);
            }
        }
    }
}

impl Integrated {
    /// An engine for `threads` threads whose step is `stretch` official ones, done in `divide`.
    pub fn new(threads: usize, method: Method, divide: u32, stretch: f64) -> Self {
        let field = Field {
            workers: Workers::new(threads),
            sorter: Sorter::default(),
            stand: Bodies::default(),
            sorted: Bodies::default(),
            ax: Vec::new(),
            ay: Vec::new(),
        };
        let bodies = Bodies::default();
        Self { method, divide, stretch, size: 0.0, bodies, field, evaluations: 0 }
    }

    /// x += v dt, with the walls.
    fn drift(&mut self, dt: f64) {
        let Bodies { x, y, vx, vy, .. } = &mut self.bodies;
        for (x, v) in x.iter_mut().zip(vx).chain(y.iter_mut().zip(vy)) {
            (*x, *v) = bounce(*x + *v * dt, *v, self.size);
        }
    }

    /// v += a dt, with the forces where everybody is.
    fn kick(&mut self, dt: f64) {
        let Bodies { x, y, vx, vy, .. } = &mut self.bodies;
        self.field.at(x, y);
        self.evaluations += 1;
        let kicks = vx.iter_mut().zip(&self.field.ax).chain(vy.iter_mut().zip(&self.field.ay));
        for (v, a) in kicks {
            *v += a * dt;
        }
    }

    /// One step of a composition: drifts and kicks by turns, as fractions of `dt`.
    fn compose(&mut self, drifts: &[f64], kicks: &[f64], dt: f64) {
        todo!("task 10.10: a step of drifts and kicks")
    }

    /// One step of the classical Runge-Kutta method. Its stages may lie beyond a wall; the step
    /// as a whole is reflected.
    fn runge_kutta(&mut self, dt: f64) {
        let n = self.bodies.len();
        let start = self.bodies.clone();
        let mut sum = [vec![0.0; n], vec![0.0; n], vec![0.0; n], vec![0.0; n]];
        let mut stage = start.clone();
        for (weight, next) in [(1.0, 0.5), (2.0, 0.5), (2.0, 1.0), (1.0, 0.0)] {
            self.field.at(&stage.x, &stage.y);
            self.evaluations += 1;
            for i in 0..n {
                let slope = [stage.vx[i], stage.vy[i], self.field.ax[i], self.field.ay[i]];
                for (sum, slope) in sum.iter_mut().zip(slope) {
                    sum[i] += weight * slope;
                }
                stage.x[i] = start.x[i] + next * dt * slope[0];
                stage.y[i] = start.y[i] + next * dt * slope[1];
                stage.vx[i] = start.vx[i] + next * dt * slope[2];
                stage.vy[i] = start.vy[i] + next * dt * slope[3];
            }
        }
        let [sum_x, sum_y, sum_vx, sum_vy] = &sum;
        for i in 0..n {
            let [x, y, vx, vy] = [sum_x, sum_y, sum_vx, sum_vy].map(|sum| sum[i] * dt / 6.0);
            (self.bodies.x[i], self.bodies.vx[i]) =
                bounce(start.x[i] + x, start.vx[i] + vx, self.size);
            (self.bodies.y[i], self.bodies.vy[i]) =
                bounce(start.y[i] + y, start.vy[i] + vy, self.size);
        }
    }
}

impl Simulation for Integrated {
    fn load(&mut self, scene: &Scene) {
        (self.size, self.bodies, self.evaluations) = (scene.size(), Bodies::of(scene), 0);
    }

    fn step(&mut self) {
        const XI: f64 = 0.178_617_895_844_809_1;
        const LAMBDA: f64 = -0.212_341_831_062_605_4;
        const CHI: f64 = -0.066_264_582_669_818_5;
        const SIDE: f64 = (1.0 - 2.0 * LAMBDA) / 2.0;
        let dt = self.stretch * DT / f64::from(self.divide);
        for _ in 0..self.divide {
            match self.method {
                Method::SymplecticEuler => self.compose(&[0.0, 1.0], &[1.0], dt),
                Method::VelocityVerlet => self.compose(&[0.0, 1.0, 0.0], &[0.5, 0.5], dt),
                Method::Pefrl => self.compose(
                    &[XI, CHI, 1.0 - 2.0 * (CHI + XI), CHI, XI],
                    &[SIDE, LAMBDA, LAMBDA, SIDE],
                    dt,
                ),
                Method::RungeKutta => self.runge_kutta(dt),
            }
        }
    }

    fn read(&self, first: usize, out: &mut [Particle]) {
        self.bodies.read(first, out);
    }

    fn counters(&self) -> Vec<(&'static str, f64)> {
        vec![("force evaluations", self.evaluations as f64)]
    }
}
