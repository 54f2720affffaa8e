//! Particles that are looked after one by one: the very fast, and those that may reach a wall.

use common::soft::CUTOFF;

use crate::path::Path;
use crate::search::{Found, Layout, near_in};
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
    /// Squares over the box, and whether a special particle matters to those who stand in it.
    marks: Vec<bool>,
    columns: usize,
    /// One over the side of a square.
    inverse: f64,
}

impl Specials {
    pub(crate) fn new(bodies: &Bodies, layout: &Layout, who: impl Iterator<Item = u32>) -> Self {
        let mut swept: Vec<Swept> =
            who.map(|i| Swept::of(bodies, layout, i, layout.span.rounding()).1).collect();
        swept.sort_unstable_by(|a, b| a.left.total_cmp(&b.left).then(a.who.cmp(&b.who)));
        let widest = swept.iter().fold(0.0, |w: f64, s| w.max(s.right - s.left));
        Self { swept, widest, ..Self::default() }
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

    /// Marks the squares in which somebody need look for special particles who is off its path by
    /// no more than two cutoffs, together with those it may meet. Hardly anybody does.
    pub(crate) fn mark(&mut self, layout: &Layout, n: usize) {
        let pad = layout.reach + 3.0 * CUTOFF + layout.span.rounding();
        let size = layout.span.size;
        let columns = ((size / (2.0 * pad)) as usize).clamp(1, n.isqrt() + 1);
        (self.columns, self.inverse) = (columns, columns as f64 / size);
        self.marks.clear();
        self.marks.resize(columns * columns, false);
        let mut left = 4 * n;
        for s in &self.swept {
            let [x0, x1, y0, y1] = [s.left - pad, s.right + pad, s.bottom - pad, s.top + pad]
                .map(|at| self.square(at));
            left = left.saturating_sub((x1 + 1 - x0) * (y1 + 1 - y0));
            if left == 0 {
                // They sweep everything: then everybody looks for them.
                self.marks.fill(true);
                return;
            }
            for row in y0..=y1 {
                self.marks[row * columns + x0..=row * columns + x1].fill(true);
            }
        }
    }

    #[inline(always)]
    fn square(&self, at: f64) -> usize {
        ((at * self.inverse) as usize).min(self.columns - 1)
    }

    /// Appends to `list` everybody who may have touched particle `i`, special or not, and some
    /// others. `off` says how far the particle is off its reference path, and how far those are at
    /// most for whom it asks; `bent` how far everybody is.
    #[inline(always)]
    #[expect(clippy::too_many_arguments, reason = "a window is wide")]
    pub(crate) fn everybody_near(
        &self,
        bodies: &Bodies,
        cells: &Cells,
        layout: &Layout,
        i: u32,
        off: (f64, f64),
        bent: &[f32],
        list: &mut Vec<u32>,
    ) {
        let k = i as usize;
        let (x, y) = (bodies.x[k], bodies.y[k]);
        let (near, most) = (CUTOFF + off.0 + layout.span.rounding(), off.1);
        let far = off.0 + off.1 > 2.0 * CUTOFF;
        if far || self.marks[self.square(y) * self.columns + self.square(x)] {
            let (_, asked) = Swept::of(bodies, layout, i, near + most);
            self.near(&asked, |k| list.push(k));
            if layout.is_special(bodies, k) {
                plain_near(bodies, cells, layout, &asked, |k| list.push(k));
                return;
            }
        }
        let time = layout.span.forces();
        let (way_x, way_y) = (bodies.vx[k] * time, bodies.vy[k] * time);
        let pad = near + most + 0.5 * layout.reach;
        let place = [
            x + way_x.min(0.0) - pad,
            x + way_x.max(0.0) + pad,
            y + way_y.min(0.0) - pad,
            y + way_y.max(0.0) + pad,
        ];
        let mut ranges = cells.rows_of(&place);
        while let Some(one) = ranges.next(cells) {
            let two = ranges.next(cells).unwrap_or(0..0);
            near_in(bodies, k, one, two, time, near, Some(bent), &mut *list);
        }
    }
}

/// Where those stand halfway who are not special and may touch the rectangle within the window.
fn around(asked: &Swept, layout: &Layout) -> [f64; 4] {
    let way = 0.5 * layout.reach;
    [asked.left - way, asked.right + way, asked.bottom - way, asked.top + way]
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
