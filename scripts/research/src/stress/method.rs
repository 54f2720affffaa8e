//! The methods once more, written without the labs: what one step must do.
//!
//! A stress test must tell a limit of the method from a mistake of the program. So every step of a
//! program is compared with the same step here, all pairs, sorted along x.

use common::Vec2;
use common::soft::{CUTOFF, DT, Particle};
use oracle::reference::{Fineness, exact};
use oracle::{acceleration_of_pair, fold};

/// How a variant goes through time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Method {
    /// The official step, in so many parts.
    Euler {
        parts: u32,
    },
    /// The official step with distances in single precision.
    SinglePrecision,
    VelocityVerlet,
    Pefrl,
    RungeKutta,
    /// Runge-Kutta with located events: compared with the exact motion, where there is one.
    Located,
}

/// A state after one step, and the scale of each particle's rounding errors.
pub(super) struct Stepped {
    pub(super) particles: Vec<Particle>,
    /// The greatest sum of |a_ij| on the way.
    pub(super) magnitudes: Vec<f64>,
}

/// How far a program may be off after a step: |Δx| ≤ place · (1 + 100 dt² |a|), and the velocity
/// alike; and how much of the way itself, which is what rounding takes of those that fly far.
#[derive(Clone, Copy, Debug)]
pub(super) struct Allowed {
    pub(super) place: f64,
    pub(super) velocity: f64,
}

impl Method {
    /// That of a variant; a lab that does not choose takes the official step.
    pub(super) fn of(variant: &str) -> Self {
        match variant {
            "substep" => Self::Euler { parts: 10 },
            "mixed" => Self::SinglePrecision,
            "velocity-verlet" => Self::VelocityVerlet,
            "pefrl" => Self::Pefrl,
            "rk4" => Self::RungeKutta,
            "rk4-located" => Self::Located,
            _ => Self::Euler { parts: 1 },
        }
    }

    /// What rounding may do, by how long the chain of operations is.
    pub(super) fn allowed(self) -> Allowed {
        match self {
            Self::Euler { parts: 1 } => Allowed { place: 1e-13, velocity: 1e-12 },
            // A stage's rounding is seen by the force of the next one.
            Self::Euler { .. } | Self::VelocityVerlet | Self::Pefrl | Self::RungeKutta => {
                Allowed { place: 1e-11, velocity: 1e-9 }
            }
            // Seven digits of a cutoff, and a force whose slope is a million.
            Self::SinglePrecision => Allowed { place: 3e-7, velocity: 3e-4 },
            Self::Located => Allowed { place: 1e-5, velocity: 0.5 },
        }
    }

    /// One step of length `dt`; none where it cannot be said where it goes: particles that are flung apart
    /// in one stage meet another one in the next, or not, as the last digit decides; seven
    /// digits of a place are few where the force is steep; and the exact motion has corners.
    pub(super) fn step(self, size: f64, before: &[Particle], dt: f64) -> Option<Stepped> {
        let mut run = Run::new(size, before);
        match self {
            Self::Euler { parts } => {
                for _ in 0..parts {
                    run.kick(dt / f64::from(parts));
                    run.drift(dt / f64::from(parts));
                }
            }
            Self::SinglePrecision => {
                run.kick(dt);
                run.drift(dt);
            }
            Self::VelocityVerlet => {
                run.kick(0.5 * dt);
                run.drift(dt);
                run.kick(0.5 * dt);
            }
            Self::Pefrl => run.pefrl(dt),
            Self::RungeKutta => run.runge_kutta(dt),
            Self::Located => {
                run.sum_forces();
                // No events are followed of particles that cross the box in a step, and in a steep
                // contact the exact motion is not what a fourth-order step of this length finds.
                let fast = |p: &Particle| p.vx.hypot(p.vy) * dt > 2.0 * CUTOFF;
                let steep = |a: &f64| dt * dt * a > 0.1 * CUTOFF;
                if before.iter().any(fast) || run.magnitudes.iter().any(steep) {
                    return None;
                }
                let scene = common::soft::Scene::new(size, before.to_vec()).ok()?;
                run.particles =
                    exact(&scene, dt, Fineness { window: DT, tolerance: 1e-12 }).ok()?;
                // Nor in one that gets steep within the step.
                run.sum_forces();
                if run.magnitudes.iter().any(steep) {
                    return None;
                }
            }
        }
        let steepest = match self {
            Self::Euler { parts: 1 } => f64::INFINITY,
            Self::SinglePrecision => 0.3 * CUTOFF,
            _ => 100.0 * CUTOFF,
        };
        if run.magnitudes.iter().any(|a| dt * dt * a > steepest) {
            return None;
        }
        Some(Stepped { particles: run.particles, magnitudes: run.magnitudes })
    }
}

struct Run {
    size: f64,
    particles: Vec<Particle>,
    accelerations: Vec<Vec2>,
    magnitudes: Vec<f64>,
}

impl Run {
    fn new(size: f64, before: &[Particle]) -> Self {
        let n = before.len();
        let particles = before.to_vec();
        Self { size, particles, accelerations: vec![Vec2::ZERO; n], magnitudes: vec![0.0; n] }
    }

