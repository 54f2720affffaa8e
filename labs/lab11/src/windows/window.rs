//! A window of several steps: free particles fly, groups are computed on their own.

use solution10::kernels::{EIGHT, Pair};
use solution10::threads::cut;
use solution10::{Bodies, Cells, Grid, Sorter, Workers};

use super::WindowCounts;
use super::band::Band;
use crate::groups::{Batch, FREE, Grouper, Task};
use crate::search::{Flights, Layout, Specials};

/// In a slot: it is in a batch that was computed after the bands.
pub(crate) const LATE: u32 = 1 << 31;
/// Repairs of a window before it is redone with fewer steps.
const REPAIRS: usize = 12;

/// The window that the engine is in.
#[derive(Default)]
pub(crate) struct Window {
    /// All particles as they were when the window began, sorted by cell.
    pub(crate) bodies: Bodies,
    pub(crate) spare: Bodies,
    sorter: Sorter,
    grouper: Grouper,
    pub(crate) flights: Flights,
    pub(crate) bands: Vec<Band>,
    /// Particles in a band, roughly.
    pub(crate) share: usize,
    /// Groups across bands, and then the ones that were computed again.
    pub(crate) late: Vec<Batch>,
    /// Batches of earlier windows, kept for their memory.
    idle: Vec<Batch>,
    /// The slot of each particle, or [`FREE`].
    pub(crate) slots: Vec<u32>,
    /// How far each particle is off its path, 0 for the free. Eight more than there are particles.
    pub(crate) deviation: Vec<f32>,
    pub(crate) specials: Specials,
}

impl Window {
    /// Before the first window.
    pub(crate) fn of(bodies: Bodies) -> Self {
        Self { bodies, ..Self::default() }
    }

    /// Sorts the particles and takes them through a window. False if margins kept breaking: then
    /// the particles are still where they were, and a shorter window should be tried.
    pub(crate) fn open(
        &mut self,
        layout: &Layout,
        grid: Grid,
        dense: bool,
        workers: &Workers,
        counts: &mut WindowCounts,
    ) -> bool {
        let cells = self.sorter.sort(
            &mut self.bodies,
            &mut self.spare,
            grid,
            dense,
            layout.halfway(),
            workers,
        );
        let held = self.go_through(layout, &cells, workers, counts);
        self.sorter.take_back(cells);
        held
    }

    /// Takes the sorted particles through a window; whether its margin held at last.
    fn go_through(
        &mut self,
        layout: &Layout,
        cells: &Cells,
        workers: &Workers,
        counts: &mut WindowCounts,
    ) -> bool {
        let across = self.find(layout, cells, workers, counts);
        self.compute(layout, across, workers, counts, |window, last, counts| {
            Some(window.verify(layout, cells, last, workers, counts))
        })
    }

