//! A window of several steps: the free fly, groups are computed on their own.

use common::soft::Observer;

use crate::band::{Band, FREE};
use crate::batch::Batch;
use crate::flight::fly;
use crate::grouper::{Grouper, Task};
use crate::path::Span;
use crate::search::{Layout, Pair};
use crate::specials::Specials;
use crate::workers::cut;
use crate::{Bodies, Cells, Grid, Sorter, Workers};

/// In a slot: the seat is in a batch that was computed after the bands.
pub(crate) const LATE: u32 = 1 << 31;
/// Repairs of a window before it is redone with fewer steps.
const REPAIRS: usize = 12;

/// What windows count.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Tallies {
    /// Windows.
    pub(crate) windows: u64,
    /// Pairs looked at.
    pub(crate) tests: u64,
    /// Particles that flew freely through a window.
    pub(crate) flown: u64,
    /// Particles moved, one for each step of those in groups and one for each window of the free.
    pub(crate) touched: u64,
    /// Particles computed again.
    pub(crate) repaired: u64,
    /// Windows redone with half the steps.
    pub(crate) redone: u64,
    /// Particles that might have reached a wall.
    pub(crate) walls: u64,
}

/// The window that the engine is in.
#[derive(Default)]
pub(crate) struct Window {
    /// All particles as they were when the window began, sorted by cell.
    pub(crate) bodies: Bodies,
    spare: Bodies,
    sorter: Sorter,
    grouper: Grouper,
    pub(crate) bands: Vec<Band>,
    /// Groups across bands, and then those that were computed again.
    pub(crate) late: Vec<Batch>,
    /// Batches of earlier windows, kept for their memory.
    idle: Vec<Batch>,
    /// The seat of each particle, or [`FREE`].
    pub(crate) slot: Vec<u32>,
    /// How far each particle is off its path, 0 for the free.
    pub(crate) bent: Vec<f32>,
    pub(crate) specials: Specials,
}

/// The free flight of a piece.
struct Fly<'a> {
    x: &'a mut [f64],
    v: &'a [f64],
    span: &'a Span,
}