    /// Sums the forces on all particles, neighbours in ascending id.
    fn sum_forces(&mut self) {
        let mut near = pairs_within(&self.particles, CUTOFF);
        near.sort_unstable();
        let mut magnitudes = vec![0.0; self.particles.len()];
        self.accelerations.fill(Vec2::ZERO);
        for (i, j) in near {
            let d = self.particles[i].to(&self.particles[j]);
            let a = acceleration_of_pair(d.x, d.y);
            self.accelerations[i] += a;
            magnitudes[i] += a.norm_squared().sqrt();
        }
        for (greatest, now) in self.magnitudes.iter_mut().zip(magnitudes) {
            *greatest = greatest.max(now);
        }
    }

    fn kick(&mut self, dt: f64) {
        self.sum_forces();
        for (p, a) in self.particles.iter_mut().zip(&self.accelerations) {
            p.vx += a.x * dt;
            p.vy += a.y * dt;
        }
    }

    fn drift(&mut self, dt: f64) {
        for p in &mut self.particles {
            (p.x, p.vx) = fold(p.x + p.vx * dt, p.vx, self.size);
            (p.y, p.vy) = fold(p.y + p.vy * dt, p.vy, self.size);
        }
    }

    /// Omelyan, Mryglod and Folk, Computer Physics Communications 146 (2002), 188.
    fn pefrl(&mut self, dt: f64) {
        let (xi, lambda, chi) =
            (0.178_617_895_844_809_1, -0.212_341_831_062_605_4, -0.066_264_582_669_818_5);
        self.drift(xi * dt);
        self.kick((1.0 - 2.0 * lambda) / 2.0 * dt);
        self.drift(chi * dt);
        self.kick(lambda * dt);
        self.drift((1.0 - 2.0 * (chi + xi)) * dt);
        self.kick(lambda * dt);
        self.drift(chi * dt);
        self.kick((1.0 - 2.0 * lambda) / 2.0 * dt);
        self.drift(xi * dt);
    }

    fn runge_kutta(&mut self, dt: f64) {
        let start = self.particles.clone();
        let mut slopes: Vec<Vec<[f64; 4]>> = Vec::new();
        for part in [0.0, 0.5, 0.5, 1.0] {
            if let Some(slope) = slopes.last() {
                for ((p, s), [vx, vy, ax, ay]) in self.particles.iter_mut().zip(&start).zip(slope) {
                    (p.x, p.y) = (s.x + part * dt * vx, s.y + part * dt * vy);
                    (p.vx, p.vy) = (s.vx + part * dt * ax, s.vy + part * dt * ay);
                }
            }
            self.sum_forces();
            let slope = self.particles.iter().zip(&self.accelerations);
            slopes.push(slope.map(|(p, a)| [p.vx, p.vy, a.x, a.y]).collect());
        }
        for (i, (p, s)) in self.particles.iter_mut().zip(&start).enumerate() {
            let sum = |k: usize| {
                (slopes[0][i][k] + 2.0 * slopes[1][i][k] + 2.0 * slopes[2][i][k] + slopes[3][i][k])
                    * dt
                    / 6.0
            };
            (p.x, p.vx) = fold(s.x + sum(0), s.vx + sum(2), self.size);
            (p.y, p.vy) = fold(s.y + sum(1), s.vy + sum(3), self.size);
        }
    }
}

/// All ordered pairs of two different particles within `reach`.
fn pairs_within(particles: &[Particle], reach: f64) -> Vec<(usize, usize)> {
    let mut order: Vec<usize> = (0..particles.len()).collect();
    order.sort_by(|&a, &b| particles[a].x.total_cmp(&particles[b].x));
    let mut pairs = Vec::new();
    for (k, &i) in order.iter().enumerate() {
        for &j in &order[k + 1..] {
            let d = particles[i].to(&particles[j]);
            // A little more, for the rounding of the difference.
            if d.x > reach * (1.0 + 1e-9) {
                break;
            }
            if d.norm_squared() <= reach * reach {
                pairs.extend([(i, j), (j, i)]);
            }
        }
    }
    pairs
}

#[cfg(test)]
mod tests {
    use oracle::{Model, scenes};

    use super::*;

    #[test]
    fn the_official_step_is_the_models() {
        let scene = scenes::dense();
        let mut model = Model::new(&scene);
        model.step();
        let step = Method::Euler { parts: 1 }.step(scene.size(), scene.particles(), DT).unwrap();
        assert_eq!(step.particles, model.particles);
    }

    #[test]
    fn each_method_goes_where_the_exact_motion_goes() {
        let at = |x, vx| Particle { x, y: 0.05, vx, ..Particle::default() };
        let scene =
            common::soft::Scene::new(0.1, vec![at(0.048, 0.05), at(0.0565, -0.05)]).unwrap();
        let end = exact(&scene, DT, Fineness::FINE).unwrap();
        for (method, off) in [
            (Method::Euler { parts: 1 }, 1e-3),
            (Method::Euler { parts: 100 }, 1e-5),
            (Method::VelocityVerlet, 1e-4),
            (Method::Pefrl, 1e-5),
            (Method::RungeKutta, 1e-5),
        ] {
            let step = method.step(0.1, scene.particles(), DT).unwrap();
            let found = (step.particles[0].x - end[0].x).abs();
            assert!(found < off && found > 0.0, "{method:?}: off by {found:e}");
        }
    }
}