    /// Computes all groups, whose pairs the bands know, and the pairs `across`. `verify` brings
    /// back the pairs that touched and are computed nowhere, or none if that cannot be known; if
    /// other batches were checked before, only the last one need be. Whether no pair is missing at
    /// last.
    pub(crate) fn compute(
        &mut self,
        layout: &Layout,
        across: Vec<Pair>,
        workers: &Workers,
        counts: &mut WindowCounts,
        verify: impl Fn(&Self, bool, &mut WindowCounts) -> Option<Vec<Pair>>,
    ) -> bool {
        self.run_bands(layout, &across, workers);
        let walls: u64 = self.bands.iter().map(|band| band.walls.len() as u64).sum();
        let mut pairs = across;
        self.bands.iter().for_each(|band| pairs.extend(band.deferred()));
        let mut members: usize =
            self.bands.iter().map(|band| band.batch.groups.member_count()).sum();
        for repair in 0..=REPAIRS {
            if !pairs.is_empty() {
                let again = self.run_late(&pairs, layout);
                members += again;
                counts.repaired += if repair > 0 { again as u64 } else { 0 };
            }
            let Some(broken) = verify(self, repair > 0, counts) else { break };
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

    /// Whether the last window had more fast particles to look after than pays.
    pub(crate) fn many_fast(&self) -> bool {
        let fast: usize =
            self.bands.iter().map(|b| b.special.len().saturating_sub(b.walls.len())).sum();
        fast > self.bodies.len() / 200
    }

    /// Has every band search, and brings back the pairs that are in no band.
    fn find(
        &mut self,
        layout: &Layout,
        cells: &Cells,
        workers: &Workers,
        counts: &mut WindowCounts,
    ) -> Vec<Pair> {
        // The more particles, the less of a band is border.
        self.share = (16 * self.bodies.len().isqrt()).max(512);
        let pieces = cells.pieces(self.share);
        self.bands.resize_with(pieces.len(), Band::default);
        let bodies = &self.bodies;
        let specials = self.bands.iter_mut().zip(&pieces).map(|(band, piece)| {
            band.particles = cells.particles(piece);
            (band.particles.clone(), &mut band.special)
        });
        self.flights.fill(bodies, layout, cells.grid.side(), specials, workers);
        let flights = &self.flights;
        let work = self.bands.iter_mut().zip(pieces).collect();
        workers.map(work, |(band, piece): (&mut Band, _)| {
            band.search(bodies, flights, cells, piece, layout);
        });
        let special = self.bands.iter().flat_map(|band| &band.special).copied();
        self.specials = Specials::new(bodies, layout, special);
        if let Some(last) = self.bands.last_mut() {
            let mut across = std::mem::take(&mut last.across);
            let kept = last.found.close.len();
            self.specials.pairs_between(bodies, layout, &mut last.found);
            across.extend(last.found.close.drain(kept..));
            last.across = across;
        }
        let mut across = Vec::new();
        for band in &self.bands {
            counts.tests += band.found.tested;
            across.extend_from_slice(&band.across);
        }
        across
    }

    /// Computes all groups that lie in one band.
    fn run_bands(&mut self, layout: &Layout, across: &[Pair], workers: &Workers) {
        let n = self.bodies.len();
        self.idle.append(&mut self.late);
        self.slots.resize(n, FREE);
        let mut elsewhere: Vec<u32> = across.iter().flatten().copied().collect();
        elsewhere.sort_unstable();
        elsewhere.dedup();
        let ends: Vec<usize> = self.bands.iter().map(|band| band.particles.end).collect();
        self.deviation.resize(n + EIGHT, 0.0);
        let slots = cut(&mut self.slots, ends.iter().copied());
        let deviations = cut(&mut self.deviation, ends.iter().copied());
        let mut rest = &elsewhere[..];
        let work = self
            .bands
            .iter_mut()
            .zip(slots.into_iter().zip(deviations))
            .map(|(band, places)| {
                let own;
                let count = rest.partition_point(|&i| (i as usize) < band.particles.end);
                (own, rest) = rest.split_at(count);
                (band, places, own)
            })
            .collect();
        let bodies = &self.bodies;
        workers.map(
            work,
            |(band, (slots, deviation), own): (&mut Band, (&mut [u32], &mut [f32]), _)| {
                band.run(bodies, own, layout, slots, deviation);
            },
        );
    }

    /// Groups `pairs` and computes them as a batch of their own. Brings back how many particles
    /// they are.
    fn run_late(&mut self, pairs: &[Pair], layout: &Layout) -> usize {
        let alone = self.walls_in(pairs, layout);
        let task = Task { range: 0..self.bodies.len(), pairs, alone: &alone, elsewhere: &[] };
        let first = self.late.last().map_or(0, |batch| batch.first + batch.groups.slots());
        let mut batch = self.idle.pop().unwrap_or_default();
        batch.first = first;
        self.grouper.group(&self.bodies, &task, &mut batch.groups);
        let span = &layout.span;
        batch.groups.run(&self.bodies, span.steps, span, &mut batch.record);
        batch.note(LATE | first as u32, 0, &mut self.slots, &mut self.deviation);
        let members = batch.groups.member_count();
        self.late.push(batch);
        members
    }

    /// How many particles are in groups.
    fn computed(&self) -> usize {
        self.bands.iter().map(|band| &band.batch).chain(&self.late).map(|batch| batch.new).sum()
    }

    /// The greatest deviation of all particles.
    pub(crate) fn greatest_deviation(&self) -> f64 {
        let bands = self.bands.iter().map(|band| &band.batch);
        bands.chain(&self.late).map(|batch| batch.greatest_deviation).fold(0.0, f64::max)
    }

    /// The particles among `pairs` that may reach a wall.
    fn walls_in(&self, pairs: &[Pair], layout: &Layout) -> Vec<u32> {
        let bodies = &self.bodies;
        let meets = |&i: &u32| {
            let p = bodies.get(i as usize);
            layout.span.meets_wall(p.x, p.y, p.vx, p.vy)
        };
        let mut walls: Vec<u32> = pairs.iter().flatten().copied().filter(meets).collect();
        walls.sort_unstable();
        walls.dedup();
        walls
    }
}
