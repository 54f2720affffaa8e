//! Sums of accelerations.

/// The accelerations of consecutive particles: of a piece and what it looks ahead, so few that they stay in
/// the cache.
#[derive(Default)]
pub(super) struct Sums {
    /// The first particle.
    first: usize,
    x: Vec<f64>,
    y: Vec<f64>,
}

impl Sums {
    /// Begins with no particle; the next one is `first`.
    pub(super) fn begin(&mut self, first: usize) {
        self.first = first;
        self.x.clear();
        self.y.clear();
    }

    /// Begins with zero for the particles after the last, up to particle `end`.
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

    /// Of the first `len` particles.
    #[inline(always)]
    pub(super) fn first(&self, len: usize) -> (&[f64], &[f64]) {
        (&self.x[..len], &self.y[..len])
    }

    /// Forgets the first `len` particles.
    #[inline(always)]
    pub(super) fn drop_first(&mut self, len: usize) {
        for sums in [&mut self.x, &mut self.y] {
            sums.copy_within(len.., 0);
            sums.truncate(sums.len() - len);
        }
        self.first += len;
    }
}
