//! A band of cells: the part of a window that one thread computes.

use std::ops::Range;

use neighbour_list::Bodies;
use neighbour_list::kernels::Pair;
use neighbour_list::list::Block;

use crate::groups::{Batch, FREE, Grouper, Task};
use crate::rules::Rules;
use crate::search::{Found, Layout, Search};

/// Consecutive cells, the pairs found in them, and the groups of their particles.
#[derive(Default)]
pub(crate) struct Band {
    /// The particles in the band's cells.
    pub(crate) particles: Range<usize>,
    /// Pairs that the search found for the band's particles. Both particles of a close pair are in
    /// the band.
    pub(crate) found: Found,
    /// Close pairs with a particle of another band.
    pub(crate) across: Vec<Pair>,
    /// Particles that may reach a wall.
    pub(crate) walls: Vec<u32>,
    grouper: Grouper,
    /// The groups whose members are all in the band.
    pub(crate) batch: Batch,
}

/// A band's part of the window's arrays.
pub(crate) struct Part<'a> {
    /// The band's particles that are in pairs with other bands.
    pub(crate) elsewhere: &'a [u32],
    /// The slot of each of the band's particles, or [`FREE`].
    pub(crate) slots: &'a mut [u32],
    /// The deviation of each of the band's particles from its path.
    pub(crate) deviation: &'a mut [f64],
}

impl<'a> Part<'a> {
    /// Removes the part with the first particles, and returns it.
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
    /// Finds all pairs of the band's particles with particles that come later in the sorted order.
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
        // Pairs with a particle of another band are grouped when all bands have been computed.
        across.clear();
        found.close.retain(|pair| {
            let here = pair.iter().all(|&i| particles.contains(&(i as usize)));
            if !here {
                across.push(*pair);
            }
            here
        });
    }

    /// Computes all groups whose members are in the band.
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

    /// Returns the pairs of groups that reach beyond the band.
    pub(crate) fn deferred(&self) -> &[Pair] {
        &self.grouper.deferred
    }
}
