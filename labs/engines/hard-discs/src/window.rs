//! Windows of time.

/// A part of the step: the times from `from` up to, but without, `to`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Window {
    /// Where it begins, as a part λ of the step.
    pub from: f64,
    /// Where it ends.
    pub to: f64,
}

impl Window {
    /// The whole step, its end included.
    pub const STEP: Self = Self { from: 0.0, to: f64::INFINITY };

    /// Window `k` of `count` equal ones. The last one includes the end of the step.
    pub fn part(k: usize, count: usize) -> Self {
        let at = |k: usize| k as f64 / count as f64;
        let to = if k + 1 == count { f64::INFINITY } else { at(k + 1) };
        Self { from: at(k), to }
    }

    /// Whether a time lies in it.
    #[inline]
    pub fn contains(&self, time: f64) -> bool {
        self.from <= time && time < self.to
    }
}
