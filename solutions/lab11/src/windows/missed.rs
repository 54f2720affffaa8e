//! Which batch computes a particle, and which pairs touched though no group computes them.

use common::soft::CUTOFF;
use solution10::Cells;
use solution10::kernels::{Pair, Signs};

use super::window::{LATE, Window};
use crate::flight::{closest_squared, too_far_off};
use crate::groups::{Batch, FREE};
use crate::search::{Layout, SweptBox, plain_near};

impl Window {
    /// The batch that computes a particle that is not free, and its slot there.
    #[inline]
    pub(crate) fn slot(&self, i: u32) -> Option<(&Batch, usize)> {
        let slot = self.slots[i as usize];
        if slot == FREE {
            return None;
        }
        if slot & LATE == 0 {
            // No band but the last holds fewer than its share, so it is this one or one before.
            let guess = (i as usize / self.share).min(self.bands.len() - 1);
            let own = self.bands[..=guess].iter().rfind(|b| b.particles.start <= i as usize);
            return own.map(|band| (&band.batch, slot as usize));
        }
        let slot = (slot & !LATE) as usize;
        let batch = &self.late[self.late.partition_point(|batch| batch.first <= slot) - 1];
        Some((batch, slot - batch.first))
    }

    /// Whether the two are a pair of one group.
    pub(crate) fn computes(&self, [i, k]: Pair) -> bool {
        self.slot(i).is_some_and(|(batch, p)| batch.groups.computes(&batch.groups.group(p), i, k))
    }

    /// Whether the watched pair may have touched, though no group computes it.
    #[inline(always)]
    pub(crate) fn may_have_touched(&self, [i, k]: Pair, layout: &Layout) -> bool {
        let (i, k) = (i as usize, k as usize);
        let off = f64::from(self.deviation[i]) + f64::from(self.deviation[k]);
        if !too_far_off(0.5 * off, layout.margin) {
            return false;
        }
        self.come_within(i, k, CUTOFF + off + layout.span.rounding(), layout)
    }

    /// Whether the free flights of two particles come within `near`.
    #[inline(always)]
    pub(crate) fn come_within(&self, i: usize, k: usize, near: f64, layout: &Layout) -> bool {
        let bodies = &self.bodies;
        let (dx, dy) = (bodies.x[k] - bodies.x[i], bodies.y[k] - bodies.y[i]);
        let (wx, wy) = (bodies.vx[k] - bodies.vx[i], bodies.vy[k] - bodies.vy[i]);
        closest_squared(dx, dy, wx, wy, layout.span.forces()) <= near * near
    }

    /// Whether a pair that is computed nowhere was in contact at any step.
    pub(crate) fn touched(&self, pair: Pair, layout: &Layout) -> bool {
        let span = &layout.span;
        let slots = pair.map(|i| self.slot(i));
        let paths = pair.map(|i| span.path(&self.bodies.get(i as usize)));
        let blocks = slots.map(|slot| {
            slot.map(|(batch, p)| {
                let block = batch.groups.block(p);
                let member = p - block.start;
                (batch, block, member)
            })
        });
        for step in 1..span.steps {
            let time = f64::from(step) * span.dt;
            let mut off = [(0.0, 0.0); 2];
            for (off, block) in off.iter_mut().zip(&blocks) {
                if let Some((batch, block, member)) = block {
                    *off = batch.record.off(block, *member, step as usize);
                }
            }
            let [(ax, ay), (bx, by)] = off;
            let dx = paths[1].x + paths[1].wx * time + bx - paths[0].x - paths[0].wx * time - ax;
            let dy = paths[1].y + paths[1].wy * time + by - paths[0].y - paths[0].wy * time - ay;
            // The distances off are rounded to single precision.
            let lost = 2.4e-7 * (ax.abs() + ay.abs() + bx.abs() + by.abs());
            let near = CUTOFF + lost + span.rounding();
            if dx * dx + dy * dy <= near * near {
                return true;
            }
        }
        false
    }
}

/// What is needed to look around a particle.
#[derive(Clone, Copy)]
pub(crate) struct Around<'a> {
    pub(crate) window: &'a Window,
    pub(crate) layout: &'a Layout,
    pub(crate) cells: &'a Cells,
}

impl Around<'_> {
    /// Appends to `list` all particles that may have touched particle `i`, special or not, and some
    /// more: particle `i` is `own` off its reference path, the other one up to `other`.
    pub(crate) fn all_near(
        &self,
        signs: impl Signs,
        i: u32,
        own: f64,
        other: f64,
        list: &mut Vec<u32>,
    ) {
        let Self { window, layout, cells } = *self;
        let bodies = &window.bodies;
        let near = CUTOFF + own + layout.span.rounding();
        let (_, asked) = SweptBox::of(bodies, layout, i, near + other);
        window.specials.near(&asked, |k| list.push(k));
        if layout.is_special(bodies, i as usize) {
            plain_near(bodies, cells, layout, &asked, |k| list.push(k));
            return;
        }
        if own + other <= 2.0 * CUTOFF {
            self.plain(signs, i, own, other, list);
            return;
        }
        let mut ranges = cells.rows_of(&self.rectangle(i, near + other));
        while let Some(range) = ranges.next(cells) {
            for k in range {
                if window.come_within(i as usize, k, near + f64::from(window.deviation[k]), layout)
                {
                    list.push(k as u32);
                }
            }
        }
    }

    /// As [`Around::all_near`], but only particles that are not special, as particle `i` is not, and
    /// for distances that are not much longer than a cell.
    #[inline(always)]
    pub(crate) fn plain(
        &self,
        signs: impl Signs,
        i: u32,
        own: f64,
        other: f64,
        list: &mut Vec<u32>,
    ) {
        let Self { window, layout, cells } = *self;
        let near = CUTOFF + own + layout.span.rounding();
        let limit = window.flights.limit(near);
        let mut ranges = cells.rows_of(&self.rectangle(i, near + other));
        while let Some(range) = ranges.next(cells) {
            window.flights.view().near(signs, i as usize, range, limit, &window.deviation, list);
        }
    }

    /// Where particles are halfway that may come within `near` of particle `i`.
    #[inline(always)]
    fn rectangle(&self, i: u32, near: f64) -> [f64; 4] {
        let (i, bodies, time) = (i as usize, &self.window.bodies, self.layout.span.forces());
        let (x, y) = (bodies.x[i], bodies.y[i]);
        let (dx, dy) = (bodies.vx[i] * time, bodies.vy[i] * time);
        let pad = near + 0.5 * self.layout.reach;
        [x + dx.min(0.0) - pad, x + dx.max(0.0) + pad, y + dy.min(0.0) - pad, y + dy.max(0.0) + pad]
    }
}
