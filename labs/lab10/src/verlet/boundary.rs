//! Where two blocks meet.
//!
//! The first particles of a block move when it and the blocks before it are through with their
//! pairs: the thread that is through last moves them.

use std::sync::{Mutex, MutexGuard, PoisonError};

use pulp::{Arch, NullaryFnOnce};

use super::forces::Sums;
use super::sweep::{Moving, Stride};
use crate::list::Fast;

/// The beginning of a block that is through with its pairs.
pub(crate) struct Head<'a> {
    /// The place of its first particle.
    pub(crate) first: usize,
    /// The particles that were held back.
    pub(crate) moving: Moving<'a>,
    pub(crate) stride: Stride<'a>,
    /// Their accelerations by the block's own pairs.
    pub(crate) own: &'a mut Sums,
    pub(crate) fast: &'a mut Fast,
    /// Of a block that is shorter than what the one before it sees ahead, and so held back as a
    /// whole: its own pushes on the particles behind it.
    pub(crate) beyond: Option<&'a mut Sums>,
}

/// The beginnings of all blocks.
pub(crate) struct Boundaries<'a> {
    all: Vec<Mutex<Boundary<'a>>>,
}

#[derive(Default)]
struct Boundary<'a> {
    /// The accelerations that the blocks before add behind their end.
    pushes: Option<&'a Sums>,
    head: Option<Head<'a>>,
}

impl<'a> Boundaries<'a> {
    /// The boundaries of `blocks` blocks.
    pub(crate) fn of(blocks: usize) -> Self {
        Self { all: std::iter::repeat_with(Mutex::default).take(blocks + 1).collect() }
    }

    /// The block is through with its pairs.
    pub(crate) fn bring_head(&self, block: usize, head: Head<'a>) {
        let mut boundary = self.lock(block);
        boundary.head = Some(head);
        self.close(block, boundary);
    }

    /// The accelerations that the blocks before add to `block` are known.
    pub(crate) fn bring_pushes(&self, block: usize, pushes: &'a Sums) {
        let mut boundary = self.lock(block);
        boundary.pushes = Some(pushes);
        self.close(block, boundary);
    }

    fn lock(&self, block: usize) -> MutexGuard<'_, Boundary<'a>> {
        self.all[block].lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Moves the beginning of the block if both are there.
    fn close(&self, block: usize, mut boundary: MutexGuard<'_, Boundary<'a>>) {
        if boundary.pushes.is_none() {
            return;
        }
        let Some(head) = boundary.head.take() else { return };
        let Some(pushes) = boundary.pushes.take() else { return };
        drop(boundary);
        let Head { first, moving, stride, own, fast, beyond } = head;
        own.add(pushes, 0);
        Arch::new().dispatch(MoveHead { first, own, moving, stride, fast });
        if let Some(sums) = beyond {
            sums.reach(pushes.len() - own.len());
            sums.add(pushes, own.len());
            self.bring_pushes(block + 1, sums);
        }
    }
}

/// The move of the particles from `first` on.
struct MoveHead<'a> {
    first: usize,
    own: &'a Sums,
    moving: Moving<'a>,
    stride: Stride<'a>,
    fast: &'a mut Fast,
}

impl NullaryFnOnce for MoveHead<'_> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        let Self { first, own, mut moving, stride, fast } = self;
        moving.advance(0..own.len(), first, (&own.x, &own.y), &stride, fast);
    }
}
