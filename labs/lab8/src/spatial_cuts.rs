//! Task 8.13: a step without a master.

use common::Event;
use common::hard::{Disc, Scene, Simulation};
use mpi::collective::SystemOperation;
use mpi::traits::*;

use crate::engines::{Seen, SpatialCuts, walls_of};
use crate::{DiscWire, Team, collect, ghosts_for, move_on};

impl SpatialCuts {
    /// Decides together with the partners, starting from what `self.decisions` knows.
    ///
    /// In rounds:
    ///
    /// 1. Take what is certain ([`Decisions::take_certain`]).
    /// 2. All ranks add up how much there is to tell: the candidates in `front`, which is empty only if
    ///    none is open, and the taken candidates that have not been told ([`Self::add_up`]). If the sum
    ///    is zero, return. All ranks get the same sum, so all return in the same round.
    /// 3. Make the news for each partner ([`Decisions::news_for`]); from now on all taken candidates
    ///    count as told. Exchange the news ([`Self::exchange`], with nothing to do beside), and hear
    ///    the news of all partners at once ([`Decisions::hear`]).
    ///
    /// In every round the earliest candidate that is open on any rank is taken or dropped, so the rounds
    /// end: mostly after two to five; in a crowd, where a decision waits for one across the cut and
    /// that for another back across it, after a hundred.
    ///
    /// All ranks call it together, ranks without partners or candidates too.
    ///
    /// Book: chapter 8, *Deciding together*.
    ///
    /// [`Decisions::take_certain`]: crate::Decisions::take_certain
    /// [`Decisions::news_for`]: crate::Decisions::news_for
    /// [`Decisions::hear`]: crate::Decisions::hear
    fn decide(&mut self, partners: &[usize]) {
        todo!("task 8.13: decide together")
    }

    /// One step.
    ///
    /// 1. Agree on the `range` of this step ([`Self::range`]), from which the partners follow:
    ///    [`Strips::partners`] of this rank within `range.furthest`.
    /// 2. Send ghosts to the partners ([`ghosts_for`], [`Self::exchange`]), and while they travel
    ///    find the wall collisions of the own discs ([`walls_of`]). The owner of a ghost finds
    ///    its wall collisions. While `self` exchanges, nothing of it can be borrowed: [take](std::mem::take) `own` out, and
    ///    put it back.
    /// 3. Put own discs and ghosts together ([`Self::see`]), and find the pairs ([`Self::find`]): this
    ///    starts the decisions and takes what is certain at once.
    /// 4. Decide about the rest ([`Self::decide`]).
    /// 5. Move the discs ([`move_on`], of `self.seen`), count what was taken (`self.tally.taken`), and send each disc to
    ///    the rank in whose strip it is now ([`Self::bring`]).
    ///
    /// All ranks call it together.
    ///
    /// Book: chapter 8, *A step without a master*.
    ///
    /// [`Strips::partners`]: crate::Strips::partners
    fn step_once(&mut self) {
        todo!("task 8.13b: a step without a master")
    }
}

impl Simulation for SpatialCuts {
    fn load(&mut self, scene: &Scene) {
        self.start(scene);
    }

    fn step(&mut self) {
        self.traffic.begin_step();
        self.clock.begin_step();
        if self.recut > 0 && self.steps > 0 && self.steps.is_multiple_of(self.recut) {
            self.cut();
        }
        self.steps += 1;
        self.step_once();
        self.clock.end_step();
    }

    fn read(&self, first: usize, out: &mut [Disc]) {
        let wanted = |disc: &&DiscWire| (first..first + out.len()).contains(&disc.index());
        let own: Vec<DiscWire> = self.own.iter().filter(wanted).copied().collect();
        for wire in collect(&self.world, Team::new(self.ranks(), true), &own) {
            out[wire.index() - first] = Disc::from(&wire);
        }
    }

    fn counters(&self) -> Vec<(&'static str, f64)> {
        let mut counters = self.tally.report(&self.world, &self.traffic);
        let mut ghosts = 0_u64;
        self.world.all_reduce_into(&self.ghosts, &mut ghosts, SystemOperation::sum());
        let steps = self.steps.max(1) as f64;
        counters.push(("ghosts per step, all ranks", ghosts as f64 / steps));
        counters.push(("rounds of deciding per step", self.rounds as f64 / steps));
        counters.extend(self.clock.report(&self.world));
        counters
    }

    fn events(&self) -> Option<Vec<Event>> {
        self.clock.events(&self.world)
    }
}
