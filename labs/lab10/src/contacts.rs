//! Pairs that really touch: filtered from many that might, then computed side by side.

use common::soft::{CUTOFF, Observer};

use crate::lanes::coefficient;

/// Pairs held before their forces are computed.
const ROOM: usize = 512;
/// The most that one filtering may add.
pub(crate) const BATCH: usize = 128;

/// Pairs within the cutoff, waiting for their forces.
///
/// Nearly every pair of a neighbour list is too far apart. Asking each, with a branch, costs a
/// wrong guess of the processor for each that is not; here every pair is written down and the
/// next one overwrites it unless it touches. What remains is dense, so its square roots and
/// divisions fill vector registers.
pub(crate) struct Contacts {
    dx: Box<[f64; ROOM]>,
    dy: Box<[f64; ROOM]>,
    r2: Box<[f64; ROOM]>,
    who: Box<[u32; ROOM]>,
    other: Box<[u32; ROOM]>,
    len: usize,
}

/// A push for a particle of another block.
pub(crate) type Push = (u32, f64, f64);

impl Default for Contacts {
    fn default() -> Self {
        Self {
            dx: Box::new([0.0; ROOM]),
            dy: Box::new([0.0; ROOM]),
            r2: Box::new([0.0; ROOM]),
            who: Box::new([0; ROOM]),
            other: Box::new([0; ROOM]),
            len: 0,
        }
    }
}

impl Contacts {
    /// Whether another batch fits.
    #[inline(always)]
    pub(crate) fn is_full(&self) -> bool {
        self.len > ROOM - BATCH
    }

    /// Keeps a pair at distance vector (`dx`, `dy`) for particle `who` if it is within the cutoff.
    #[inline(always)]
    pub(crate) fn offer(&mut self, who: u32, dx: f64, dy: f64) {
        let r2 = dx * dx + dy * dy;
        let place = self.len & (ROOM - 1);
        self.dx[place] = dx;
        self.dy[place] = dy;
        self.r2[place] = r2;
        self.who[place] = who;
        self.len += usize::from(r2 <= CUTOFF * CUTOFF);
    }

    /// The same for a pair that stands in one list only, of particles `who` and `other`.
    #[inline(always)]
    pub(crate) fn offer_pair(&mut self, who: u32, other: u32, dx: f64, dy: f64) {
        self.other[self.len & (ROOM - 1)] = other;
        self.offer(who, dx, dy);
    }

    /// Multiplies the distance vectors of all pairs held by their coefficients, and brings back
    /// how many they are.
    #[inline(always)]
    fn accelerate(&mut self) -> usize {
        for k in 0..self.len.next_multiple_of(8).min(ROOM) {
            let coef = coefficient(self.r2[k]);
            self.dx[k] *= coef;
            self.dy[k] *= coef;
        }
        std::mem::take(&mut self.len)
    }

    /// Adds the accelerations of all pairs held to both of their particles, and forgets them. The
    /// block's particles are `first ..`, their accelerations `ax`, `ay`; what others get is
    /// written down in `out`.
    #[inline(always)]
    pub(crate) fn settle_pairs<O: Observer>(
        &mut self,
        first: usize,
        ax: &mut [f64],
        ay: &mut [f64],
        out: &mut Vec<Push>,
        observer: &mut O,
    ) {
        for k in 0..self.accelerate() {
            let (x, y) = (self.dx[k], self.dy[k]);
            let (who, other) = (self.who[k] as usize, self.other[k] as usize - first);
            ax[who] += x;
            ay[who] += y;
            if other < ax.len() {
                ax[other] -= x;
                ay[other] -= y;
            } else {
                out.push((self.other[k], -x, -y));
            }
            observer.seen(self.r2[k]);
            observer.seen(self.r2[k]);
        }
    }

    /// Adds the accelerations of all pairs held to `ax[who]`, `ay[who]`, in the order in which
    /// they were offered, and forgets them.
    #[inline(always)]
    pub(crate) fn settle<O: Observer>(&mut self, ax: &mut [f64], ay: &mut [f64], observer: &mut O) {
        let len = self.accelerate();
        // A running sum for as long as the particle stays the same: a store for each pair, but no
        // load that would have to wait for it.
        let (mut last, mut sum_x, mut sum_y) = (u32::MAX, 0.0, 0.0);
        for k in 0..len {
            let who = self.who[k];
            if who != last {
                (sum_x, sum_y) = (ax[who as usize], ay[who as usize]);
                last = who;
            }
            sum_x += self.dx[k];
            sum_y += self.dy[k];
            ax[who as usize] = sum_x;
            ay[who as usize] = sum_y;
            observer.seen(self.r2[k]);
        }
    }
}
