//! Opens a window: computes the groups of each band, then groups across bands, then repairs.

use neighbour_list::kernels::Pair;
use neighbour_list::list::Block;
use neighbour_list::{Bodies, Workers};

use super::WindowCounts;
use super::band::{Band, Part};
use crate::groups::{Batch, FREE, Grouper, Task};
use crate::rules::Rules;
use crate::search::{Layout, Listed, Search};

/// The bit of a slot number that marks a batch that was computed after the bands.
pub(crate) const LATE: u32 = 1 << 31;
/// Number of repairs of a window before it is repeated with fewer steps.
const REPAIRS: usize = 12;

/// The current window of the engine.
#[derive(Default)]
pub(crate) struct Window {
    /// All particles at the start of the window, sorted by cell.
    pub(crate) bodies: Bodies,
    listed: Listed,
    grouper: Grouper,
    pub(crate) bands: Vec<Band>,
    /// Batches of groups across bands, and of groups that were computed again.
    pub(crate) late: Vec<Batch>,
    /// Batches of earlier windows, kept for their memory.
    idle: Vec<Batch>,
    /// The slot of each particle, or [`FREE`].
    pub(crate) slots: Vec<u32>,
    /// The deviation of each particle from its path; 0 for free particles.
    pub(crate) deviation: Vec<f64>,
}

impl Window {
    /// Returns the state before the first window.
    pub(crate) fn of(bodies: Bodies) -> Self {
        Self { bodies, ..Self::default() }
    }

    /// Sorts the particles and computes a window.
    ///
    /// Returns false if pairs were still missed after the last repair. The particles are then
    /// unchanged, and the caller should try a shorter window.
    pub(crate) fn open<R: Rules>(
        &mut self,
        layout: &Layout,
        density: f64,
        workers: &Workers,
        counts: &mut WindowCounts,
    ) -> bool {
        let across = self.find::<R>(layout, density, workers, counts);
        self.run_bands::<R>(layout, &across, workers);
        let walls: u64 = self.bands.iter().map(|band| band.walls.len() as u64).sum();
        let mut pairs = across;
        self.bands.iter().for_each(|band| pairs.extend(band.deferred()));
        let mut members: usize =
            self.bands.iter().map(|band| band.batch.groups.member_count()).sum();
        for repair in 0..=REPAIRS {
            if !pairs.is_empty() {
                let again = self.run_late::<R>(&pairs, layout);
                members += again;
                counts.repaired += if repair > 0 { again as u64 } else { 0 };
            }
            let search = Search { bodies: &self.bodies, listed: &self.listed, layout };
            let broken = self.verify::<R>(&search, repair > 0, workers, counts);
            if broken.is_empty() {
                counts.windows += 1;
                counts.flown += (self.bodies.len() - self.computed()) as u64;
                counts.touched +=
                    self.bodies.len() as u64 + members as u64 * u64::from(layout.span.steps);
                counts.walls += walls;
                return true;
            }
            pairs = self.with_their_groups(broken);
        }
        counts.redone += 1;
        counts.touched += members as u64 * u64::from(layout.span.steps);
        false
    }

    /// Searches every band, and returns the close pairs of particles in two bands.
    fn find<R: Rules>(
        &mut self,
        layout: &Layout,
        density: f64,
        workers: &Workers,
        counts: &mut WindowCounts,
    ) -> Vec<Pair> {
        let Self { bodies, listed, bands, .. } = self;
        if let Some(tested) = listed.renew(bodies, layout, density, workers) {
            counts.tests += tested;
            counts.lists += 1;
        }
        let blocks = &listed.list.blocks;
        bands.resize_with(blocks.len(), Band::default);
        let search = Search { bodies, listed, layout };
        let work = bands.iter_mut().zip(blocks).collect();
        workers.map(work, |(band, block): (&mut Band, &Block)| band.search::<R>(&search, block));
        let mut across = Vec::new();
        for band in &self.bands {
            counts.tests += band.found.tested;
            across.extend_from_slice(&band.across);
        }
        across
    }

    /// Computes the groups whose members are all in one band.
    fn run_bands<R: Rules>(&mut self, layout: &Layout, across: &[Pair], workers: &Workers) {
        let n = self.bodies.len();
        self.idle.append(&mut self.late);
        self.slots.resize(n, FREE);
        let mut elsewhere: Vec<u32> = across.iter().flatten().copied().collect();
        elsewhere.sort_unstable();
        elsewhere.dedup();
        self.deviation.resize(n, 0.0);
        let mut rest =
            Part { elsewhere: &elsewhere, slots: &mut self.slots, deviation: &mut self.deviation };
        let mut work = Vec::with_capacity(self.bands.len());
        for band in &mut self.bands {
            let part = rest.split_off(&band.particles);
            work.push((band, part));
        }
        let bodies = &self.bodies;
        workers.map(work, |(band, part): (&mut Band, Part<'_>)| {
            band.run::<R>(bodies, layout, part);
        });
    }

    /// Groups `pairs` and computes the groups as another batch. Returns the number of the batch's
    /// members.
    fn run_late<R: Rules>(&mut self, pairs: &[Pair], layout: &Layout) -> usize {
        let alone = self.walls_in::<R>(pairs, layout);
        let task = Task { range: 0..self.bodies.len(), pairs, alone: &alone, elsewhere: &[] };
        let first = self.late.last().map_or(0, |batch| batch.first + batch.groups.slots());
        let mut batch = self.idle.pop().unwrap_or_default();
        batch.first = first;
        self.grouper.group::<R>(&self.bodies, &task, &mut batch.groups);
        batch.groups.run::<R>(&self.bodies, &layout.span, &mut batch.record);
        batch.note(LATE | first as u32, 0, &mut self.slots, &mut self.deviation);
        let members = batch.groups.member_count();
        self.late.push(batch);
        members
    }

    /// Returns the number of particles in groups.
    fn computed(&self) -> usize {
        self.bands.iter().map(|band| &band.batch).chain(&self.late).map(|batch| batch.new).sum()
    }

    /// Returns the greatest deviation of all particles.
    pub(crate) fn greatest_deviation(&self) -> f64 {
        let bands = self.bands.iter().map(|band| &band.batch);
        bands.chain(&self.late).map(|batch| batch.greatest_deviation).fold(0.0, f64::max)
    }

    /// Returns the particles among `pairs` that may reach a wall.
    fn walls_in<R: Rules>(&self, pairs: &[Pair], layout: &Layout) -> Vec<u32> {
        let bodies = &self.bodies;
        let meets = |&i: &u32| {
            let p = bodies.get(i as usize);
            R::meets_wall(&layout.span, p.x, p.y, p.vx, p.vy)
        };
        let mut walls: Vec<u32> = pairs.iter().flatten().copied().filter(meets).collect();
        walls.sort_unstable();
        walls.dedup();
        walls
    }
}
