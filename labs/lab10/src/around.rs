//! Who may have touched a particle that was pushed off its path.

use common::soft::CUTOFF;

use crate::Cells;
use crate::layout::Layout;
use crate::signs::Signs;
use crate::specials::{Swept, plain_near};
use crate::window::Window;

/// Where somebody looks around.
#[derive(Clone, Copy)]
pub(crate) struct Around<'a> {
    pub(crate) window: &'a Window,
    pub(crate) layout: &'a Layout,
    pub(crate) cells: &'a Cells,
}

impl Around<'_> {
    /// Appends to `list` everybody who may have touched particle `i`, special or not, and some
    /// others: the particle is `own` off its reference path, the others up to `other`.
    pub(crate) fn everybody(
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
        let (_, asked) = Swept::of(bodies, layout, i, near + other);
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
                if window.come_within(i as usize, k, near + f64::from(window.bent[k]), layout) {
                    list.push(k as u32);
                }
            }
        }
    }

    /// As [`Around::everybody`], but only those that are not special, as particle `i` is not, and
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
            window.flights.view().near(signs, i as usize, range, limit, &window.bent, list);
        }
    }

    /// Where those are halfway who may come within `near` of particle `i`.
    #[inline(always)]
    fn rectangle(&self, i: u32, near: f64) -> [f64; 4] {
        let (i, bodies, time) = (i as usize, &self.window.bodies, self.layout.span.forces());
        let (x, y) = (bodies.x[i], bodies.y[i]);
        let (way_x, way_y) = (bodies.vx[i] * time, bodies.vy[i] * time);
        let pad = near + 0.5 * self.layout.reach;
        [
            x + way_x.min(0.0) - pad,
            x + way_x.max(0.0) + pad,
            y + way_y.min(0.0) - pad,
            y + way_y.max(0.0) + pad,
        ]
    }
}
