//! Accelerations while they are being summed.

/// The accelerations of consecutive particles; who owns them knows which is the first.
#[derive(Clone, Debug, Default)]
pub(crate) struct Sums {
    pub(crate) x: Vec<f64>,
    pub(crate) y: Vec<f64>,
}

impl Sums {
    /// How many particles they are.
    pub(crate) fn len(&self) -> usize {
        self.x.len()
    }

    /// Forgets all.
    pub(crate) fn clear(&mut self) {
        self.x.clear();
        self.y.clear();
    }

    /// Begins with zero for the particles after the last, up to `len` of them in all; if there are
    /// as many, nothing happens.
    #[inline(always)]
    pub(crate) fn reach(&mut self, len: usize) {
        if len > self.len() {
            self.x.resize(len, 0.0);
            self.y.resize(len, 0.0);
        }
    }

    /// Forgets the first `k`.
    #[inline(always)]
    pub(crate) fn drop_first(&mut self, k: usize) {
        for sums in [&mut self.x, &mut self.y] {
            sums.copy_within(k.., 0);
            sums.truncate(sums.len() - k);
        }
    }

    /// Appends the first `k` of `other`.
    #[inline(always)]
    pub(crate) fn extend(&mut self, other: &Self, k: usize) {
        self.x.extend_from_slice(&other.x[..k]);
        self.y.extend_from_slice(&other.y[..k]);
    }

    /// Adds those of `other` from its `skip`-th on, as far as there are both.
    pub(crate) fn add(&mut self, other: &Self, skip: usize) {
        for (to, from) in [(&mut self.x, &other.x), (&mut self.y, &other.y)] {
            to.iter_mut().zip(&from[skip..]).for_each(|(to, from)| *to += from);
        }
    }
}
