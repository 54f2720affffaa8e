//! The model, written a second time: plain loops over coordinate arrays, no bins, no sharing.

use common::Vec2;
use common::soft::{CUTOFF, DT, MASS, MIN_R, Particle, Scene};

/// All particles of a box and the forces on them, computed from all pairs.
#[derive(Clone, Debug)]
pub struct Model {
    /// Side of the box.
    pub size: f64,
    /// Particles in id order.
    pub particles: Vec<Particle>,
    /// Acceleration of each particle in the last step.
    pub accelerations: Vec<Vec2>,
    /// Sum of |a_ij| over the neighbours of each particle: the scale of rounding errors.
    pub magnitudes: Vec<f64>,
}

impl Model {
    /// Returns a model that starts from a scene.
    pub fn new(scene: &Scene) -> Self {
        Self::from_state(scene.size(), scene.particles().to_vec())
    }

    /// Returns a model that starts from any particles in id order.
    pub fn from_state(size: f64, particles: Vec<Particle>) -> Self {
        let n = particles.len();
        Self { size, particles, accelerations: vec![Vec2::ZERO; n], magnitudes: vec![0.0; n] }
    }

    /// Advances by one time step. Neighbours are summed in ascending order of ids.
    pub fn step(&mut self) {
        self.advance(DT);
    }

    /// Advances by a different time step `dt`.
    pub fn advance(&mut self, dt: f64) {
        self.sum();
        for (particle, a) in self.particles.iter_mut().zip(&self.accelerations) {
            particle.vx += a.x * dt;
            particle.vy += a.y * dt;
            particle.x += particle.vx * dt;
            particle.y += particle.vy * dt;
            (particle.x, particle.vx) = fold(particle.x, particle.vx, self.size);
            (particle.y, particle.vy) = fold(particle.y, particle.vy, self.size);
        }
    }

    fn sum(&mut self) {
        let xs: Vec<f64> = self.particles.iter().map(|p| p.x).collect();
        let ys: Vec<f64> = self.particles.iter().map(|p| p.y).collect();
        for i in 0..self.particles.len() {
            let (mut ax, mut ay, mut magnitude) = (0.0, 0.0, 0.0);
            for j in 0..xs.len() {
                let (dx, dy) = (xs[j] - xs[i], ys[j] - ys[i]);
                if dx * dx + dy * dy <= CUTOFF * CUTOFF {
                    let a = acceleration_of_pair(dx, dy);
                    ax += a.x;
                    ay += a.y;
                    magnitude += a.norm_squared().sqrt();
                }
            }
            self.accelerations[i] = Vec2::new(ax, ay);
            self.magnitudes[i] = magnitude;
        }
    }
}

/// Returns the acceleration that a neighbour at (dx, dy) causes; zero beyond the cutoff.
pub fn acceleration_of_pair(dx: f64, dy: f64) -> Vec2 {
    let squared = dx * dx + dy * dy;
    if squared > CUTOFF * CUTOFF {
        return Vec2::ZERO;
    }
    let squared = if squared < MIN_R * MIN_R { MIN_R * MIN_R } else { squared };
    let coefficient = (1.0 - CUTOFF / squared.sqrt()) / squared / MASS;
    Vec2::new(coefficient * dx, coefficient * dy)
}

/// Returns the potential energy of a pair at (dx, dy).
pub fn potential_of_pair(dx: f64, dy: f64) -> f64 {
    let r = (dx * dx + dy * dy).sqrt();
    let potential = |r: f64| CUTOFF / r - 1.0 - (CUTOFF / r).ln();
    if r > CUTOFF {
        0.0
    } else if r >= MIN_R {
        potential(r)
    } else {
        let kappa = (CUTOFF / MIN_R - 1.0) / (MIN_R * MIN_R);
        potential(MIN_R) + kappa * (MIN_R * MIN_R - r * r) / 2.0
    }
}

/// Returns the kinetic and potential energy of all particles.
pub fn energy(particles: &[Particle]) -> f64 {
    let of = |(i, p): (usize, &Particle)| {
        let near = particles[..i].iter().map(|q| potential_of_pair(q.x - p.x, q.y - p.y));
        0.5 * MASS * (p.vx * p.vx + p.vy * p.vy) + near.sum::<f64>()
    };
    particles.iter().enumerate().map(of).sum()
}

