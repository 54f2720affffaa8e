//! A step under way: which blocks move when.

use common::soft::Observer;
use pulp::Arch;

use super::boundary::{Boundaries, Head};
use super::pushes::Pushes;
use super::sweep::{Moving, Pass, Stride, Sweep};
use crate::list::{Block, Limits};
use crate::particles::Bodies;
use crate::threads::{Workers, cut};

/// A step of an engine, in two parts: blocks that only the engine's own particles push, and blocks
/// that wait for pushes from elsewhere. All blocks have to move.
pub struct Step<'a, O> {
    workers: Workers,
    limits: &'a Limits,
    dt: f64,
    size: f64,
    boundaries: Boundaries<'a>,
    inner: Vec<Work<'a>>,
    outer: Vec<Work<'a>>,
    observer: &'a mut O,
}

/// A block and its particles.
pub(super) struct Work<'a> {
    number: usize,
    block: &'a Block,
    pass: &'a mut Pass,
    moving: Moving<'a>,
}

impl<'a> Work<'a> {
    /// All blocks of a list, each with its particles among `bodies`.
    pub(super) fn all(
        blocks: &'a [Block],
        passes: &'a mut [Pass],
        bodies: &'a mut Bodies,
    ) -> Vec<Self> {
        let ends = || blocks.iter().map(|block| block.particles.end);
        let places = cut(&mut bodies.x, ends()).into_iter().zip(cut(&mut bodies.y, ends()));
        let speeds = cut(&mut bodies.vx, ends()).into_iter().zip(cut(&mut bodies.vy, ends()));
        let work = blocks.iter().zip(passes).zip(places.zip(speeds)).enumerate();
        work.map(|(number, ((block, pass), ((x, y), (vx, vy))))| Self {
            number,
            block,
            pass,
            moving: Moving { x, y, vx, vy },
        })
        .collect()
    }
}

impl<'a, O: Observer> Step<'a, O> {
    /// A step of `dt` in a box of side `size`. Particles elsewhere push those in the places
    /// `pushed`, ascending.
    pub(super) fn new(
        workers: Workers,
        limits: &'a Limits,
        (dt, size): (f64, f64),
        work: Vec<Work<'a>>,
        pushed: &[u32],
        observer: &'a mut O,
    ) -> Self {
        let boundaries = Boundaries::of(work.len());
        let waits = |work: &Work| {
            let next =
                pushed.partition_point(|&place| (place as usize) < work.block.particles.start);
            pushed.get(next).is_some_and(|&place| (place as usize) < work.block.particles.end)
        };
        let (outer, inner) = work.into_iter().partition(waits);
        Self { workers, limits, dt, size, boundaries, inner, outer, observer }
    }

    /// Forces and move of the blocks without a particle that waits.
    pub fn move_inner(&mut self) {
        let inner = std::mem::take(&mut self.inner);
        self.sweep(inner, Pushes::default());
    }

    /// Forces and move of the other blocks, with the pushes that they waited for.
    pub fn move_outer(mut self, pushes: Pushes<'_>) {
        let outer = std::mem::take(&mut self.outer);
        self.sweep(outer, pushes);
    }

    fn sweep(&mut self, work: Vec<Work<'a>>, pushes: Pushes<'_>) {
        let Self { workers, limits, boundaries, .. } = self;
        let (dt, size, limits, arch) = (self.dt, self.size, *limits, Arch::new());
        let observers = workers.map(work, |Work { number, block, pass, mut moving }| {
            let stride = Stride { dt, size, limit: limits.speed_limit(&block.particles) };
            let mut observer = O::default();
            pass.fast.over = 1.0;
            let pushes = pushes.among(&block.particles);
            let now = moving.reborrow();
            arch.dispatch(Sweep {
                block,
                pass,
                pushes,
                moving: now,
                stride,
                observer: &mut observer,
            });
            let Pass { held, is_overrun, own, sums, fast, .. } = pass;
            let (first, moving) = (block.particles.start, moving.first(*held));
            let beyond = if *is_overrun {
                Some(sums)
            } else {
                boundaries.bring_pushes(number + 1, sums);
                None
            };
            boundaries.bring_head(number, Head { first, moving, stride, own, fast, beyond });
            observer
        });
        observers.iter().for_each(|observer| self.observer.merge(observer));
    }
}
