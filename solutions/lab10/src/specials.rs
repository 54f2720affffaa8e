//! Particles that are looked after one by one: the very fast, and those that may reach a wall.

use common::soft::CUTOFF;

use crate::path::Path;
use crate::search::{Found, Layout};
use crate::{Bodies, Cells};

/// A rectangle that a particle's reference path stays in.
#[derive(Clone, Copy)]
struct Swept {
    left: f64,
    right: f64,
    bottom: f64,
    top: f64,
    who: u32,
}

impl Swept {
    fn of(bodies: &Bodies, layout: &Layout, who: u32, pad: f64) -> (Path, Self) {
        let path = layout.span.path(&bodies.get(who as usize));
        let (pad, whole) = (pad + path.spread, layout.span.whole());
        let (end_x, end_y) = (path.x + path.wx * whole, path.y + path.wy * whole);
        let swept = Self {
            left: path.x.min(end_x) - pad,
            right: path.x.max(end_x) + pad,
            bottom: path.y.min(end_y) - pad,
            top: path.y.max(end_y) + pad,
            who,
        };
        (path, swept)
    }
}

/// The special particles of a window, by the left ends of their paths.
#[derive(Default)]
pub(crate) struct Specials {
    swept: Vec<Swept>,
    widest: f64,
}

impl Specials {
    pub(crate) fn new(bodies: &Bodies, layout: &Layout, who: impl Iterator<Item = u32>) -> Self {
        let mut swept: Vec<Swept> =
            who.map(|i| Swept::of(bodies, layout, i, layout.span.rounding()).1).collect();
        swept.sort_unstable_by(|a, b| a.left.total_cmp(&b.left).then(a.who.cmp(&b.who)));
        let widest = swept.iter().fold(0.0, |w: f64, s| w.max(s.right - s.left));
        Self { swept, widest }
    }

    /// Those whose rectangles touch that of particle `i`, `pad` wider.
    fn near(&self, asked: &Swept, mut visit: impl FnMut(u32)) {
        let first = self.swept.partition_point(|s| s.left < asked.left - self.widest);
        for s in self.swept[first..].iter().take_while(|s| s.left <= asked.right) {
            if (s.right >= asked.left) & (s.top >= asked.bottom) & (s.bottom <= asked.top) {
                visit(s.who);
            }
        }
    }

    /// Pairs of two special particles.
    pub(crate) fn among_themselves(&self, bodies: &Bodies, layout: &Layout, found: &mut Found) {
        for swept in &self.swept {
            let pad = CUTOFF + layout.margin + layout.span.rounding();
            let (path, asked) = Swept::of(bodies, layout, swept.who, pad);
            self.near(&asked, |k| {
                if swept.who < k {
                    offer(bodies, layout, &path, swept.who, k, found);
                }
            });
        }
    }

    /// Visits everybody, special or not, whose reference path may come within cutoff + `off` of
    /// that of particle `i`, and some others.
    pub(crate) fn everybody_near(
        &self,
        bodies: &Bodies,
        cells: &Cells,
        layout: &Layout,
        i: u32,
        off: f64,
        mut visit: impl FnMut(u32),
    ) {
        let (_, asked) = Swept::of(bodies, layout, i, CUTOFF + off + layout.span.rounding());
        self.near(&asked, &mut visit);
        plain_near(bodies, cells, layout, &asked, visit);
    }
}

/// Pairs of special particle `i` with all that are not. Brings back how many were looked at.
pub(crate) fn with_the_others(
    bodies: &Bodies,
    cells: &Cells,
    layout: &Layout,
    i: u32,
    found: &mut Found,
) {
    let pad = CUTOFF + layout.margin + layout.span.rounding();
    let (path, asked) = Swept::of(bodies, layout, i, pad);
    plain_near(bodies, cells, layout, &asked, |k| {
        found.tested += 1;
        offer(bodies, layout, &path, i, k, found);
    });
}

/// Visits all particles that are not special and may touch the rectangle within the window.
fn plain_near(
    bodies: &Bodies,
    cells: &Cells,
    layout: &Layout,
    asked: &Swept,
    mut visit: impl FnMut(u32),
) {
    let x = (asked.left - layout.reach, asked.right + layout.reach);
    let y = (asked.bottom - layout.reach, asked.top + layout.reach);
    cells.in_rectangle(x, y, |range| {
        for k in range {
            let inside = (bodies.x[k] >= x.0)
                & (bodies.x[k] <= x.1)
                & (bodies.y[k] >= y.0)
                & (bodies.y[k] <= y.1);
            if inside && !layout.is_special(bodies, k) {
                visit(k as u32);
            }
        }
    });
}

fn offer(bodies: &Bodies, layout: &Layout, path: &Path, i: u32, k: u32, found: &mut Found) {
    let span = &layout.span;
    let other = span.path(&bodies.get(k as usize));
    let pair = [i.min(k), i.max(k)];
    if path.may_touch(&other, span.forces(), layout.tight + span.rounding()) {
        found.close.push(pair);
    } else if path.may_touch(&other, span.forces(), layout.margin + span.rounding()) {
        found.watched.push(pair);
    }
}
