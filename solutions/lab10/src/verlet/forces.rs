//! Pairs that really touch: filtered from many that might, then computed side by side.

use std::ops::Range;

use common::soft::{CUTOFF, Observer};

use crate::filter::filter;
use crate::kernels::{Pair, Places, ROOM, coefficient};
use crate::list::Block;

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
    /// Calls `each` with the pairs that are within the cutoff, in their order, and the acceleration of the
    /// first particle of each.
    #[inline(always)]
    pub(crate) fn for_each<O: Observer>(
        &mut self,
        pairs: &[Pair],
        places: Places<'_>,
        observer: &mut O,
        mut each: impl FnMut(Pair, f64, f64),
    ) {
        let Places { x, y, first } = places;
        let y = &y[..x.len()];
        for some in pairs.chunks(ROOM) {
            let len = filter(some, places, CUTOFF * CUTOFF, &mut self.pairs);
            let Vectors { dx, dy, r2 } = &mut self.vectors;
            for (k, pair) in self.pairs[..len].iter().enumerate() {
                let [i, j] = pair.map(|i| i as usize - first);
                (dx[k], dy[k]) = (x[j] - x[i], y[j] - y[i]);
                r2[k] = dx[k] * dx[k] + dy[k] * dy[k];
            }
            self.vectors.accelerate(len);
            let Vectors { dx, dy, r2 } = &self.vectors;
            for (k, &pair) in self.pairs[..len].iter().enumerate() {
                each(pair, dx[k], dy[k]);
                observer.seen(r2[k]);
                observer.seen(r2[k]);
            }
        }
    }
}

/// The pairs within the cutoff whose particles are in two blocks, in ascending order of the first particle.
#[derive(Default)]
pub(crate) struct Across {
    touching: Touching,
    pairs: Vec<(Pair, [f64; 2])>,
}

impl Across {
    /// Finds them, before any block moves.
    pub(crate) fn find<O: Observer>(
        &mut self,
        blocks: &[Block],
        places: Places<'_>,
        observer: &mut O,
    ) {
        self.pairs.clear();
        for block in blocks {
            let Self { touching, pairs } = self;
            let across = &block.pairs().across;
            touching
                .for_each(across, places, observer, |pair, ax, ay| pairs.push((pair, [ax, ay])));
        }
    }

    /// The pairs whose first particle is in `range`.
    fn from(&self, range: &Range<usize>) -> &[(Pair, [f64; 2])] {
        let before = |end| self.pairs.partition_point(|(pair, _)| (pair[0] as usize) < end);
        &self.pairs[before(range.start)..before(range.end)]
    }
}

/// The accelerations of consecutive particles.
#[derive(Default)]
pub(crate) struct Sums {
    /// The first particle.
    first: usize,
    x: Vec<f64>,
    y: Vec<f64>,
}

impl Sums {
    /// Begins anew with particle `first`.
    pub(crate) fn begin(&mut self, first: usize) {
        self.first = first;
        self.x.clear();
        self.y.clear();
    }

    /// Begins with zero for the particles after the last, up to particle `end`; if there are as many,
    /// nothing happens.
    #[inline(always)]
    pub(crate) fn reach(&mut self, end: usize) {
        let len = end - self.first;
        if len > self.x.len() {
            self.x.resize(len, 0.0);
            self.y.resize(len, 0.0);
        }
    }

    /// Forgets the particles before `first`.
    #[inline(always)]
    pub(crate) fn drop_until(&mut self, first: usize) {
        let k = first - self.first;
        for sums in [&mut self.x, &mut self.y] {
            sums.copy_within(k.., 0);
            sums.truncate(sums.len() - k);
        }
        self.first = first;
    }

    /// Of the particles up to `end`.
    #[inline(always)]
    pub(crate) fn until(&self, end: usize) -> (&[f64], &[f64]) {
        let len = end - self.first;
        (&self.x[..len], &self.y[..len])
    }

    #[inline(always)]
    pub(crate) fn add(&mut self, i: u32, ax: f64, ay: f64) {
        let i = i as usize - self.first;
        self.x[i] += ax;
        self.y[i] += ay;
    }

    /// Adds the accelerations of the block's particles by particles of earlier blocks.
    #[inline(always)]
    pub(crate) fn add_from_before(&mut self, across: &Across, block: &Range<usize>) {
        for &([_, j], [ax, ay]) in &across.pairs {
            if block.contains(&(j as usize)) {
                self.reach(j as usize + 1);
                self.add(j, -ax, -ay);
            }
        }
    }

    /// Adds the accelerations of the particles of `piece` by particles of later blocks.
    #[inline(always)]
    pub(crate) fn add_from_behind(&mut self, across: &Across, piece: &Range<usize>) {
        for &([i, _], [ax, ay]) in across.from(piece) {
            self.add(i, ax, ay);
        }
    }
}
