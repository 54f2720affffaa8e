//! One pass over a block: forces and move, piece by piece, while a piece is in the cache.
//!
//! A pair is listed with the particle that comes first, so once a piece and all before it are
//! through their pairs, its old positions are no longer needed and its sums are complete. It can
//! move at once. Pairs across the end of a block were computed before any block moves.

use common::soft::Observer;
use pulp::NullaryFnOnce;

use super::across::Across;
use super::external::External;
use crate::kernels::{Contacts, Positions};
use crate::list::{Block, Fast, SpeedLimit};
use crate::particles::Moving;

/// What the pass over a block needs and leaves.
#[derive(Default)]
pub(super) struct Pass {
    /// The accelerations of the block's particles.
    ax: Vec<f64>,
    ay: Vec<f64>,
    contacts: Contacts,
    /// Particles seen to exceed the speed limit since the inner list was made.
    pub(super) fast: Fast,
}

/// Accelerations of consecutive particles that are added up.
struct Sums<'a> {
    x: &'a mut [f64],
    y: &'a mut [f64],
    first: usize,
}

impl Sums<'_> {
    #[inline(always)]
    fn add(&mut self, i: u32, [x, y]: [f64; 2]) {
        self.x[i as usize - self.first] += x;
        self.y[i as usize - self.first] += y;
    }
}

/// The forces on a block and its move by `dt` in a box of side `size`.
pub(super) struct Sweep<'a, O> {
    pub(super) block: &'a Block,
    pub(super) pass: &'a mut Pass,
    pub(super) across: &'a Across,
    pub(super) external: External<'a>,
    pub(super) moving: Moving<'a>,
    pub(super) dt: f64,
    pub(super) size: f64,
    pub(super) limit: SpeedLimit<'a>,
    pub(super) observer: &'a mut O,
}

impl<O: Observer> NullaryFnOnce for Sweep<'_, O> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        let Self { block, pass, across, external, mut moving, dt, size, limit, observer } = self;
        let Pass { ax, ay, contacts, fast } = pass;
        let (start, list) = (block.particles.start, block.pairs());
        for sums in [&mut *ax, &mut *ay] {
            sums.clear();
            sums.resize(block.particles.len(), 0.0);
        }
        let mut sums = Sums { x: ax, y: ay, first: start };
        across.into(&block.particles).for_each(|(j, [x, y])| sums.add(j, [-x, -y]));
        fast.over = 1.0;
        let mut pairs = 0;
        for (piece, &end) in block.pieces().zip(&list.ends) {
            let positions = Positions { x: moving.x, y: moving.y, first: start };
            contacts.for_each(&list.inside[pairs..end], positions, |[i, j], [x, y], r2| {
                sums.add(i, [x, y]);
                sums.add(j, [-x, -y]);
                observer.seen(r2);
                observer.seen(r2);
            });
            across.from(&piece).chain(external.among(&piece)).for_each(|(i, a)| sums.add(i, a));
            let own = piece.start - start..piece.end - start;
            let mut particles = moving.part(own.clone());
            particles.advance(&sums.x[own.clone()], &sums.y[own], dt, size);
            limit.watch(piece.start, particles.vx, particles.vy, fast);
            pairs = end;
        }
    }
}
