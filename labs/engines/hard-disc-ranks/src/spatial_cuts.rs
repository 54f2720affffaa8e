//! The engine whose ranks have strips and decide together: the data of a rank, and its messages.

use common::Event;
use common::hard::{Disc, Scene, Simulation};
use common_mpi::{Clock, Partners, Traffic};
use hard_discs::{BroadPhase, Collisions, Found, Planned, Square, Workers, reach};
use mpi::Rank;
use mpi::collective::SystemOperation;
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;
use solution5::Cut;
use solution6::{Cuts, exchange_all, exchange_beside};

use crate::decisions::Decisions;
use crate::seen::Seen;
use crate::strips::{Reach, Strips};
use crate::tally::Tally;
use crate::team::{Messages, Team};
use crate::wire::DiscWire;

/// The work of ranks with strips: each rank tests the pairs of its strip, and all ranks decide
/// together.
pub trait Deciding: Messages {
    /// The rules of a collision, and the search for pairs.
    type Rules: Collisions + BroadPhase;

    /// Returns the ranks whose strips the swept box of a disc touches. The box extends `reach`
    /// beyond the path of the centre.
    fn reached(strips: &Strips, disc: &DiscWire, reach: f64) -> Reach;

    /// Whether `rank` tests the pair of discs with the reaches `a` and `b`. This is true for
    /// exactly one rank that has both discs.
    fn looks_at(rank: usize, a: Reach, b: Reach) -> bool;

    /// Takes every open candidate that is certain to happen, and drops every candidate that cannot
    /// happen.
    fn take_certain(decisions: &mut Decisions);

    /// Takes one step. All ranks call this function together.
    fn step(engine: &mut SpatialCuts<Self>);
}

/// One rank of the job: the discs of its strip, and ghosts of other discs that fly into it.
pub struct SpatialCuts<T: Deciding> {
    /// The communicator of all ranks.
    pub world: SimpleCommunicator,
    /// Number of steps between two cuts; 0 cuts only once.
    pub recut: u64,
    /// The square, and the radius of all discs.
    pub square: Square,
    /// The strips of the square.
    pub strips: Strips,
    /// The discs of this rank's strip, in ascending order of numbers.
    pub own: Vec<DiscWire>,
    /// The discs that this rank has in a step.
    pub seen: Seen,
    /// This rank's knowledge of the decisions of a step.
    pub decisions: Decisions,
    /// The search for pairs.
    pub finder: Planned<T::Rules>,
    /// The result of the search in a window of time.
    pub found: Found,
    /// The messages that this rank has sent.
    pub traffic: Traffic,
    /// The counters of this rank.
    pub tally: Tally,
    /// The time that calls to the MPI library took.
    pub clock: Clock,
    /// Number of steps since the scene was loaded.
    pub steps: u64,
    /// Number of rounds of decisions in these steps.
    pub rounds: u64,
    /// Total number of ghosts in these steps.
    pub ghosts: u64,
}

/// Lengths that are the same for all ranks in a step.
#[derive(Clone, Copy)]
pub struct Range {
    /// Distance that a swept box extends beyond the path of the disc's centre.
    pub reach: f64,
    /// Greatest distance of a disc, at any time of the step, from the strip of a rank that has it.
    pub furthest: f64,
}

impl<T: Deciding> SpatialCuts<T> {
    /// Makes the engine of one rank of `world`. The square is cut again every `recut` steps.
    pub fn new(world: SimpleCommunicator, recut: u64, clock: Clock) -> Self {
        let cuts = Cuts { starts: vec![0] };
        Self {
            world,
            recut,
            square: Square { side: 1.0, radius: 0.5 },
            strips: Strips { bottom: 0.0, height: 0.0, cuts },
            own: Vec::new(),
            seen: Seen::default(),
            decisions: Decisions::default(),
            finder: Planned::new(Workers::One, None).undecided(),
            found: Found::default(),
            traffic: Traffic::default(),
            tally: Tally::default(),
            clock,
            steps: 0,
            rounds: 0,
            ghosts: 0,
        }
    }

    /// Returns the number of this rank.
    pub fn rank(&self) -> usize {
        self.world.rank() as usize
    }

    /// Returns the number of ranks.
    pub fn ranks(&self) -> usize {
        self.world.size() as usize
    }

    /// Cuts the square so that all ranks have equally many discs, and sends each disc to its rank.
    fn cut(&mut self) {
        self.strips = self
            .clock
            .call(Partners::All, || Strips::balanced(&self.world, &self.own, &mut self.traffic));
        let mut lists = vec![Vec::new(); self.ranks()];
        for disc in self.own.drain(..) {
            lists[self.strips.rank_of(disc.y)].push(disc);
        }
        let rank = self.world.rank() as usize;
        for (_, list) in lists.iter().enumerate().filter(|(other, _)| *other != rank) {
            self.traffic.sent(&[0_i32]);
            self.traffic.sent(list);
        }
        self.own = self.clock.call(Partners::All, || exchange_all(&self.world, &lists));
        self.own.sort_by_key(|disc| disc.number);
    }

