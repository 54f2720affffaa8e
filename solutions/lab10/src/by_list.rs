//! A window of one step whose pairs come from a list.

use pulp::Arch;

use crate::Workers;
use crate::approach::Approach;
use crate::band::Band;
use crate::layout::Layout;
use crate::limits::Limits;
use crate::list::Block;
use crate::neighbours::Neighbours;
use crate::path::Span;
use crate::search::Pair;
use crate::tallies::Tallies;
use crate::walls::Walls;
use crate::watch::too_far_off;
use crate::window::Window;

impl Window {
    /// Rebuilds `list` for the particles as they are now, and sees who of them is fast. Brings back
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
            limits.look(bodies, block.particles.clone(), &mut band.fast);
            band.particles = block.particles.clone();
            band.special.clear();
        });
        // No band is shorter.
        *share = bands.iter().map(|band| band.particles.len()).min().unwrap_or(1).max(1);
        tested
    }

    /// Takes the particles through a window whose pairs are found in the short list. False if
    /// somebody was pushed further than was watched: then they are still where they were.
    pub(crate) fn open_listed(
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

    /// Notes who of the groups was fast, and brings back how many times as fast as allowed.
    pub(crate) fn watch(&mut self, limits: &Limits, span: &Span, workers: &Workers) -> f64 {
        let Self { bodies, bands, late, .. } = self;
        let (bodies, whole) = (&*bodies, span.whole());
        let everybody = limits.pace(&(0..bodies.len()));
        let over = workers.map(bands.iter_mut().collect(), |band: &mut Band| {
            let Band { particles, batch, fast, .. } = band;
            fast.over = 1.0;
            batch.watch(bodies, whole, &limits.pace(particles), fast);
            fast.over
        });
        let Some(Band { fast, .. }) = bands.first_mut() else { return 1.0 };
        fast.over = 1.0;
        late.iter().for_each(|batch| batch.watch(bodies, whole, &everybody, fast));
        over.into_iter().fold(fast.over, f64::max)
    }
}
