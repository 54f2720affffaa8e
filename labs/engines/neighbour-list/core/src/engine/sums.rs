//! Sums of accelerations for the particles that a pass currently works on.

/// The accelerations of consecutive particles: the particles of a piece, and the particles ahead of
/// the piece.
///
/// There are so few particles that the sums stay in the cache.
#[derive(Default)]
pub(super) struct Sums {
    /// The index of the first particle.
    first: usize,
    x: Vec<f64>,
    y: Vec<f64>,
}

impl Sums {
    /// Clears the sums; particle `first` will be the first.
    pub(super) fn begin(&mut self, first: usize) {
        self.first = first;
        self.x.clear();
        self.y.clear();
    }

    /// Appends zeros, so that the sums reach up to particle `end`.
    #[inline(always)]
    pub(super) fn extend_to(&mut self, end: usize) {
        let len = (end - self.first).max(self.x.len());
        self.x.resize(len, 0.0);
        self.y.resize(len, 0.0);
    }

    #[inline(always)]
    pub(super) fn add(&mut self, i: u32, [x, y]: [f64; 2]) {
        let i = i as usize - self.first;
        self.x[i] += x;
        self.y[i] += y;
    }

    /// Returns the accelerations of the first `len` particles along x and along y.
    #[inline(always)]
    pub(super) fn first(&self, len: usize) -> (&[f64], &[f64]) {
        (&self.x[..len], &self.y[..len])
    }

    /// Removes the first `len` particles.
    #[inline(always)]
    pub(super) fn drop_first(&mut self, len: usize) {
        for sums in [&mut self.x, &mut self.y] {
            sums.copy_within(len.., 0);
            sums.truncate(sums.len() - len);
        }
        self.first += len;
    }
}
