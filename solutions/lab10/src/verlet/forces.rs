//! Pairs that really touch: filtered from many that might, then computed side by side.

use common::soft::{CUTOFF, Observer};

use crate::filter::filter;
use crate::kernels::{Pair, Places, ROOM, coefficient};

/// Pairs held before their forces are computed.
const HELD: usize = 512;
/// The most that one filtering may add.
pub const BATCH: usize = 128;

/// Pairs within the cutoff, waiting for their forces.
///
/// Nearly every pair of a neighbour list is too far apart. Asking each, with a branch, costs a
/// wrong guess of the processor for each that is not; here every pair is written down and the
/// next one overwrites it unless it touches. What remains is dense, so its square roots and
/// divisions fill vector registers.
pub struct Contacts {
    vectors: Vectors<HELD>,
    indices: Box<[u32; HELD]>,
    len: usize,
}

impl Default for Contacts {
    fn default() -> Self {
        Self { vectors: Vectors::default(), indices: Box::new([0; HELD]), len: 0 }
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
        self.len > HELD - BATCH
    }

    /// Keeps a pair at distance vector (`dx`, `dy`) for particle `index` if it is within the cutoff.
    #[inline(always)]
    pub fn offer(&mut self, index: u32, dx: f64, dy: f64) {
        let r2 = dx * dx + dy * dy;
        let place = self.len & (HELD - 1);
        self.vectors.dx[place] = dx;
        self.vectors.dy[place] = dy;
        self.vectors.r2[place] = r2;
        self.indices[place] = index;
        self.len += usize::from(r2 <= CUTOFF * CUTOFF);
    }

    /// Adds the accelerations of all pairs held to `ax[index]`, `ay[index]`, in the order in which
    /// they were offered, and forgets them.
    #[inline(always)]
    pub fn settle<O: Observer>(&mut self, ax: &mut [f64], ay: &mut [f64], observer: &mut O) {
        let len = std::mem::take(&mut self.len);
        self.vectors.accelerate(len);
        // A running sum for as long as the particle stays the same: a store for each pair, but no
        // load that would have to wait for it.
        let (mut last, mut sum_x, mut sum_y) = (u32::MAX, 0.0, 0.0);
        for k in 0..len {
            let index = self.indices[k];
            if index != last {
                (sum_x, sum_y) = (ax[index as usize], ay[index as usize]);
                last = index;
            }
            sum_x += self.vectors.dx[k];
            sum_y += self.vectors.dy[k];
            ax[index as usize] = sum_x;
            ay[index as usize] = sum_y;
            observer.seen(self.vectors.r2[k]);
        }
    }
}

/// Pairs within the cutoff, waiting for their forces. They stand close together, so that their
/// square roots and divisions fill vector registers.
pub(crate) struct Touching {
    pairs: Box<[Pair; ROOM]>,
    vectors: Vectors<ROOM>,
}

impl Default for Touching {
    fn default() -> Self {
        Self { pairs: Box::new([[0; 2]; ROOM]), vectors: Vectors::default() }
    }
}

impl Touching {
    /// Adds the accelerations of `pairs` to `sums`, which begin with particle `first`.
    #[inline(always)]
    pub(crate) fn feel<O: Observer>(
        &mut self,
        pairs: &[Pair],
        places: Places<'_>,
        first: usize,
        sums: &mut Sums,
        observer: &mut O,
    ) {
        let Places { x, y, first: start } = places;
        let y = &y[..x.len()];
        let to = |[i, j]: [u32; 2]| {
            let (i, j) = (i as usize - start, j as usize - start);
            (x[j] - x[i], y[j] - y[i])
        };
        for some in pairs.chunks(ROOM) {
            let len = filter(some, places, CUTOFF * CUTOFF, &mut self.pairs);
            let Vectors { dx, dy, r2 } = &mut self.vectors;
            for (k, &pair) in self.pairs[..len].iter().enumerate() {
                (dx[k], dy[k]) = to(pair);
                r2[k] = dx[k] * dx[k] + dy[k] * dy[k];
            }
            self.vectors.accelerate(len);
            self.apply(len, first, sums, observer);
        }
    }

    /// Adds what the first `len` pairs do to both of their particles.
    #[inline(always)]
    fn apply<O: Observer>(&self, len: usize, first: usize, sums: &mut Sums, observer: &mut O) {
        let Sums { x, y } = sums;
        let (x, y) = (&mut x[..], &mut y[..]);
        for (k, &[i, j]) in self.pairs[..len].iter().enumerate() {
            let (i, j) = (i as usize - first, j as usize - first);
            let (ax, ay) = (self.vectors.dx[k], self.vectors.dy[k]);
            x[i] += ax;
            y[i] += ay;
            x[j] -= ax;
            y[j] -= ay;
            observer.seen(self.vectors.r2[k]);
            observer.seen(self.vectors.r2[k]);
        }
    }
}

/// The accelerations of consecutive particles, the first of which their owner knows.
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

    /// Adds the sums of `other` from its `skip`-th on, as far as both reach.
    pub(crate) fn add(&mut self, other: &Self, skip: usize) {
        for (to, from) in [(&mut self.x, &other.x), (&mut self.y, &other.y)] {
            to.iter_mut().zip(&from[skip..]).for_each(|(to, from)| *to += from);
        }
    }
}
