//! Windows of one official step, opened from a neighbour list.
//!
//! A window that looks for its pairs sorts all particles and searches around each. A list has
//! done so some steps ago: a pass over its pairs tells which could meet within the step. These
//! form groups and take small steps, and the rest is that of any other window.

use common::soft::CUTOFF;
use pulp::Arch;
use solution10::Workers;
use solution10::list::{Block, Limits, Neighbours};

use super::WindowCounts;
use super::band::Band;
use super::window::Window;
use crate::flight::Span;
use crate::search::{Approach, Layout, Walls};

/// How close free flights come that are computed at once, beyond the cutoff and in cutoffs. Within
/// one step a push bends a path by less than in a longer window.
const MARGIN: f64 = 0.01;
/// How much beyond the margin pairs are watched as a rule, in cutoffs.
const ASIDE: f64 = 0.1;
/// The most that a list looks beyond the cutoff, in cutoffs, for the sake of the particles
/// that are the fastest or are pushed the furthest.
const MOST: f64 = 3.0;

/// A neighbour list, and what must be known of its particles.
pub(crate) struct Listed {
    list: Neighbours,
    limits: Limits,
    walls: Walls,
    /// How many times as fast as allowed the fastest particle was since the list was last shortened.
    over: f64,
    /// How much beyond the margin pairs are watched.
    aside: f64,
}

impl Default for Listed {
    fn default() -> Self {
        Self {
            list: Neighbours::default(),
            limits: Limits::default(),
            walls: Walls::default(),
            over: 1.0,
            aside: ASIDE * CUTOFF,
        }
    }
}

impl Listed {
    /// Forgets the list: other particles, or another order.
    pub(crate) fn forget(&mut self) {
        self.list.forget();
        self.limits = Limits::default();
    }

    /// Takes the particles of `window` through `span`, one official step. False if they are too
    /// fast for a list, or are pushed too far: then they are still where they were.
    pub(crate) fn open(
        &mut self,
        window: &mut Window,
        span: Span,
        workers: &Workers,
        counts: &mut WindowCounts,
    ) -> bool {
        if self.is_worn_out(span) {
            self.aside = (0.5 * self.aside).max(ASIDE * CUTOFF);
        }
        loop {
            let is_outrun = self.limits.are_outrun(window.bodies.len());
            if (is_outrun || self.is_worn_out(span)) && !self.rebuild(window, span, workers, counts)
            {
                return false;
            }
            let ahead = ahead(self.aside, span, self.over * self.limits.displacement());
            if self.limits.short_is_spent(ahead) {
                self.shorten(window, span, workers, counts);
            }
            let layout = self.layout(span);
            if window.open_listed(&self.list, &mut self.walls, &layout, workers, counts) {
                self.over = self.over.max(window.watch(&self.limits, &span, workers));
                self.limits.age(&mut self.list.budget, self.over, span.rounding());
                return true;
            }
            counts.redone += 1;
            self.aside *= 2.0;
        }
    }

    fn layout(&self, span: Span) -> Layout {
        let reach = self.over * self.limits.outliers().fastest() * self.limits.displacement();
        Layout { span, margin: MARGIN * CUTOFF, reach, aside: self.aside }
    }

    /// Whether the list might lack a pair that has to be looked at in the next step.
    fn is_worn_out(&self, span: Span) -> bool {
        self.list.budget.is_spent(ahead(self.aside, span, self.limits.displacement()))
    }

    /// Builds the list anew, unless it would be too long.
    fn rebuild(
        &mut self,
        window: &mut Window,
        span: Span,
        workers: &Workers,
        counts: &mut WindowCounts,
    ) -> bool {
        let Self { list, limits, aside, .. } = self;
        let ahead = |displacement| ahead(*aside, span, displacement);
        let cheapest = |displacement| list.cheapest_skin(&window.bodies, displacement);
        let skin = |displacement| {
            2.0 * ahead(0.0) + f64::max(cheapest(displacement), 2.0 * displacement * (1.0 + 1e-9))
        };
        let skin = limits.renew(&window.bodies, span.whole(), span.size, ahead, skin);
        if 2.0 * ahead(limits.displacement()) > MOST * CUTOFF {
            self.forget();
            return false;
        }
        counts.tests += window.list(list, limits, skin, span.size, workers);
        counts.lists += 1;
        self.over = 1.0;
        // A usual particle that is further away goes half the skin at most before the list is worn out.
        self.walls.find(&window.bodies, 0.5 * skin, span.size);
        true
    }

