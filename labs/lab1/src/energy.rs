//! Task 1.5: energy and momentum.

use common::Vec2;
use common::soft::{CUTOFF, MASS, MIN_R, Particle, Scene, Simulation, Statistics};

use crate::{AllPairs, Tally};

/// Returns the potential energy of two particles, where `d` is the vector from one to the other.
///
/// The potential energy is the work of pushing the particles together, from the cutoff to this
/// distance.
///
/// With the distance r = |d|, the cutoff c and the least distance q = [`MIN_R`]:
///
/// - Beyond the cutoff, the energy U is 0.
/// - From q to the cutoff, U(r) = c/r − 1 − ln(c/r).
/// - Below q, the force is proportional to r, so the energy continues as a parabola:
///   U(q) + κ (q² − r²) / 2 with κ = (c/q − 1) / q².
///
/// Book: chapter 1, *Energy*.
pub fn pair_potential(d: Vec2) -> f64 {
    todo!("task 1.5: energy and momentum")
}

/// Returns the potential energy of all particles. Every pair counts once.
pub fn potential_energy(particles: &[Particle]) -> f64 {
    todo!("task 1.5b: the potential energy of all pairs")
}

/// Returns the energy of motion, the sum of m v² / 2 over all particles.
pub fn kinetic_energy(particles: &[Particle]) -> f64 {
    todo!("task 1.5c: the energy of motion")
}

/// Returns the momentum, the sum of m v over all particles. Forces between particles do not
/// change it, but walls do.
pub fn momentum(particles: &[Particle]) -> Vec2 {
    todo!("task 1.5d: the momentum")
}

/// A variant of the all-pairs program that also computes the energy after every step. The exact
/// energy is constant, so any change is an error caused by the finite time step.
#[derive(Default)]
pub struct WithEnergy {
    inner: AllPairs<Tally>,
    particles: Vec<Particle>,
    start: f64,
    energy: f64,
    worst: f64,
}

impl WithEnergy {
    fn look(&mut self) {
        self.inner.read(0, &mut self.particles);
        self.energy = kinetic_energy(&self.particles) + potential_energy(&self.particles);
    }
}

impl Simulation for WithEnergy {
    fn load(&mut self, scene: &Scene) {
        self.inner.load(scene);
        self.particles = scene.particles().to_vec();
        self.look();
        self.start = self.energy;
        self.worst = 0.0;
    }

    fn step(&mut self) {
        self.inner.step();
        self.look();
        self.worst = self.worst.max((self.energy - self.start).abs());
    }

    fn read(&self, first: usize, out: &mut [Particle]) {
        self.inner.read(first, out);
    }

    fn statistics(&self) -> Option<Statistics> {
        self.inner.statistics()
    }

    fn counters(&self) -> Vec<(&'static str, f64)> {
        let momentum = momentum(&self.particles);
        vec![
            ("energy at the start", self.start),
            ("energy at the end", self.energy),
            ("largest relative change of energy", self.worst / self.start),
            ("momentum along x", momentum.x),
            ("momentum along y", momentum.y),
        ]
    }
}
