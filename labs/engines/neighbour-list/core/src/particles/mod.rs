//! Particles as a structure of arrays.

mod moving;

use common::soft::{Particle, Scene};

pub use moving::Moving;

use crate::kernels::{EIGHT, Positions, larger};

/// Particles with one array for each quantity.
///
/// Eight neighbours in memory thus fill a vector register, and a loop reads only the quantities
/// that it needs.
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
    /// The particles' numbers in the scene.
    pub id: Vec<u32>,
}

impl Bodies {
    /// Returns the particles of a scene, in id order.
    pub fn of(scene: &Scene) -> Self {
        let mut bodies = Self::default();
        for particle in scene.particles() {
            bodies.push(*particle);
        }
        bodies
    }

    /// Returns the number of particles.
    pub fn len(&self) -> usize {
        self.x.len()
    }

    /// Whether there are no particles.
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

    /// Removes the particle at index `i`. The last particle takes its index.
    pub fn swap_remove(&mut self, i: usize) -> Particle {
        Particle {
            x: self.x.swap_remove(i),
            y: self.y.swap_remove(i),
            vx: self.vx.swap_remove(i),
            vy: self.vy.swap_remove(i),
            id: self.id.swap_remove(i),
        }
    }

    /// Returns the particle at index `i`.
    #[inline]
    pub fn get(&self, i: usize) -> Particle {
        Particle { x: self.x[i], y: self.y[i], vx: self.vx[i], vy: self.vy[i], id: self.id[i] }
    }

    /// Replaces the particle at index `i`.
    #[inline]
    pub fn set(&mut self, i: usize, particle: Particle) {
        self.x[i] = particle.x;
        self.y[i] = particle.y;
        self.vx[i] = particle.vx;
        self.vy[i] = particle.vy;
        self.id[i] = particle.id;
    }

    /// Returns the greatest speed.
    #[inline]
    pub fn fastest(&self) -> f64 {
        let mut fastest = [0.0; EIGHT];
        for (vx, vy) in self.vx.chunks(EIGHT).zip(self.vy.chunks(EIGHT)) {
            for ((fastest, vx), vy) in fastest.iter_mut().zip(vx).zip(vy) {
                *fastest = larger(vx * vx + vy * vy, *fastest);
            }
        }
        fastest.into_iter().fold(0.0, f64::max).sqrt()
    }

    /// Returns all positions.
    #[inline(always)]
    pub fn positions(&self) -> Positions<'_> {
        Positions { x: &self.x, y: &self.y, first: 0 }
    }

    /// Returns all particles, so that they can be moved.
    #[inline(always)]
    pub fn moving(&mut self) -> Moving<'_> {
        Moving {
            x: &mut self.x,
            y: &mut self.y,
            vx: &mut self.vx,
            vy: &mut self.vy,
            id: &mut self.id,
        }
    }

    /// Splits the particles at `ends`, an ascending list that ends with the number of particles.
    pub fn split(&mut self, ends: &[usize]) -> Vec<Moving<'_>> {
        let mut rest = self.moving();
        let mut pieces = Vec::with_capacity(ends.len());
        let mut start = 0;
        for &end in ends {
            pieces.push(rest.split_off(end - start));
            start = end;
        }
        pieces
    }

    /// Changes the number of particles to `n`. New particles are zero.
    pub fn resize(&mut self, n: usize) {
        for array in [&mut self.x, &mut self.y, &mut self.vx, &mut self.vy] {
            make_room(array, n);
        }
        make_room(&mut self.id, n);
    }

    /// Writes the particles with ids `first .. first + out.len()` into `out`, in id order.
    pub fn read(&self, first: usize, out: &mut [Particle]) {
        for i in 0..self.len() {
            let index = (self.id[i] as usize).checked_sub(first);
            if let Some(slot) = index.and_then(|index| out.get_mut(index)) {
                *slot = self.get(i);
            }
        }
    }
}

/// Changes the length of an array to `n`. New elements are zero.
///
/// The first memory comes from the system as zeros, so it need not be written first.
pub(crate) fn make_room<T: Copy + Default>(array: &mut Vec<T>, n: usize) {
    if array.capacity() == 0 {
        *array = vec![T::default(); n];
    } else {
        array.resize(n, T::default());
    }
}

/// A sample of the particles' speeds.
pub struct Sample {
    speeds: Vec<f64>,
}

impl Sample {
    /// Samples at most `most` particles, evenly spread over the arrays.
    pub fn of(bodies: &Bodies, most: usize) -> Self {
        let n = bodies.len();
        let speed = |i: usize| (bodies.vx[i] * bodies.vx[i] + bodies.vy[i] * bodies.vy[i]).sqrt();
        Self { speeds: (0..n).step_by(n.div_ceil(most)).map(speed).collect() }
    }

    /// Returns the mean speed.
    pub fn mean(&self) -> f64 {
        self.speeds.iter().sum::<f64>() / self.speeds.len() as f64
    }

    /// Returns the speed that only one particle in `many` exceeds.
    pub fn all_but_one_in(&mut self, many: usize) -> f64 {
        let k = self.speeds.len() - 1 - self.speeds.len() / many;
        *self.speeds.select_nth_unstable_by(k, f64::total_cmp).1
    }
}
