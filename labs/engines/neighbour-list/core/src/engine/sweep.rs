//! One pass over a block: computes forces and moves particles, while a piece is in the cache.
//!
//! A pair is listed with the particle that comes first. Once the pairs of a piece and of all pieces
//! before it are done, no later pair needs the piece's old positions, and the piece's accelerations
//! are complete. So the piece can move immediately. The pairs across the ends of blocks are
//! computed before any block moves.

use common::soft::Observer;
use pulp::NullaryFnOnce;

use super::across::{Across, External};
use super::sums::Sums;
use crate::kernels::{Contacts, Positions, Primitives};
use crate::list::{Block, Fast, Piece, SpeedLimit};
use crate::particles::Moving;

/// The working memory of the pass over a block, kept from step to step.
#[derive(Default)]
pub(super) struct Pass<P> {
    sums: Sums,
    contacts: Contacts<P>,
    /// The particles that have exceeded the speed limit since the inner list was built.
    pub(super) fast: Fast,
}

/// A vector kernel that computes the forces on a block and moves it by `dt` in a box of side
/// `size`.
pub(super) struct Sweep<'a, O, P> {
    pub(super) block: &'a Block,
    pub(super) pass: &'a mut Pass<P>,
    pub(super) across: &'a Across<P>,
    pub(super) external: External<'a>,
    pub(super) moving: Moving<'a>,
    pub(super) dt: f64,
    pub(super) size: f64,
    pub(super) limit: SpeedLimit<'a>,
    pub(super) observer: &'a mut O,
}

impl<O: Observer, P: Primitives> NullaryFnOnce for Sweep<'_, O, P> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        let Self { block, pass, across, external, mut moving, dt, size, limit, observer } = self;
        let Pass { sums, contacts, fast } = pass;
        let start = block.particles.start;
        let list = block.pairs();
        sums.begin(start);
        across.into(&block.particles).for_each(|(j, [x, y])| {
            sums.extend_to(j as usize + 1);
            sums.add(j, [-x, -y]);
        });
        fast.over = 1.0;
        let mut begin = 0;
        for (piece, &Piece { pairs, ahead }) in block.pieces().zip(&list.pieces) {
            sums.extend_to(ahead);
            let positions = Positions { x: moving.x, y: moving.y, first: start };
            contacts.for_each(&list.inside[begin..pairs], positions, |[i, j], [x, y], r2| {
                sums.add(i, [x, y]);
                sums.add(j, [-x, -y]);
                observer.seen(r2);
                observer.seen(r2);
            });
            across.from(&piece).chain(external.among(&piece)).for_each(|(i, a)| sums.add(i, a));
            let mut particles = moving.part(piece.start - start..piece.end - start);
            let (ax, ay) = sums.first(piece.len());
            particles.advance::<P>(ax, ay, dt, size);
            limit.watch(piece.start, particles.vx, particles.vy, fast);
            sums.drop_first(piece.len());
            begin = pairs;
        }
    }
}
