//! A band of cells: the piece of a window that one thread works on.

use std::ops::Range;

use solution10::kernels::{Pair, dispatch};
use solution10::list::Fast;
use solution10::{Bodies, Cells};

use crate::groups::{Batch, FREE, Grouper, Task};
use crate::search::{Flights, Found, Layout, Search, pairs_with_plain};

/// Cells that follow each other in memory, and what happens among their particles.
#[derive(Default)]
pub(crate) struct Band {
    /// The particles in its cells.
    pub(crate) particles: Range<usize>,
    /// Pairs that one of these particles found. Both of a close one are in the band.
    pub(crate) found: Found,
    /// Close pairs with a particle of another band.
    pub(crate) across: Vec<Pair>,
    /// Particles that are looked after one by one.
    pub(crate) special: Vec<u32>,
    /// The special ones that may reach a wall.
    pub(crate) walls: Vec<u32>,
    /// On a list: particles seen to exceed the speed limit since the short list was made.
    pub(crate) fast: Fast,
    grouper: Grouper,
    /// The groups that lie in the band.
    pub(crate) batch: Batch,
}

impl Band {
    /// Finds all pairs of the band's particles, which are in cells `range`, with the particles
    /// ahead of them. The special ones are known.
    pub(crate) fn search(
        &mut self,
        bodies: &Bodies,
        flights: &Flights,
        cells: &Cells,
        range: Range<usize>,
        layout: &Layout,
    ) {
        let limit = flights.limit(layout.near());
        dispatch(Search { found: &mut self.found, flights, cells, range, limit });
        self.walls.clear();
        for &i in &self.special {
            let p = bodies.get(i as usize);
            if layout.span.meets_wall(p.x, p.y, p.vx, p.vy) {
                self.walls.push(i);
            }
            if layout.span.steps > 1 {
                pairs_with_plain(bodies, cells, layout, i, &mut self.found);
            }
        }
        if layout.span.steps == 1 {
            self.special.clear();
        }
        self.keep_inside();
    }

    /// Sets aside close pairs with a particle of another band.
    pub(crate) fn keep_inside(&mut self) {
        self.across.clear();
        let (inside, across) = (&self.particles, &mut self.across);
        self.found.close.retain(|pair| {
            let here = pair.iter().all(|&i| inside.contains(&(i as usize)));
            if !here {
                across.push(*pair);
            }
            here
        });
    }

    /// Computes all groups that lie in the band. Particles `elsewhere` are in pairs across its
    /// borders. `slots` are the slots of the band's particles, [`FREE`] for free ones.
    pub(crate) fn run(
        &mut self,
        bodies: &Bodies,
        elsewhere: &[u32],
        layout: &Layout,
        slots: &mut [u32],
        deviation: &mut [f32],
    ) {
        let first = self.particles.start;
        let task = Task {
            range: self.particles.clone(),
            pairs: &self.found.close,
            alone: &self.walls,
            elsewhere,
        };
        self.grouper.group(bodies, &task, &mut self.batch.groups);
        let Batch { groups, record, .. } = &mut self.batch;
        groups.run(bodies, layout.span.steps, &layout.span, record);
        slots.fill(FREE);
        deviation.fill(0.0);
        self.batch.note(0, first, slots, deviation);
    }

    /// The pairs of groups that reach beyond the band.
    pub(crate) fn deferred(&self) -> &[Pair] {
        &self.grouper.deferred
    }
}
