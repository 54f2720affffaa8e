//! Particles fetched eight at a time.

use crate::Bodies;
use crate::signs::EIGHT;

/// Where particles are, for somebody who looks at eight at a time.
pub trait Eight {
    /// Where particle `i` is: x and y.
    fn at(&self, i: usize) -> (f64, f64);

    /// Where the eight particles from `start` on are, their x and their y. Where there are fewer,
    /// the rest is infinitely far away.
    fn eight(&self, start: usize) -> ([f64; EIGHT], [f64; EIGHT]);
}

/// Particles of which eight follow every place that is asked for.
pub(crate) struct Inner<'a>(pub(crate) &'a Bodies);

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
