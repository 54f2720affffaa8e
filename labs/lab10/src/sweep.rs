//! One pass over a block: forces and move, piece by piece, while a piece is in the cache.
//!
//! A pair is listed with the particle that comes first, so once a piece and all before it are
//! through their pairs, nobody asks for its old places any more and its sums are complete. It can
//! move at once. Two things cross the end of a block. Its last pieces push the first particles of
//! the next block: what they add is left over in `sums`. And they read the old places there,
//! perhaps after the next block has moved: so places are moved into another array, and the first
//! particles of a block, `held` back, move when all blocks are done.

use common::soft::Observer;
use pulp::NullaryFnOnce;
use solution1::bounce;

use crate::lanes::{drift, larger};
use crate::list::Block;
use crate::sums::Sums;
use crate::touching::Touching;

/// Particles whose walls are tested together.
const CHUNK: usize = 64;

/// What the pass over a block needs and leaves.
#[derive(Default)]
pub(crate) struct Pass {
    /// Particles at the beginning of the block that others may push.
    pub(crate) held: usize,
    /// Their accelerations by the block's own pairs.
    pub(crate) own: Sums,
    /// Accelerations of the piece and of those ahead of it; in the end of those behind the block.
    pub(crate) sums: Sums,
    touching: Touching,
}

/// Particles that move: the old places of consecutive ones, and where the new ones go.
pub(crate) struct Moving<'a> {
    pub(crate) old_x: &'a [f64],
    pub(crate) old_y: &'a [f64],
    pub(crate) x: &'a mut [f64],
    pub(crate) y: &'a mut [f64],
    pub(crate) vx: &'a mut [f64],
    pub(crate) vy: &'a mut [f64],
}

/// The step that they take.
#[derive(Clone, Copy)]
pub(crate) struct Stride {
    pub(crate) dt: f64,
    pub(crate) size: f64,
}

/// The forces on a block and its move; brings back the square of the greatest speed.
pub(crate) struct Sweep<'a, O> {
    pub(crate) block: &'a Block,
    pub(crate) pass: &'a mut Pass,
    /// The old places of all.
    pub(crate) places: (&'a [f64], &'a [f64]),
    /// The block's own.
    pub(crate) moving: Moving<'a>,
    pub(crate) stride: Stride,
    pub(crate) observer: &'a mut O,
}

impl<O: Observer> NullaryFnOnce for Sweep<'_, O> {
    type Output = f64;

    #[inline(always)]
    fn call(self) -> f64 {
        let Self { block, pass, places: (x, y), mut moving, stride, observer } = self;
        let Pass { held, own, sums, touching } = pass;
        own.clear();
        sums.clear();
        let start = block.particles.start;
        let (mut first, mut pairs, mut fastest) = (start, 0, 0.0);
        for piece in &block.pieces {
            sums.reach(piece.ahead - first);
            touching.feel(&block.pairs[pairs..piece.pairs], x, y, first, sums, observer);
            let end = piece.particles;
            let free = (start + *held).clamp(first, end);
            own.extend(sums, free - first);
            let accelerations = (&sums.x[free - first..], &sums.y[free - first..]);
            let speed = moving.advance(free - start..end - start, accelerations, stride);
            fastest = larger(speed, fastest);
            sums.drop_first(end - first);
            (first, pairs) = (end, piece.pairs);
        }
        fastest
    }
}

/// The move of those who were held back; brings back the square of the greatest speed.
pub(crate) struct MoveHeld<'a> {
    pub(crate) own: &'a Sums,
    pub(crate) moving: Moving<'a>,
    pub(crate) stride: Stride,
}

impl NullaryFnOnce for MoveHeld<'_> {
    type Output = f64;

    #[inline(always)]
    fn call(mut self) -> f64 {
        self.moving.advance(0..self.own.len(), (&self.own.x, &self.own.y), self.stride)
    }
}

impl Moving<'_> {
    /// Moves those in `range` and brings back the square of their greatest speed.
    #[inline(always)]
    fn advance(
        &mut self,
        range: std::ops::Range<usize>,
        (ax, ay): (&[f64], &[f64]),
        stride: Stride,
    ) -> f64 {
        let (x, vx) = (&mut self.x[range.clone()], &mut self.vx[range.clone()]);
        let (y, vy) = (&mut self.y[range.clone()], &mut self.vy[range.clone()]);
        move_axis(&self.old_x[range.clone()], x, vx, ax, stride);
        move_axis(&self.old_y[range], y, vy, ay, stride);
        fastest_squared(vx, vy)
    }
}

/// Moves one coordinate, and brings back who left the box.
#[inline(always)]
fn move_axis(old: &[f64], x: &mut [f64], v: &mut [f64], a: &[f64], stride: Stride) {
    let Stride { dt, size } = stride;
    x.copy_from_slice(old);
    for ((x, v), a) in x.chunks_mut(CHUNK).zip(v.chunks_mut(CHUNK)).zip(a.chunks(CHUNK)) {
        if drift(x, v, &a[..x.len()], dt, size) {
            for (x, v) in x.iter_mut().zip(v) {
                (*x, *v) = bounce(*x, *v, size);
            }
        }
    }
}

/// The square of the greatest speed.
#[inline(always)]
fn fastest_squared(vx: &[f64], vy: &[f64]) -> f64 {
    let mut fastest = [0.0; 8];
    let (mut eights_x, mut eights_y) = (vx.chunks_exact(8), vy.chunks_exact(8));
    for (vx, vy) in eights_x.by_ref().zip(eights_y.by_ref()) {
        for l in 0..8 {
            fastest[l] = larger(vx[l] * vx[l] + vy[l] * vy[l], fastest[l]);
        }
    }
    for (vx, vy) in eights_x.remainder().iter().zip(eights_y.remainder()) {
        fastest[0] = larger(vx * vx + vy * vy, fastest[0]);
    }
    fastest.into_iter().fold(0.0, f64::max)
}
