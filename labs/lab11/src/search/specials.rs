//! Particles that are looked after one by one: the very fast, and the ones that may reach a wall.

use common::soft::CUTOFF;
use solution10::kernels::EIGHT;
use solution10::{Bodies, Cells};

use super::found::Found;
use super::layout::Layout;
use crate::flight::{Path, Span};

/// A box that a particle's reference path stays in.
#[derive(Clone, Copy)]
pub(crate) struct SweptBox {
    left: f64,
    right: f64,
    bottom: f64,
    top: f64,
    index: u32,
}

impl SweptBox {
    pub(crate) fn of(bodies: &Bodies, layout: &Layout, index: u32, pad: f64) -> (Path, Self) {
        let path = layout.span.path(&bodies.get(index as usize));
        let (pad, whole) = (pad + path.spread, layout.span.whole());
        let (end_x, end_y) = (path.x + path.wx * whole, path.y + path.wy * whole);
        let swept = Self {
            left: path.x.min(end_x) - pad,
            right: path.x.max(end_x) + pad,
            bottom: path.y.min(end_y) - pad,
            top: path.y.max(end_y) + pad,
            index,
        };
        (path, swept)
    }
}

/// The special particles of a window, by the left ends of their paths.
#[derive(Default)]
pub(crate) struct Specials {
    swept: Vec<SweptBox>,
    widest: f64,
}

impl Specials {
    pub(crate) fn new(
        bodies: &Bodies,
        layout: &Layout,
        indices: impl Iterator<Item = u32>,
    ) -> Self {
        let mut swept: Vec<SweptBox> =
            indices.map(|i| SweptBox::of(bodies, layout, i, layout.span.rounding()).1).collect();
        swept.sort_unstable_by(|a, b| a.left.total_cmp(&b.left).then(a.index.cmp(&b.index)));
        let widest = swept.iter().fold(0.0, |w: f64, s| w.max(s.right - s.left));
        Self { swept, widest }
    }

    /// Visits the special particles whose boxes touch `asked`.
    pub(crate) fn near(&self, asked: &SweptBox, mut visit: impl FnMut(u32)) {
        let first = self.swept.partition_point(|s| s.left < asked.left - self.widest);
        for s in self.swept[first..].iter().take_while(|s| s.left <= asked.right) {
            if (s.right >= asked.left) & (s.top >= asked.bottom) & (s.bottom <= asked.top) {
                visit(s.index);
            }
        }
    }

    /// Adds the close pairs of two special particles to `found`.
    pub(crate) fn pairs_between(&self, bodies: &Bodies, layout: &Layout, found: &mut Found) {
        for swept in &self.swept {
            let pad = CUTOFF + layout.margin + layout.span.rounding();
            let (path, asked) = SweptBox::of(bodies, layout, swept.index, pad);
            self.near(&asked, |k| {
                if swept.index < k {
                    offer(bodies, layout, &path, swept.index, k, found);
                }
            });
        }
    }
}

/// Where particles that are not special stand halfway if they may touch the box within the window:
/// left, right, bottom and top.
fn around(asked: &SweptBox, layout: &Layout) -> [f64; 4] {
    let half = 0.5 * layout.reach;
    [asked.left - half, asked.right + half, asked.bottom - half, asked.top + half]
}

/// Adds the close pairs of special particle `i` and particles that are not special to `found`.
pub(crate) fn pairs_with_plain(
    bodies: &Bodies,
    cells: &Cells,
    layout: &Layout,
    i: u32,
    found: &mut Found,
) {
    let pad = CUTOFF + layout.margin + layout.span.rounding();
    let (path, asked) = SweptBox::of(bodies, layout, i, pad);
    plain_near(bodies, cells, layout, &asked, |k| {
        found.tested += 1;
        offer(bodies, layout, &path, i, k, found);
    });
}

/// Visits all particles that are not special and may touch the box within the window.
pub(crate) fn plain_near(
    bodies: &Bodies,
    cells: &Cells,
    layout: &Layout,
    asked: &SweptBox,
    mut visit: impl FnMut(u32),
) {
    let place = around(asked, layout);
    let ([left, right, bottom, top], time) = (place, layout.halfway());
    let mut ranges = cells.rows_of(&place);
    while let Some(range) = ranges.next(cells) {
        for k in range {
            let (x, y) = (bodies.x[k] + bodies.vx[k] * time, bodies.y[k] + bodies.vy[k] * time);
            let inside = (x >= left) & (x <= right) & (y >= bottom) & (y <= top);
            if inside && !layout.is_special(bodies, k) {
                visit(k as u32);
            }
        }
    }
}

fn offer(bodies: &Bodies, layout: &Layout, path: &Path, i: u32, k: u32, found: &mut Found) {
    let span = &layout.span;
    let other = span.path(&bodies.get(k as usize));
    if path.may_touch(&other, span.forces(), layout.margin + span.rounding()) {
        found.close.push([i.min(k), i.max(k)]);
    }
}

/// Which particles may reach a wall until the list is worn out, and which within this step.
#[derive(Default)]
pub(crate) struct Walls {
    /// In sorted order.
    near: Vec<u32>,
    /// Whether each of all particles may reach a wall within the step.
    pub(crate) at: Vec<bool>,
}

impl Walls {
    /// Finds the particles no further than `strip` from a wall.
    pub(crate) fn find(&mut self, bodies: &Bodies, strip: f64, size: f64) {
        let Self { near, at } = self;
        at.clear();
        at.resize(bodies.len(), false);
        near.clear();
        let (least, most) = (strip, size - strip);
        let is_near =
            |(x, y): (&f64, &f64)| !((*x >= least) & (*x <= most) & (*y >= least) & (*y <= most));
        for (k, (x, y)) in bodies.x.chunks(EIGHT).zip(bodies.y.chunks(EIGHT)).enumerate() {
            if x.iter().zip(y).fold(false, |any, place| any | is_near(place)) {
                let some = x.iter().zip(y).enumerate().filter(|(_, place)| is_near(*place));
                near.extend(some.map(|(l, _)| (k * EIGHT + l) as u32));
            }
        }
    }

    /// Adds `more` particles, which may go further than the usual one.
    pub(crate) fn add(&mut self, more: impl Iterator<Item = u32>) {
        self.near.extend(more);
        self.near.sort_unstable();
        self.near.dedup();
    }

    /// Looks again at the beginning of a step; brings back the particles that may reach a wall in it.
    pub(crate) fn meet(&mut self, bodies: &Bodies, span: &Span) -> Vec<u32> {
        let Self { near, at } = self;
        let meets = |&i: &u32| {
            let k = i as usize;
            at[k] = span.meets_wall(bodies.x[k], bodies.y[k], bodies.vx[k], bodies.vy[k]);
            at[k]
        };
        near.iter().copied().filter(meets).collect()
    }
}