    /// Returns the lengths of this step, from the greatest velocity component of the scene.
    ///
    /// A disc is at most this component and the reach away from a strip that its box touches. A
    /// collision may make the disc faster: it gains its partner's component along the line between
    /// the two centres. So its squared speed is at most the sum of both squared speeds, and no
    /// component is more than twice the greatest component before. So in total the disc gets at
    /// most three times as far away.
    pub fn range(&mut self) -> Range {
        let components = self.own.iter().map(|disc| disc.vx.abs().max(disc.vy.abs()));
        let own = components.fold(0.0, f64::max);
        let mut fastest = 0.0;
        self.clock.call(Partners::All, || {
            self.world.all_reduce_into(&own, &mut fastest, SystemOperation::max());
        });
        self.traffic.sent(&[own]);
        let reach = reach(self.square, fastest);
        Range { reach, furthest: 3.0 * (fastest + reach) }
    }

    /// Exchanges lists with `partners`, and calls `work` while the lists travel. Returns the
    /// partners' lists and the result of `work`.
    pub fn exchange<W, R>(
        &mut self,
        partners: &[usize],
        lists: Vec<Vec<W>>,
        work: impl FnOnce() -> R,
    ) -> (Vec<Vec<W>>, R)
    where
        W: Equivalence + Default + Clone,
    {
        let outgoing: Vec<_> =
            partners.iter().zip(lists).map(|(partner, list)| (*partner as Rank, list)).collect();
        for (_, list) in &outgoing {
            self.traffic.sent(&[0_u64]);
            self.traffic.sent(list);
        }
        self.clock.call(Partners::receivers(&outgoing), || {
            exchange_beside(&self.world, &outgoing, || self.clock.work(work))
        })
    }

    /// Returns the sum of the numbers `own` of all ranks. Every rank gets the result.
    pub fn add_up(&mut self, own: usize) -> u64 {
        self.rounds += 1;
        let own = own as u64;
        let mut sum = 0_u64;
        self.clock.call(Partners::All, || {
            self.world.all_reduce_into(&own, &mut sum, SystemOperation::sum());
        });
        self.traffic.sent(&[own]);
        sum
    }

    /// Sends discs to the ranks of their strips. No disc flies beyond the strips of the partners.
    pub fn bring(&mut self, partners: &[usize], moved: Vec<DiscWire>) {
        let rank = self.rank();
        let mut lists = vec![Vec::new(); partners.len()];
        self.own = moved;
        self.own.retain(|disc| {
            let owner = self.strips.rank_of(disc.y);
            if owner != rank {
                let partner = partners.binary_search(&owner);
                lists[partner.expect("no disc flies further than to a partner")].push(*disc);
            }
            owner == rank
        });
        let (arrived, ()) = self.exchange(partners, lists, || ());
        let stayed = self.own.len();
        self.own.extend(arrived.into_iter().flatten());
        if self.own.len() > stayed {
            self.own.sort_by_key(|disc| disc.number);
        }
    }
}

impl<T: Deciding> Simulation for SpatialCuts<T> {
    fn load(&mut self, scene: &Scene) {
        self.square = Square::of(scene);
        // Any share is right at first, because `cut` below sends each disc to the rank of its
        // strip.
        let share = Cut { rows: scene.len(), ranks: self.ranks() }.block(self.rank());
        self.own = share.map(|number| DiscWire::new(number, &scene.discs()[number])).collect();
        self.finder = Planned::new(Workers::One, None).undecided();
        self.found = Found::default();
        self.cut();
        self.traffic = Traffic::default();
        self.tally = Tally::default();
        self.steps = 0;
        self.rounds = 0;
        self.ghosts = 0;
        self.clock.start(&self.world);
    }

    fn step(&mut self) {
        self.traffic.begin_step();
        self.clock.begin_step();
        if self.recut > 0 && self.steps > 0 && self.steps.is_multiple_of(self.recut) {
            self.cut();
        }
        self.steps += 1;
        T::step(self);
        self.clock.end_step();
    }

    fn read(&self, first: usize, out: &mut [Disc]) {
        let wanted = first..first + out.len();
        let mut own = self.own.clone();
        own.retain(|disc| wanted.contains(&disc.index()));
        for wire in T::collect(&self.world, Team::new(self.ranks(), true), &own) {
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
