//! Pairs that really touch: filtered from many that might, then computed side by side.

use common::soft::{CUTOFF, Observer};

use crate::lanes::coefficient;

/// Pairs held before their forces are computed.
const ROOM: usize = 512;
/// The most that one filtering may add.
pub const BATCH: usize = 128;

/// Pairs within the cutoff, waiting for their forces.
///
/// Nearly every pair of a neighbour list is too far apart. Asking each, with a branch, costs a
/// wrong guess of the processor for each that is not; here every pair is written down and the
/// next one overwrites it unless it touches. What remains is dense, so its square roots and
/// divisions fill vector registers.
pub struct Contacts {
    vectors: Vectors<ROOM>,
    who: Box<[u32; ROOM]>,
    len: usize,
}

impl Default for Contacts {
    fn default() -> Self {
        Self { vectors: Vectors::default(), who: Box::new([0; ROOM]), len: 0 }
    }
}

/// Distance vectors of pairs, and their squared lengths.
pub(crate) struct Vectors<const ROOM: usize> {
    pub(crate) dx: Box<[f64; ROOM]>,
    pub(crate) dy: Box<[f64; ROOM]>,
    pub(crate) r2: Box<[f64; ROOM]>,
}

impl<const ROOM: usize> Default for Vectors<ROOM> {
    fn default() -> Self {
        let zeros = || Box::new([0.0; ROOM]);
        Self { dx: zeros(), dy: zeros(), r2: zeros() }
    }
}

impl<const ROOM: usize> Vectors<ROOM> {
    /// Multiplies the first `len` vectors by the coefficients of their accelerations.
    #[inline(always)]
    pub(crate) fn accelerate(&mut self, len: usize) {
        for k in 0..len.next_multiple_of(8).min(ROOM) {
            let coef = coefficient(self.r2[k]);
            self.dx[k] *= coef;
            self.dy[k] *= coef;
        }
    }
}

impl Contacts {
    /// Whether another batch fits.
    #[inline(always)]
    pub fn is_full(&self) -> bool {
        self.len > ROOM - BATCH
    }

    /// Keeps a pair at distance vector (`dx`, `dy`) for particle `who` if it is within the cutoff.
    #[inline(always)]
    pub fn offer(&mut self, who: u32, dx: f64, dy: f64) {
        let r2 = dx * dx + dy * dy;
        let place = self.len & (ROOM - 1);
        self.vectors.dx[place] = dx;
        self.vectors.dy[place] = dy;
        self.vectors.r2[place] = r2;
        self.who[place] = who;
        self.len += usize::from(r2 <= CUTOFF * CUTOFF);
    }

    /// Adds the accelerations of all pairs held to `ax[who]`, `ay[who]`, in the order in which
    /// they were offered, and forgets them.
    #[inline(always)]
    pub fn settle<O: Observer>(&mut self, ax: &mut [f64], ay: &mut [f64], observer: &mut O) {
        let len = std::mem::take(&mut self.len);
        self.vectors.accelerate(len);
        // A running sum for as long as the particle stays the same: a store for each pair, but no
        // load that would have to wait for it.
        let (mut last, mut sum_x, mut sum_y) = (u32::MAX, 0.0, 0.0);
        for k in 0..len {
            let who = self.who[k];
            if who != last {
                (sum_x, sum_y) = (ax[who as usize], ay[who as usize]);
                last = who;
            }
            sum_x += self.vectors.dx[k];
            sum_y += self.vectors.dy[k];
            ax[who as usize] = sum_x;
            ay[who as usize] = sum_y;
            observer.seen(self.vectors.r2[k]);
        }
    }
}
