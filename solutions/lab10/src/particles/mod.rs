//! Particles as a structure of arrays.

use common::soft::{Particle, Scene};

use crate::kernels::{EIGHT, Places, larger};

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

    /// Takes particle number `i` of the arrays away; the last one fills its place.
    pub fn swap_remove(&mut self, i: usize) -> Particle {
        Particle {
            x: self.x.swap_remove(i),
            y: self.y.swap_remove(i),
            vx: self.vx.swap_remove(i),
            vy: self.vy.swap_remove(i),
            id: self.id.swap_remove(i),
        }
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
    pub fn fastest(&self) -> f64 {
        let mut fastest = [0.0; EIGHT];
        for (vx, vy) in self.vx.chunks(EIGHT).zip(self.vy.chunks(EIGHT)) {
            for ((fastest, vx), vy) in fastest.iter_mut().zip(vx).zip(vy) {
                *fastest = larger(vx * vx + vy * vy, *fastest);
            }
        }
        fastest.into_iter().fold(0.0, f64::max).sqrt()
    }

    /// Where all of them are.
    pub fn places(&self) -> Places<'_> {
        Places { x: &self.x, y: &self.y, first: 0 }
    }

    /// Makes room for exactly `n` particles; new ones are zero.
    pub fn resize(&mut self, n: usize) {
        for array in [&mut self.x, &mut self.y, &mut self.vx, &mut self.vy] {
            make_room(array, n);
        }
        make_room(&mut self.id, n);
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

/// Gives an array `n` entries; new ones are zero. Its first memory comes from the system, which has
/// cleared it: that is not written before it is used.
pub(crate) fn make_room<T: Copy + Default>(array: &mut Vec<T>, n: usize) {
    if array.capacity() == 0 {
        *array = vec![T::default(); n];
    } else {
        array.resize(n, T::default());
    }
}

/// Where particles are, eight at a time.
pub trait Eight {
    /// Where particle `i` is: x and y.
    fn at(&self, i: usize) -> (f64, f64);

    /// Where the eight particles from `start` on are, their x and their y. Where there are fewer,
    /// the rest is infinitely far away.
    fn eight(&self, start: usize) -> ([f64; EIGHT], [f64; EIGHT]);
}

/// Particles of which eight follow every place that is asked for.
pub struct Inner<'a>(pub &'a Bodies);

impl Eight for Inner<'_> {
    #[inline(always)]
    fn at(&self, i: usize) -> (f64, f64) {
        (self.0.x[i], self.0.y[i])
    }

    #[inline(always)]
    fn eight(&self, start: usize) -> ([f64; EIGHT], [f64; EIGHT]) {
        let eight = |places: &[f64]| std::array::from_fn(|l| places[l]);
        (eight(&self.0.x[start..start + EIGHT]), eight(&self.0.y[start..start + EIGHT]))
    }
}

/// Any particles, up to the end of the arrays.
impl Eight for Bodies {
    fn at(&self, i: usize) -> (f64, f64) {
        (self.x[i], self.y[i])
    }

    fn eight(&self, start: usize) -> ([f64; EIGHT], [f64; EIGHT]) {
        let eight = |places: &[f64]| {
            let mut eight = [f64::INFINITY; EIGHT];
            eight.iter_mut().zip(&places[start..]).for_each(|(to, x)| *to = *x);
            eight
        };
        (eight(&self.x), eight(&self.y))
    }
}

/// The speeds of some of the particles.
pub struct Sample {
    speeds: Vec<f64>,
}

impl Sample {
    /// Of at most `most` particles, evenly spread over the arrays.
    pub fn of(bodies: &Bodies, most: usize) -> Self {
        let n = bodies.len();
        let speed = |i: usize| (bodies.vx[i] * bodies.vx[i] + bodies.vy[i] * bodies.vy[i]).sqrt();
        Self { speeds: (0..n).step_by(n.div_ceil(most)).map(speed).collect() }
    }

    /// The mean.
    pub fn mean(&self) -> f64 {
        self.speeds.iter().sum::<f64>() / self.speeds.len() as f64
    }

    /// What all but one in `many` stay below.
    pub fn all_but_one_in(&mut self, many: usize) -> f64 {
        let place = self.speeds.len() - 1 - self.speeds.len() / many;
        *self.speeds.select_nth_unstable_by(place, f64::total_cmp).1
    }
}
