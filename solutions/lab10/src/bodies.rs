//! Particles as a structure of arrays.

use common::soft::{Particle, Scene};

use crate::lanes::larger;
use crate::signs::EIGHT;

/// Particles, one array for each of their numbers, so that eight neighbours in memory fill a
/// vector register and a loop touches only what it needs.
#[derive(Clone, Debug, Default)]
pub struct Bodies {
    /// Positions along x.
    pub x: Vec<f64>,
    /// Positions along y.
    pub y: Vec<f64>,
    /// Velocities along x.
    pub vx: Vec<f64>,
    /// Velocities along y.
    pub vy: Vec<f64>,
    /// Their numbers in the scene.
    pub id: Vec<u32>,
}

impl Bodies {
    /// The particles of a scene in id order.
    pub fn of(scene: &Scene) -> Self {
        let mut bodies = Self::default();
        for particle in scene.particles() {
            bodies.push(*particle);
        }
        bodies
    }

    /// How many there are.
    pub fn len(&self) -> usize {
        self.x.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.x.is_empty()
    }

    /// Appends a particle.
    pub fn push(&mut self, particle: Particle) {
        self.x.push(particle.x);
        self.y.push(particle.y);
        self.vx.push(particle.vx);
        self.vy.push(particle.vy);
        self.id.push(particle.id);
    }

    /// Particle number `i` of the arrays.
    #[inline]
    pub fn get(&self, i: usize) -> Particle {
        Particle { x: self.x[i], y: self.y[i], vx: self.vx[i], vy: self.vy[i], id: self.id[i] }
    }

    /// Replaces particle number `i` of the arrays.
    #[inline]
    pub fn set(&mut self, i: usize, particle: Particle) {
        (self.x[i], self.y[i]) = (particle.x, particle.y);
        (self.vx[i], self.vy[i]) = (particle.vx, particle.vy);
        self.id[i] = particle.id;
    }

    /// The greatest speed of all.
    pub(crate) fn fastest(&self) -> f64 {
        let mut fastest = [0.0; EIGHT];
        for (vx, vy) in self.vx.chunks(EIGHT).zip(self.vy.chunks(EIGHT)) {
            for ((fastest, vx), vy) in fastest.iter_mut().zip(vx).zip(vy) {
                *fastest = larger(vx * vx + vy * vy, *fastest);
            }
        }
        fastest.into_iter().fold(0.0, f64::max).sqrt()
    }

    /// Makes room for exactly `n` particles; those that are new are zero.
    pub fn resize(&mut self, n: usize) {
        for array in [&mut self.x, &mut self.y, &mut self.vx, &mut self.vy] {
            array.resize(n, 0.0);
        }
        self.id.resize(n, 0);
    }

    /// Writes the particles with ids `first .. first + out.len()` into `out`, in id order.
    pub fn read(&self, first: usize, out: &mut [Particle]) {
        for i in 0..self.len() {
            let place = (self.id[i] as usize).checked_sub(first);
            if let Some(slot) = place.and_then(|place| out.get_mut(place)) {
                *slot = self.get(i);
            }
        }
    }
}