/// Returns a coordinate and its velocity after all reflections.
pub fn fold(x: f64, v: f64, size: f64) -> (f64, f64) {
    let (mut x, mut v, mut reflections) = (x, v, 0);
    while (x < 0.0 || x > size) && reflections < 8 {
        x = if x < 0.0 { -x } else { 2.0 * size - x };
        v = -v;
        reflections += 1;
    }
    if x < 0.0 || x > size {
        x = x.rem_euclid(2.0 * size);
        if x > size {
            (x, v) = (2.0 * size - x, -v);
        }
    }
    (x, v)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_force_is_the_slope_of_the_potential() {
        let h = 1e-9;
        for r in [0.00003, 0.00008, 0.0002, 0.001, 0.004, 0.0099] {
            let slope = (potential_of_pair(r + h, 0.0) - potential_of_pair(r - h, 0.0)) / (2.0 * h);
            // The neighbour at +r repels towards -x; the potential falls with r.
            let force = MASS * acceleration_of_pair(r, 0.0).x;
            assert!((force - slope).abs() <= 1e-5 * slope.abs(), "r = {r}: {force} and {slope}");
        }
    }

    #[test]
    fn a_path_folds_like_a_zigzag() {
        for step in -4000..4000 {
            let x = f64::from(step) * 0.0137;
            let phase = (x / 2.0).rem_euclid(1.0) * 2.0;
            let zigzag = if phase <= 1.0 { phase } else { 2.0 - phase };
            let (folded, _) = fold(x, 1.0, 1.0);
            assert!((folded - zigzag).abs() < 1e-12, "{x}: {folded}, not {zigzag}");
        }
    }

    #[test]
    fn two_particles_keep_their_momentum_and_energy() {
        let at = |x, vx| Particle { x, y: 0.5, vx, ..Particle::default() };
        let scene = Scene::new(1.0, vec![at(0.45, 0.5), at(0.55, -0.5)]).unwrap();
        let mut model = Model::new(&scene);
        for _ in 0..400 {
            model.step();
        }
        let [a, b] = model.particles[..] else { unreachable!() };
        assert!(a.vx < -0.4 && b.vx > 0.4, "they bounced off each other");
        assert!((a.vx + b.vx).abs() < 1e-12);
    }

    /// Checks the numbers of the book's page *The problem*.
    #[test]
    fn how_close_two_particles_come() {
        let at_start = f64::sqrt(2.0);
        let energy = 2.0 * 0.5 * MASS * at_start * at_start;
        assert!(potential_of_pair(0.825 * CUTOFF, 0.0) < energy, "they come nearer");
        assert!(potential_of_pair(0.824 * CUTOFF, 0.0) > energy, "they stop before");

        let mut model = Model::new(&Scene::official(500, 1).expect("the scene is valid"));
        (0..349).for_each(|_| model.step());
        let speed = |p: &Particle| p.vx.hypot(p.vy);
        let fastest = model.particles.iter().max_by(|a, b| speed(a).total_cmp(&speed(b)));
        let fastest = *fastest.expect("the scene has 500 particles");
        assert!((speed(&fastest) - 3.034).abs() < 5e-4, "its speed is {}", speed(&fastest));
        let by_distance = |model: &Model| {
            let one = model.particles[fastest.id as usize];
            let mut all: Vec<_> = (model.particles.iter())
                .map(|p| ((p.x - one.x).hypot(p.y - one.y) / CUTOFF, p.id))
                .collect();
            all.sort_by(|a, b| a.0.total_cmp(&b.0));
            all
        };
        // The particle is not in contact yet. Its energy and angular momentum relative to the
        // nearest particle determine the least distance of the exact motion.
        let (distance, partner) = by_distance(&model)[1];
        assert!(distance > 1.0, "contact begins at {distance}");
        let partner = model.particles[partner as usize];
        let d = Vec2::new(partner.x - fastest.x, partner.y - fastest.y);
        let w = Vec2::new(partner.vx - fastest.vx, partner.vy - fastest.vy);
        let (energy, offset) =
            (0.25 * MASS * w.norm_squared(), d.cross(w) / w.norm_squared().sqrt());
        let left = |r: f64| energy * (1.0 - (offset / r).powi(2)) - potential_of_pair(r, 0.0);
        assert!(left(0.7755 * CUTOFF) > 0.0 && left(0.7745 * CUTOFF) < 0.0, "not at 0.775");

        (0..2).for_each(|_| model.step());
        let distances = by_distance(&model);
        assert!((distances[1].0 - 0.766).abs() < 5e-4, "its neighbour is at {}", distances[1].0);
        assert!(distances[2].0 > 1.0, "a third particle is at {}", distances[2].0);
    }
}
