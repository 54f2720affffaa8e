//! A band of cells: the piece of a window that one thread works on.

use std::ops::Range;

use neighbour_list::Bodies;
use neighbour_list::kernels::Pair;
use neighbour_list::list::Block;

use crate::groups::{Batch, FREE, Grouper, Task};
use crate::rules::Rules;
use crate::search::{Found, Layout, Search};

/// Cells that follow each other in memory, and what happens among their particles.
#[derive(Default)]
pub(crate) struct Band {
    /// The particles in its cells.
    pub(crate) particles: Range<usize>,
    /// Pairs that one of these particles found. Both of a close one are in the band.
    pub(crate) found: Found,
    /// Close pairs with a particle of another band.
    pub(crate) across: Vec<Pair>,
    /// Particles that may reach a wall.
    pub(crate) walls: Vec<u32>,
    grouper: Grouper,
    /// The groups that lie in the band.
    pub(crate) batch: Batch,
}

/// A band's part of the window's arrays.
pub(crate) struct Part<'a> {
    /// The band's particles that are in pairs across its borders.
    pub(crate) elsewhere: &'a [u32],
    /// The slot of each of the band's particles, [`FREE`] for a free one.
    pub(crate) slots: &'a mut [u32],
    /// How far each of them is off its path.
    pub(crate) deviation: &'a mut [f64],
}

impl<'a> Part<'a> {
    /// Takes away the part of the first particles, and returns it.
    pub(crate) fn split_off(&mut self, particles: &Range<usize>) -> Self {
        let count = self.elsewhere.partition_point(|&i| (i as usize) < particles.end);
        let (elsewhere, rest) = self.elsewhere.split_at(count);
        self.elsewhere = rest;
        Self {
            elsewhere,
            slots: self.slots.split_off_mut(..particles.len()).expect("a slot for each"),
            deviation: self.deviation.split_off_mut(..particles.len()).expect("one for each"),
        }
    }
}

impl Band {
    /// Finds all pairs that the band's particles have with particles behind them.
    pub(crate) fn search<R: Rules>(&mut self, search: &Search<'_>, block: &Block) {
        let Search { bodies, listed, layout: Layout { span, .. } } = *search;
        let Self { particles, found, across, walls, .. } = self;
        *particles = block.particles.clone();
        search.flights::<R>(block, found);
        walls.clear();
        walls.extend(listed.by_walls(particles).iter().filter(|&&i| {
            let k = i as usize;
            R::meets_wall(span, bodies.x[k], bodies.y[k], bodies.vx[k], bodies.vy[k])
        }));
        if span.steps > 1 {
            walls.iter().for_each(|&i| search.at_wall::<R>(i, found));
        }
        // Pairs with a particle of another band are set aside.
        across.clear();
        found.close.retain(|pair| {
            let here = pair.iter().all(|&i| particles.contains(&(i as usize)));
            if !here {
                across.push(*pair);
            }
            here
        });
    }

    /// Computes all groups that lie in the band.
    pub(crate) fn run<R: Rules>(&mut self, bodies: &Bodies, layout: &Layout, part: Part<'_>) {
        let Part { elsewhere, slots, deviation } = part;
        let first = self.particles.start;
        let task = Task {
            range: self.particles.clone(),
            pairs: &self.found.close,
            alone: &self.walls,
            elsewhere,
        };
        self.grouper.group::<R>(bodies, &task, &mut self.batch.groups);
        let Batch { groups, record, .. } = &mut self.batch;
        groups.run::<R>(bodies, &layout.span, record);
        slots.fill(FREE);
        deviation.fill(0.0);
        self.batch.note(0, first, slots, deviation);
    }

    /// The pairs of groups that reach beyond the band.
    pub(crate) fn deferred(&self) -> &[Pair] {
        &self.grouper.deferred
    }
}
