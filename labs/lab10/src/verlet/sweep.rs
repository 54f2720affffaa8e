//! One pass over a block: forces and move, piece by piece, while a piece is in the cache.
//!
//! A pair is listed with the particle that comes first, so once a piece and all before it are
//! through their pairs, its old positions are no longer needed and its sums are complete. It can
//! move at once. Pairs across the end of a block were computed before any block moves.

use common::soft::Observer;
use pulp::NullaryFnOnce;
use solution1::bounce;

use super::across::Across;
use super::contacts::Contacts;
use super::pushes::Pushes;
use super::sums::Sums;
use crate::drift::drift;
use crate::kernels::Places;
use crate::list::{Block, Fast, SpeedLimit};

/// Particles whose walls are tested together.
const CHUNK: usize = 64;

/// What the pass over a block needs and leaves.
#[derive(Default)]
pub(super) struct Pass {
    sums: Sums,
    contacts: Contacts,
    /// Particles seen to exceed the speed limit since the inner list was made.
    pub(super) fast: Fast,
}

/// The particles of a block.
pub(super) struct Moving<'a> {
    pub(super) x: &'a mut [f64],
    pub(super) y: &'a mut [f64],
    pub(super) vx: &'a mut [f64],
    pub(super) vy: &'a mut [f64],
}

/// The forces on a block and its move by `dt` in a box of side `size`.
pub(super) struct Sweep<'a, O> {
    pub(super) block: &'a Block,
    pub(super) pass: &'a mut Pass,
    pub(super) across: &'a Across,
    pub(super) pushes: Pushes<'a>,
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
        let Self { block, pass, across, pushes, moving, dt, size, limit, observer } = self;
        let Pass { sums, contacts, fast } = pass;
        let (start, list) = (block.particles.start, block.pairs());
        let (mut first, mut pairs) = (start, 0);
        fast.over = 1.0;
        sums.begin(start);
        sums.add_from_before(across, &block.particles);
        for piece in &list.pieces {
            sums.reach(piece.ahead);
            let places = Places { x: moving.x, y: moving.y, first: start };
            contacts.for_each(&list.inside[pairs..piece.pairs], places, |[i, j], [x, y], r2| {
                sums.add(i, x, y);
                sums.add(j, -x, -y);
                observer.seen(r2);
                observer.seen(r2);
            });
            let range = first..piece.particles;
            sums.add_from_behind(across, &range);
            pushes.among(&range).add_to(sums);
            let (ax, ay) = sums.until(range.end);
            let own = first - start..range.end - start;
            let (x, y) = (&mut moving.x[own.clone()], &mut moving.y[own.clone()]);
            let (vx, vy) = (&mut moving.vx[own.clone()], &mut moving.vy[own]);
            move_axis(x, vx, ax, dt, size);
            move_axis(y, vy, ay, dt, size);
            limit.watch(first, vx, vy, fast);
            sums.drop_until(range.end);
            (first, pairs) = (range.end, piece.pairs);
        }
    }
}

/// Moves one coordinate, and reflects what left the box.
#[inline(always)]
fn move_axis(x: &mut [f64], v: &mut [f64], a: &[f64], dt: f64, size: f64) {
    for ((x, v), a) in x.chunks_mut(CHUNK).zip(v.chunks_mut(CHUNK)).zip(a.chunks(CHUNK)) {
        if drift(x, v, a, dt, size) {
            for (x, v) in x.iter_mut().zip(v) {
                (*x, *v) = bounce(*x, *v, size);
            }
        }
    }
}
