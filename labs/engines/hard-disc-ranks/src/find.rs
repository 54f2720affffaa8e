//! The search of a rank in its strip.

use common::hard::Disc;
use common_mpi::note;
use hard_discs::{Candidate, Collisions, Find, Hit, Square, Window};
use mpi::traits::*;

use crate::seen::Seen;
use crate::spatial_cuts::{Deciding, Range, SpatialCuts};
use crate::wire::DiscWire;

impl<T: Deciding> SpatialCuts<T> {
    /// Fills `self.seen` with this rank's discs and with `ghosts`.
    pub fn see(&mut self, ghosts: &[Vec<DiscWire>], range: Range) {
        let mut ghosts = ghosts.concat();
        ghosts.sort_by_key(|ghost| ghost.number);
        self.ghosts += ghosts.len() as u64;
        self.seen.fill(&self.own, &ghosts, |disc| T::reached(&self.strips, disc, range.reach));
    }

    /// Starts the decisions with the discs in `self.seen`, and enters their candidates.
    ///
    /// The candidates are the `walls` of this rank's discs, and the pairs that this rank must test.
    /// The step is divided into windows of time. After each window, the candidates that are certain
    /// are taken ([`Deciding::take_certain`]), and the next window does not test their discs. No
    /// later window can change these decisions, because its candidates are all later. For the same
    /// reason, wall collisions are entered in the windows of their times.
    pub fn find(&mut self, mut walls: Vec<Candidate>) {
        let Seen { numbers, discs, reach, .. } = &self.seen;
        self.decisions.start::<T::Rules>(numbers, reach, &[]);
        if discs.is_empty() {
            return;
        }
        let rank = self.world.rank() as usize;
        let windows = self.finder.windows(discs, self.square);
        walls.sort_unstable_by(|a, b| a.time.total_cmp(&b.time));
        let mut walls = &walls[..];
        let before = self.found.pair_tests;
        for k in 0..windows {
            let window = Window::part(k, windows);
            self.found.clear(1);
            self.finder.find(discs, &self.decisions.free, self.square, window, &mut self.found);
            let (now, later) = walls.split_at(walls.partition_point(|wall| wall.time < window.to));
            walls = later;
            let pairs = self.found.lists.iter().flatten().filter(|candidate| match candidate.hit {
                Hit::Pair(a, b) => T::looks_at(rank, reach[a as usize], reach[b as usize]),
                _ => false,
            });
            let here = now.iter().map(|wall| self.decisions.local(wall)).chain(pairs.copied());
            let here: Vec<Candidate> = here.collect();
            self.tally.candidates += here.len() as u64;
            self.decisions.queues.enter::<T::Rules>(here);
            T::take_certain(&mut self.decisions);
        }
        self.tally.pair_tests += self.found.pair_tests - before;
    }
}

/// Returns the candidates of `discs` with walls in this step.
pub fn walls_of<C: Collisions>(discs: &[DiscWire], square: Square) -> Vec<Candidate> {
    note("walls_of");
    discs
        .iter()
        .filter_map(|disc| C::wall_hit(disc.number as u32, &Disc::from(disc), square))
        .collect()
}