impl pulp::NullaryFnOnce for Fly<'_> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        fly(self.x, self.v, self.span.steps, self.span.dt);
    }
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
        tallies: &mut Tallies,
    ) -> bool {
        let cells =
            self.sorter.sort(&self.bodies, &mut self.spare, grid, dense, layout.halfway(), workers);
        std::mem::swap(&mut self.bodies, &mut self.spare);
        let held = self.go_through(layout, &cells, workers, tallies);
        self.sorter.take_back(cells);
        held
    }

    /// Takes the sorted particles through a window; whether its margin held at last.
    fn go_through(
        &mut self,
        layout: &Layout,
        cells: &Cells,
        workers: &Workers,
        tallies: &mut Tallies,
    ) -> bool {
        let across = self.find(layout, cells, workers, tallies);
        self.run_bands(layout, &across, workers);
        let walls: u64 = self.bands.iter().map(|band| band.walls.len() as u64).sum();
        let mut pairs = across;
        self.bands.iter().for_each(|band| pairs.extend(band.deferred()));
        let mut people: usize = self.bands.iter().map(|band| band.batch.groups.people()).sum();
        for repair in 0..=REPAIRS {
            if !pairs.is_empty() {
                let again = self.run_late(&pairs, layout);
                people += again;
                tallies.repaired += if repair > 0 { again as u64 } else { 0 };
            }
            let broken = self.verify(layout, cells, repair > 0, workers, tallies);
            if broken.is_empty() {
                let free = self.slot.iter().map(|&slot| u64::from(slot == FREE)).sum::<u64>();
                tallies.windows += 1;
                tallies.flown += free;
                tallies.touched +=
                    self.bodies.len() as u64 + people as u64 * u64::from(layout.span.steps);
                tallies.walls += walls;
                return true;
            }
            pairs = self.with_their_groups(broken);
        }
        tallies.redone += 1;
        tallies.touched += people as u64 * u64::from(layout.span.steps);
        self.slot.fill(FREE);
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
        tallies: &mut Tallies,
    ) -> Vec<Pair> {
        // The more particles, the less of a band is border.
        let target = 16 * self.bodies.len().isqrt();
        let pieces = cells.pieces(target.max(512));
        self.bands.resize_with(pieces.len(), Band::default);
        let bodies = &self.bodies;
        let work = self.bands.iter_mut().zip(pieces).collect();
        workers.map(work, |(band, piece): (&mut Band, _)| {
            band.search(bodies, cells, piece, layout);
        });
        let special = self.bands.iter().flat_map(|band| &band.special).copied();
        self.specials = Specials::new(bodies, layout, special);
        if let Some(last) = self.bands.last_mut() {
            let mut across = std::mem::take(&mut last.across);
            let kept = last.found.close.len();
            self.specials.among_themselves(bodies, layout, &mut last.found);
            across.extend(last.found.close.drain(kept..));
            last.across = across;
        }
        let mut across = Vec::new();
        for band in &self.bands {
            tallies.tests += band.found.tested;
            across.extend_from_slice(&band.across);
        }
        across
    }

    /// Computes all groups that lie in one band.
    fn run_bands(&mut self, layout: &Layout, across: &[Pair], workers: &Workers) {
        let n = self.bodies.len();
        self.idle.append(&mut self.late);
        self.slot.resize(n, FREE);
        let mut elsewhere: Vec<u32> = across.iter().flatten().copied().collect();
        elsewhere.sort_unstable();
        elsewhere.dedup();
        let ends: Vec<usize> = self.bands.iter().map(|band| band.particles.end).collect();
        self.bent.resize(n, 0.0);
        let slots = cut(&mut self.slot, ends.iter().copied());
        let bents = cut(&mut self.bent, ends.iter().copied());
        let mut rest = &elsewhere[..];
        let work = self
            .bands
            .iter_mut()
            .zip(slots.into_iter().zip(bents))
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
            |(band, (slots, bent), own): (&mut Band, (&mut [u32], &mut [f32]), _)| {
                band.run(bodies, own, layout, slots, bent);
            },
        );
    }

    /// Groups `pairs` and computes them as a batch of their own. Brings back how many particles
    /// they are.
    fn run_late(&mut self, pairs: &[Pair], layout: &Layout) -> usize {
        let alone = self.walls_in(pairs, layout);
        let task = Task { range: 0..self.bodies.len(), pairs, alone: &alone, elsewhere: &[] };
        let first = self.late.last().map_or(0, |batch| batch.first + batch.groups.seats());
        let mut batch = self.idle.pop().unwrap_or_default();
        batch.first = first;
        self.grouper.group(&self.bodies, &task, &mut batch.groups);
        let span = &layout.span;
        batch.groups.run(&self.bodies, span.steps, span, &mut batch.record);
        batch.note(LATE | first as u32, 0, &mut self.slot, &mut self.bent);
        let people = batch.groups.people();
        self.late.push(batch);
        people
    }

    /// How far the most bent of all particles is off its path.
    pub(crate) fn most_bent(&self) -> f64 {
        let bands = self.bands.iter().map(|band| &band.batch);
        bands.chain(&self.late).map(|batch| batch.most_bent).fold(0.0, f64::max)
    }

    /// Those among `pairs` that may reach a wall.
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

    /// The batch that computes a particle that is not free, and its seat there.
    #[inline]
    pub(crate) fn seat(&self, i: u32) -> Option<(&Batch, usize)> {
        let slot = self.slot[i as usize];
        if slot == FREE {
            return None;
        }
        if slot & LATE == 0 {
            let band = self.bands.partition_point(|band| band.particles.end <= i as usize);
            return Some((&self.bands[band].batch, slot as usize));
        }
        let seat = (slot & !LATE) as usize;
        let batch = &self.late[self.late.partition_point(|batch| batch.first <= seat) - 1];
        Some((batch, seat - batch.first))
    }

    /// The particles after `steps` ≤ the window's steps; nothing is changed.
    pub(crate) fn look(&self, span: &Span, steps: u32) -> Bodies {
        let mut bodies = self.bodies.clone();
        fly(&mut bodies.x, &bodies.vx, steps, span.dt);
        fly(&mut bodies.y, &bodies.vy, steps, span.dt);
        let batches = self.bands.iter().map(|band| &band.batch).chain(&self.late);
        for batch in batches {
            let mut now = Batch::default();
            batch.groups.run(&self.bodies, steps, span, &mut now.record);
            batch.groups.for_each_member(|seat, i| {
                // A group that was repaired lives on in a later batch.
                if self.seat(i).is_some_and(|(last, _)| std::ptr::eq(last, batch)) {
                    let i = i as usize;
                    bodies.set(i, now.end(seat, self.bodies.id[i]));
                }
            });
        }
        bodies
    }

    /// What an observer sees in each step of the window.
    pub(crate) fn observe<O: Observer>(&self, span: &Span) -> Vec<O> {
        let mut observers = vec![O::default(); span.steps as usize];
        for batch in self.bands.iter().map(|band| &band.batch).chain(&self.late) {
            batch.groups.observe(&self.bodies, span, &mut observers, |_, i| {
                self.seat(i).is_some_and(|(last, _)| std::ptr::eq(last, batch))
            });
        }
        observers
    }

    /// Ends the window: everybody is where its last step takes them.
    pub(crate) fn close(&mut self, span: &Span, workers: &Workers) {
        if span.steps == 0 {
            return;
        }
        let arch = pulp::Arch::new();
        let ends: Vec<usize> = self.bands.iter().map(|band| band.particles.end).collect();
        let bounds = || ends.iter().copied();
        let Bodies { x, y, vx, vy, .. } = &mut self.bodies;
        let axes = cut(x, bounds()).into_iter().zip(cut(vx, bounds()));
        let axes = axes.zip(cut(y, bounds()).into_iter().zip(cut(vy, bounds())));
        let work = self.bands.iter().zip(axes).collect();
        workers.map(work, |(band, ((x, vx), (y, vy))): (&Band, ((&mut [f64], _), _))| {
            arch.dispatch(Fly { x, v: vx, span });
            arch.dispatch(Fly { x: y, v: vy, span });
            let (first, record) = (band.particles.start, &band.batch.record);
            band.batch.groups.for_each_member(|seat, i| {
                let i = i as usize - first;
                (x[i], y[i]) = (record.x[seat], record.y[seat]);
                (vx[i], vy[i]) = (record.vx[seat], record.vy[seat]);
            });
        });
        // A group that was repaired lives on in a later batch.
        let bodies = &mut self.bodies;
        for batch in &self.late {
            batch.groups.for_each_member(|seat, i| {
                bodies.set(i as usize, batch.end(seat, bodies.id[i as usize]));
            });
        }
        self.slot.fill(FREE);
    }
}