    /// Makes the short list anew.
    fn shorten(
        &mut self,
        window: &mut Window,
        span: Span,
        workers: &Workers,
        counts: &mut WindowCounts,
    ) {
        let Self { list, limits, walls, aside, .. } = self;
        let ahead = |displacement| ahead(*aside, span, displacement);
        let Window { bodies, bands, .. } = window;
        let fast = bands.iter_mut().flat_map(|band| band.fast.indices.drain(..));
        counts.tests += limits.shorten(list, bodies, fast, ahead, workers);
        walls.add(limits.outliers().places());
        self.over = 1.0;
    }
}

/// How far a particle would have to go for a pair that a list lacks to matter in the next step, which
/// takes no particle further than `displacement`, if pairs are watched `aside` beyond the margin.
fn ahead(aside: f64, span: Span, displacement: f64) -> f64 {
    0.5 * (MARGIN * CUTOFF + aside + 2.0 * span.rounding()) + displacement
}

impl Window {
    /// Rebuilds `list` for the particles as they are now, and notes which of them are fast. Brings back
    /// how many pairs were looked at.
    pub(crate) fn list(
        &mut self,
        list: &mut Neighbours,
        limits: &Limits,
        skin: f64,
        size: f64,
        workers: &Workers,
    ) -> u64 {
        let Self { bodies, spare, bands, share, .. } = self;
        let tested = list.rebuild(bodies, spare, skin, size, workers);
        bands.resize_with(list.blocks.len(), Band::default);
        let work = bands.iter_mut().zip(&list.blocks).collect();
        workers.map(work, |(band, block): (&mut Band, &Block)| {
            limits.note_fast(bodies, block.particles.clone(), &mut band.fast);
            band.particles = block.particles.clone();
            band.special.clear();
        });
        // No band is shorter.
        *share = bands.iter().map(|band| band.particles.len()).min().unwrap_or(1).max(1);
        tested
    }

    /// Takes the particles through a window whose pairs are found in the short list. False if
    /// a particle was pushed further than was watched: then they are still where they were.
    pub(crate) fn open_listed(
        &mut self,
        list: &Neighbours,
        walls: &mut Walls,
        layout: &Layout,
        workers: &Workers,
        counts: &mut WindowCounts,
    ) -> bool {
        let meet = walls.meet(&self.bodies, &layout.span);
        let (bodies, at_wall, arch) = (&self.bodies, &walls.at[..], Arch::new());
        let work = self.bands.iter_mut().zip(&list.blocks).collect();
        workers.map(work, |(band, block): (&mut Band, &Block)| {
            let (pairs, found) = (&block.pairs().pairs[..], &mut band.found);
            arch.dispatch(Approach { pairs, bodies, at_wall, layout, found });
            band.keep_inside();
            let place = |end| meet.partition_point(|&i| (i as usize) < end);
            let own = place(band.particles.start)..place(band.particles.end);
            band.walls.clear();
            band.walls.extend_from_slice(&meet[own]);
        });
        let mut across = Vec::new();
        for band in &self.bands {
            counts.tests += band.found.tested;
            across.extend_from_slice(&band.across);
        }
        self.compute(layout, across, workers, counts, |window, _, counts| {
            window.verify_listed(layout, workers, counts)
        })
    }

    /// Notes the fast members of groups, and brings back how many times as fast as allowed the
    /// fastest was.
    pub(crate) fn watch(&mut self, limits: &Limits, span: &Span, workers: &Workers) -> f64 {
        let Self { bodies, bands, late, .. } = self;
        let (bodies, whole) = (&*bodies, span.whole());
        let limit = limits.speed_limit(&(0..bodies.len()));
        let over = workers.map(bands.iter_mut().collect(), |band: &mut Band| {
            let Band { particles, batch, fast, .. } = band;
            fast.over = 1.0;
            batch.watch(bodies, whole, &limits.speed_limit(particles), fast);
            fast.over
        });
        let Some(Band { fast, .. }) = bands.first_mut() else { return 1.0 };
        fast.over = 1.0;
        late.iter().for_each(|batch| batch.watch(bodies, whole, &limit, fast));
        over.into_iter().fold(fast.over, f64::max)
    }
}
