//! How fast particles are, by a sample.

use crate::Bodies;

/// The speeds of some of the particles.
pub(crate) struct Sample {
    speeds: Vec<f64>,
}

impl Sample {
    /// Of at most `most` particles, evenly spread over the arrays.
    pub(crate) fn of(bodies: &Bodies, most: usize) -> Self {
        let n = bodies.len();
        let speed = |i: usize| (bodies.vx[i] * bodies.vx[i] + bodies.vy[i] * bodies.vy[i]).sqrt();
        Self { speeds: (0..n).step_by(n.div_ceil(most)).map(speed).collect() }
    }

    /// The mean.
    pub(crate) fn mean(&self) -> f64 {
        self.speeds.iter().sum::<f64>() / self.speeds.len() as f64
    }

    /// What all but one in `many` stay below.
    pub(crate) fn all_but_one_in(&mut self, many: usize) -> f64 {
        let place = self.speeds.len() - 1 - self.speeds.len() / many;
        *self.speeds.select_nth_unstable_by(place, f64::total_cmp).1
    }
}
