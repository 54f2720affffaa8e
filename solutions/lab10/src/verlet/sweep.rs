//! One pass over a block: forces and move, piece by piece, while a piece is in the cache.
//!
//! A pair is listed with the particle that comes first, so once a piece and all before it are
//! through their pairs, its old places are no longer needed and its sums are complete. It can
//! move at once. Two things cross the end of a block. Its last pieces push the first particles of
//! the next block: what they add is left over in `sums`, and the particles pushed, `held` back,
//! move when both blocks are done, in `boundary.rs`. And they read the old places there, perhaps
//! after the next block has moved: so they read copies, the block's ghosts.

use std::ops::Range;

use common::soft::Observer;
use pulp::NullaryFnOnce;
use solution1::bounce;

use super::forces::{Sums, Touching};
use super::pushes::Pushes;
use crate::drift::drift;
use crate::kernels::Places;
use crate::list::{Block, Fast, SpeedLimit};

/// Particles whose walls are tested together.
const CHUNK: usize = 64;

/// What the pass over a block needs and leaves.
#[derive(Default)]
pub(crate) struct Pass {
    /// Particles at the beginning of the block that earlier blocks may push.
    pub(crate) held: usize,
    /// Whether blocks before it see beyond its end.
    pub(crate) is_overrun: bool,
    /// The accelerations of the `held` particles by the block's own pairs.
    pub(crate) own: Sums,
    /// Accelerations of the piece and of the particles ahead of it; in the end of the particles
    /// behind the block.
    pub(crate) sums: Sums,
    /// The particles behind the block that its pairs read.
    pub(crate) ghosts: Ghosts,
    /// Particles seen to exceed the speed limit since the short list was made.
    pub(crate) fast: Fast,
    touching: Touching,
}

/// Consecutive particles that move.
pub(crate) struct Moving<'a> {
    pub(crate) x: &'a mut [f64],
    pub(crate) y: &'a mut [f64],
    pub(crate) vx: &'a mut [f64],
    pub(crate) vy: &'a mut [f64],
}

/// The step that they take.
#[derive(Clone, Copy)]
pub(crate) struct Stride<'a> {
    pub(crate) dt: f64,
    pub(crate) size: f64,
    pub(crate) limit: SpeedLimit<'a>,
}

/// The forces on a block and its move.
pub(crate) struct Sweep<'a, O> {
    pub(crate) block: &'a Block,
    pub(crate) pass: &'a mut Pass,
    pub(crate) pushes: Pushes<'a>,
    pub(crate) moving: Moving<'a>,
    pub(crate) stride: Stride<'a>,
    pub(crate) observer: &'a mut O,
}

impl<O: Observer> NullaryFnOnce for Sweep<'_, O> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        let Self { block, pass, pushes, mut moving, stride, observer } = self;
        let Pass { held, own, sums, ghosts, touching, fast, .. } = pass;
        own.clear();
        sums.clear();
        let Range { start, end: last } = block.particles;
        let (list, mut first, mut pairs) = (block.pairs(), start, 0);
        for piece in &list.pieces {
            sums.reach(piece.ahead - first);
            let places = if piece.ahead <= last {
                Places { x: moving.x, y: moving.y, first: start }
            } else {
                let done = first - start;
                ghosts.behind(&moving.x[done..], &moving.y[done..], first)
            };
            touching.feel(&list.pairs[pairs..piece.pairs], places, first, sums, observer);
            let end = piece.particles;
            pushes.among(&(first..end)).add_to(sums, first);
            let free = (start + *held).clamp(first, end);
            own.extend(sums, free - first);
            let accelerations = (&sums.x[free - first..], &sums.y[free - first..]);
            moving.advance(free - start..end - start, start, accelerations, &stride, fast);
            sums.drop_first(end - first);
            (first, pairs) = (end, piece.pairs);
        }
    }
}

impl<'a> Moving<'a> {
    /// The first `n` of them.
    pub(crate) fn first(self, n: usize) -> Self {
        let Self { x, y, vx, vy } = self;
        Self { x: &mut x[..n], y: &mut y[..n], vx: &mut vx[..n], vy: &mut vy[..n] }
    }

    /// All of them, for a while.
    pub(crate) fn reborrow(&mut self) -> Moving<'_> {
        Moving { x: self.x, y: self.y, vx: self.vx, vy: self.vy }
    }

    /// Moves the particles in `range`, counted from particle `first`, and notes the fast ones.
    #[inline(always)]
    pub(crate) fn advance(
        &mut self,
        range: Range<usize>,
        first: usize,
        (ax, ay): (&[f64], &[f64]),
        stride: &Stride<'_>,
        fast: &mut Fast,
    ) {
        let (x, vx) = (&mut self.x[range.clone()], &mut self.vx[range.clone()]);
        let (y, vy) = (&mut self.y[range.clone()], &mut self.vy[range.clone()]);
        move_axis(x, vx, ax, stride);
        move_axis(y, vy, ay, stride);
        stride.limit.watch(first + range.start, vx, vy, fast);
    }
}

/// Moves one coordinate, and reflects what left the box.
#[inline(always)]
fn move_axis(x: &mut [f64], v: &mut [f64], a: &[f64], stride: &Stride<'_>) {
    let Stride { dt, size, .. } = *stride;
    for ((x, v), a) in x.chunks_mut(CHUNK).zip(v.chunks_mut(CHUNK)).zip(a.chunks(CHUNK)) {
        if drift(x, v, &a[..x.len()], dt, size) {
            for (x, v) in x.iter_mut().zip(v) {
                (*x, *v) = bounce(*x, *v, size);
            }
        }
    }
}

/// Where the first particles behind a block stood before any moved.
///
/// The last pieces of a block feel them, perhaps when the next block has moved already.
#[derive(Default)]
pub(crate) struct Ghosts {
    x: Vec<f64>,
    y: Vec<f64>,
    joined_x: Vec<f64>,
    joined_y: Vec<f64>,
}

impl Ghosts {
    /// Copies the places of particles that stand behind the block.
    pub(crate) fn copy(&mut self, x: &[f64], y: &[f64]) {
        for (to, from) in [(&mut self.x, x), (&mut self.y, y)] {
            to.clear();
            to.extend_from_slice(from);
        }
    }

    /// The places of the block's last particles, which begin with particle `first`, and behind
    /// them the copies.
    #[inline(always)]
    pub(crate) fn behind<'a>(&'a mut self, x: &[f64], y: &[f64], first: usize) -> Places<'a> {
        let Self { x: ghosts_x, y: ghosts_y, joined_x, joined_y } = self;
        for (to, own, ghosts) in [(&mut *joined_x, x, &*ghosts_x), (&mut *joined_y, y, &*ghosts_y)]
        {
            to.clear();
            to.extend_from_slice(own);
            to.extend_from_slice(ghosts);
        }
        Places { x: joined_x, y: joined_y, first }
    }
}
