//! Windows of one official step, opened from a neighbour list.
//!
//! A window that looks for its pairs sorts everybody and searches around everybody. A list has
//! done so some steps ago: a pass over its pairs tells who could meet within the step. Those
//! form groups and take small steps, and the rest is that of any other window.

use common::soft::CUTOFF;
use pulp::Arch;

use crate::Workers;
use crate::approach::Approach;
use crate::band::Band;
use crate::batch::Batch;
use crate::layout::Layout;
use crate::list::Block;
use crate::neighbours::Neighbours;
use crate::path::Span;
use crate::runners::Runners;
use crate::search::Pair;
use crate::tallies::Tallies;
use crate::walls::Walls;
use crate::watch::too_far_off;
use crate::wear::Wear;
use crate::window::Window;

/// How close free flights come that are computed at once, beyond the cutoff and in cutoffs. Within
/// one step a push bends a path by less than in a longer window.
const MARGIN: f64 = 0.01;
/// How much beyond the margin pairs are watched as a rule, in cutoffs.
const ASIDE: f64 = 0.1;
/// The most that a list looks beyond the cutoff, in cutoffs, for the sake of the fastest and of
/// those that are pushed the furthest.
const MOST: f64 = 3.0;

/// How much thicker than the cheapest the skin of a list is that is shortened before it is used.
const THICKER: f64 = 1.3;
/// Steps that a short list should last beyond the first, and a little for the rounding.
const MORE: f64 = 2.05;

/// A neighbour list, and what must be known of its particles.
pub(crate) struct Listed {
    list: Neighbours,
    walls: Walls,
    /// Of the list's list: the pairs of the next few steps.
    short: Wear,
    /// Nobody is faster.
    fastest: f64,
    /// How much beyond the margin pairs are watched.
    aside: f64,
}

impl Default for Listed {
    fn default() -> Self {
        Self {
            list: Neighbours::default(),
            walls: Walls::default(),
            short: Wear::default(),
            fastest: 0.0,
            aside: ASIDE * CUTOFF,
        }
    }
}

impl Listed {
    /// Forgets the list: the particles are others, or in another order.
    pub(crate) fn forget(&mut self) {
        self.list.forget();
    }

    /// Takes the particles of `window` through `span`, one official step. False if one of them is
    /// too fast for a list, or is pushed too far: then they are still where they were.
    pub(crate) fn open(
        &mut self,
        window: &mut Window,
        span: Span,
        workers: &Workers,
        tallies: &mut Tallies,
    ) -> bool {
        if self.is_worn_out(span) {
            self.aside = (0.5 * self.aside).max(ASIDE * CUTOFF);
        }
        loop {
            if self.is_worn_out(span) && !self.rebuild(window, span, workers, tallies) {
                return false;
            }
            let layout = self.layout(span);
            self.shorten(window, &layout, workers, tallies);
            let Self { list, walls, .. } = self;
            if window.open_listed(list, walls, &layout, workers, tallies) {
                let (fastest, furthest) = window.progress(workers);
                self.fastest = self.fastest.max(fastest);
                let way = furthest.max(layout.reach) + span.rounding();
                self.list.wear.way += way;
                self.short.way += way;
                return true;
            }
            tallies.redone += 1;
            self.aside *= 2.0;
        }
    }

    fn layout(&self, span: Span) -> Layout {
        let reach = self.fastest * span.whole();
        Layout { span, margin: MARGIN * CUTOFF, reach, aside: self.aside }
    }

    /// Whether the list might lack a pair that has to be looked at in the next step.
    fn is_worn_out(&self, span: Span) -> bool {
        self.list.wear.is_out(ahead(&self.layout(span)))
    }

    /// Builds the list anew, unless it would be too long.
    fn rebuild(
        &mut self,
        window: &mut Window,
        span: Span,
        workers: &Workers,
        tallies: &mut Tallies,
    ) -> bool {
        self.fastest = window.bodies.fastest();
        let layout = self.layout(span);
        let least = 2.0 * ahead(&layout) * (1.0 + 1e-9);
        if least > MOST * CUTOFF {
            self.forget();
            return false;
        }
        let cheapest = self.list.cheapest_skin(&window.bodies, self.fastest * span.whole());
        let skin = least.max(THICKER * cheapest + layout.margin + layout.aside);
        tallies.tests += window.list(&mut self.list, skin, span.size, workers);
        tallies.lists += 1;
        self.short = Wear::default();
        // Whoever is further away goes half the skin at most before the list is worn out.
        self.walls.find(&window.bodies, 0.5 * skin, span.size);
        true
    }

