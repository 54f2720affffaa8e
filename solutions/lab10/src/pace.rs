//! Who is faster than a list allows.

use crate::runners::Runner;

/// Particles that are compared together; few are fast.
const CHUNK: usize = 16;

/// The speeds that a list allows consecutive particles.
#[derive(Clone, Copy)]
pub(crate) struct Pace<'a> {
    /// Of most particles.
    pub(crate) usual: f64,
    /// Whether it matters who is faster, and not only how much.
    pub(crate) noted: bool,
    /// Those that may be faster, in sorted order.
    pub(crate) runners: &'a [Runner],
}

/// Who was seen to be faster than usual, and is no runner yet.
pub(crate) struct Fast {
    /// Their places in the sorted order, perhaps more than once.
    pub(crate) who: Vec<u32>,
    /// How many times as fast as allowed the worst of all was in the step, at least 1.
    pub(crate) over: f64,
}

impl Default for Fast {
    fn default() -> Self {
        Self { who: Vec::new(), over: 1.0 }
    }
}

impl Pace<'_> {
    /// Looks for the fast among particles with these velocities, the first in place `first`.
    #[inline(always)]
    pub(crate) fn watch(&self, first: usize, vx: &[f64], vy: &[f64], fast: &mut Fast) {
        for (k, (vx, vy)) in vx.chunks(CHUNK).zip(vy.chunks(CHUNK)).enumerate() {
            let mut any = false;
            for (vx, vy) in vx.iter().zip(vy) {
                any |= vx * vx + vy * vy > self.usual * self.usual;
            }
            if any {
                self.note(first + k * CHUNK, vx, vy, fast);
            }
        }
    }

    #[inline(never)]
    fn note(&self, first: usize, vx: &[f64], vy: &[f64], fast: &mut Fast) {
        for (k, (vx, vy)) in vx.iter().zip(vy).enumerate() {
            self.judge((first + k) as u32, vx * vx + vy * vy, fast);
        }
    }

    /// Notes a particle if the square of its speed is more than usual and it does not run yet.
    #[inline(always)]
    pub(crate) fn judge(&self, who: u32, square: f64, fast: &mut Fast) {
        if square > self.usual * self.usual {
            let place = self.runners.binary_search_by_key(&who, |runner| runner.who);
            let ratio = place.map_or(1.0, |k| self.runners[k].ratio);
            if self.noted && place.is_err() {
                fast.who.push(who);
            }
            fast.over = fast.over.max(square.sqrt() / (ratio * self.usual));
        }
    }
}
