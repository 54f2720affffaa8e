//! A list of pairs that lasts for some windows.

use std::ops::Range;

use neighbour_list::kernels::larger;
use neighbour_list::list::Neighbours;
use neighbour_list::{Bodies, EIGHT, Workers};

use super::layout::Layout;

/// The pairs that may come near each other in a window, and the positions at which they were
/// listed.
#[derive(Default)]
pub(crate) struct Listed {
    pub(crate) list: Neighbours,
    x: Vec<f64>,
    y: Vec<f64>,
    /// The greatest distance of a particle from its position in the list.
    pub(crate) moved: f64,
    /// The particles that may reach a wall before the list expires, in sorted order.
    by_walls: Vec<u32>,
}

impl Listed {
    /// Sorts `bodies` and lists their pairs, unless the list still contains every pair of the
    /// window.
    ///
    /// `density` is the number of particles per unit area. Returns the number of pairs that were
    /// tested, or `None` if the list was kept.
    pub(crate) fn renew(
        &mut self,
        bodies: &mut Bodies,
        layout: &Layout,
        density: f64,
        workers: &Workers,
    ) -> Option<u64> {
        let Self { list, x, y, moved, by_walls } = self;
        *moved = farthest(bodies, x, y);
        if x.len() == bodies.len() && 2.0 * *moved + layout.skin(1.0) <= list.budget.skin {
            return None;
        }
        let skin = layout.skin(layout.lasting(density));
        let tested = list.rebuild(bodies, skin, layout.span.size, workers);
        x.clone_from(&bodies.x);
        y.clone_from(&bodies.y);
        *moved = 0.0;
        let inside = 0.5 * skin..=layout.span.size - 0.5 * skin;
        by_walls.clear();
        for (i, (x, y)) in (0..).zip(x.iter().zip(y)) {
            if !(inside.contains(x) && inside.contains(y)) {
                by_walls.push(i);
            }
        }
        Some(tested)
    }

    /// Returns the particles of `range` that may reach a wall before the list expires.
    pub(crate) fn by_walls(&self, range: &Range<usize>) -> &[u32] {
        let before = |end| self.by_walls.partition_point(|&i| (i as usize) < end);
        &self.by_walls[before(range.start)..before(range.end)]
    }
}

/// Returns the greatest distance of any particle from its former position, given by `x` and `y`.
fn farthest(bodies: &Bodies, x: &[f64], y: &[f64]) -> f64 {
    let mut most = [0.0; EIGHT];
    let now = bodies.x.chunks(EIGHT).zip(bodies.y.chunks(EIGHT));
    for ((now_x, now_y), (x, y)) in now.zip(x.chunks(EIGHT).zip(y.chunks(EIGHT))) {
        let dx = off(now_x, x);
        let dy = off(now_y, y);
        for l in 0..EIGHT {
            most[l] = larger(dx[l] * dx[l] + dy[l] * dy[l], most[l]);
        }
    }
    most.into_iter().fold(0.0, f64::max).sqrt()
}

/// Returns the differences between up to eight pairs of coordinates. If there are fewer pairs, the
/// other differences are 0.
#[inline(always)]
fn off(now: &[f64], then: &[f64]) -> [f64; EIGHT] {
    std::array::from_fn(|l| if l < now.len() { now[l] - then[l] } else { 0.0 })
}