    /// Makes the short list anew if it might lack a pair that has to be looked at in the next step.
    fn shorten(
        &mut self,
        window: &mut Window,
        layout: &Layout,
        workers: &Workers,
        tallies: &mut Tallies,
    ) {
        if !self.short.is_out(ahead(layout)) {
            return;
        }
        let skin = 2.0 * (ahead(layout) + MORE * layout.reach);
        self.short = Wear::of(skin);
        tallies.tests += self.list.shorten(skin, &Runners::default(), &window.bodies, workers);
    }
}

/// How far somebody would have to go for a pair that a list lacks to matter in the next step.
fn ahead(layout: &Layout) -> f64 {
    0.5 * (layout.within() - CUTOFF)
}

impl Window {
    /// Rebuilds `list` for the particles as they are now. Brings back how many pairs were looked at.
    fn list(&mut self, list: &mut Neighbours, skin: f64, size: f64, workers: &Workers) -> u64 {
        let tested = list.rebuild(&mut self.bodies, &mut self.spare, skin, size, workers);
        self.bands.resize_with(list.blocks.len(), Band::default);
        for (band, block) in self.bands.iter_mut().zip(&list.blocks) {
            band.particles = block.particles.clone();
            band.special.clear();
        }
        // No band is shorter.
        self.share = self.bands.iter().map(|band| band.particles.len()).min().unwrap_or(1).max(1);
        tested
    }

    /// Takes the particles through a window whose pairs are found in the short list. False if somebody was
    /// pushed further than was watched: then they are still where they were.
    fn open_listed(
        &mut self,
        list: &Neighbours,
        walls: &mut Walls,
        layout: &Layout,
        workers: &Workers,
        tallies: &mut Tallies,
    ) -> bool {
        let meet = walls.meet(&self.bodies, &layout.span);
        let (bodies, at_wall, arch) = (&self.bodies, &walls.at[..], Arch::new());
        let work = self.bands.iter_mut().zip(&list.blocks).collect();
        workers.map(work, |(band, block): (&mut Band, &Block)| {
            let (pairs, found) = (&block.near.pairs[..], &mut band.found);
            arch.dispatch(Approach { pairs, bodies, at_wall, layout, found });
            band.keep_inside();
            let place = |end| meet.partition_point(|&i| (i as usize) < end);
            let own = place(band.particles.start)..place(band.particles.end);
            band.walls.clear();
            band.walls.extend_from_slice(&meet[own]);
        });
        let mut across = Vec::new();
        for band in &self.bands {
            tallies.tests += band.found.tested;
            across.extend_from_slice(&band.across);
        }
        self.compute(layout, across, workers, tallies, |window, _, tallies| {
            window.verify_listed(layout, workers, tallies)
        })
    }

    /// Pairs that nobody computed and that touched after all. None if somebody was pushed so far
    /// that a pair may have touched that was not watched.
    fn verify_listed(
        &self,
        layout: &Layout,
        workers: &Workers,
        tallies: &mut Tallies,
    ) -> Option<Vec<Pair>> {
        let most = self.most_bent();
        if !too_far_off(most, layout.margin) {
            return Some(Vec::new());
        }
        if too_far_off(most, layout.margin + layout.aside) {
            return None;
        }
        let broken = workers.map(self.bands.iter().collect(), |band: &Band| {
            let near =
                band.found.watched.iter().filter(|&&pair| self.may_have_touched(pair, layout));
            let near: Vec<Pair> = near.copied().filter(|&pair| !self.computes(pair)).collect();
            let tested = near.len() as u64;
            let touched = near.into_iter().filter(|&pair| self.touched(pair, layout));
            (touched.collect::<Vec<Pair>>(), tested)
        });
        tallies.tests += broken.iter().map(|(_, tested)| tested).sum::<u64>();
        Some(broken.into_iter().flat_map(|(pairs, _)| pairs).collect())
    }

    /// The greatest speed in which any member of a group ends, and the furthest from where it was.
    fn progress(&self, workers: &Workers) -> (f64, f64) {
        let batches = self.bands.iter().map(|band| &band.batch).chain(&self.late).collect();
        let squares = workers.map(batches, |batch: &Batch| batch.progress(&self.bodies));
        let most = |a: (f64, f64), b: (f64, f64)| (a.0.max(b.0), a.1.max(b.1));
        let (speed, way) = squares.into_iter().fold((0.0, 0.0), most);
        (speed.sqrt(), way.sqrt())
    }
}
