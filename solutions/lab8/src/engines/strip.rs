//! A rank with a strip: its discs, its messages, its search.

use common::hard::Scene;
use common_mpi::{Clock, Partners, Traffic};
use hard_discs::{Find, Found, Planned, Workers, reach};
use mpi::Rank;
use mpi::collective::SystemOperation;
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;
use solution5::Cut;
use solution6::{Cuts, exchange_all, exchange_beside};
use solution7::{Candidate, Hit, Lab7, Square, Window, wall_hit};

use super::seen::Seen;
use crate::ranks::Tally;
use crate::{Decisions, DiscWire, Strips, looks_at};

/// One rank of the job: the discs of its strip, and ghosts of other discs that fly into it.
pub struct SpatialCuts {
    pub(crate) world: SimpleCommunicator,
    /// Steps between two cuts; 0 cuts only once.
    pub(crate) recut: u64,
    pub(crate) square: Square,
    pub(crate) strips: Strips,
    /// The discs of this rank's strip, in ascending order of numbers.
    pub(crate) own: Vec<DiscWire>,
    pub(crate) seen: Seen,
    pub(crate) decisions: Decisions,
    pub(crate) finder: Planned<Lab7>,
    pub(crate) found: Found,
    pub(crate) traffic: Traffic,
    pub(crate) tally: Tally,
    pub(crate) clock: Clock,
    pub(crate) steps: u64,
    pub(crate) rounds: u64,
    pub(crate) ghosts: u64,
}

/// What is the same for all ranks in a step.
#[derive(Clone, Copy)]
pub(crate) struct Range {
    /// How far a swept box goes beyond the path of its centre.
    pub(crate) reach: f64,
    /// How far a disc can be, at any time of the step, from the strip of a rank that has it.
    pub(crate) furthest: f64,
}

impl SpatialCuts {
    /// One rank of all in `world`, that cuts the square again every `recut` steps.
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

    /// Starts over from `scene`.
    pub(crate) fn start(&mut self, scene: &Scene) {
        self.square = Square::of(scene);
        // Any share will do to begin with: the cut sends each disc to its rank.
        let share = Cut { rows: scene.len(), ranks: self.ranks() }.block(self.rank());
        self.own = share.map(|number| DiscWire::new(number, &scene.discs()[number])).collect();
        self.finder = Planned::new(Workers::One, None).undecided();
        self.found = Found::default();
        self.cut();
        self.traffic = Traffic::default();
        self.tally = Tally::default();
        (self.steps, self.rounds, self.ghosts) = (0, 0, 0);
        self.clock.start(&self.world);
    }

    pub(crate) fn rank(&self) -> usize {
        self.world.rank() as usize
    }

    pub(crate) fn ranks(&self) -> usize {
        self.world.size() as usize
    }

    /// Cuts the square so that all ranks have equally many discs, and sends each disc to its rank.
    pub(crate) fn cut(&mut self) {
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

    /// What all ranks must agree on before a step: it follows from the greatest velocity component
    /// of the scene.
    ///
    /// A disc is at most that and the reach away from a strip that its box reaches. A collision may
    /// make it faster: it gains its partner's component along the line between them, so its speed
    /// squared is at most the sum of both, and no component is more than twice the greatest of before.
    /// All in all a disc gets at most three times the greatest component away.
    pub(crate) fn range(&mut self) -> Range {
        let faster = |most: f64, disc: &DiscWire| most.max(disc.vx.abs()).max(disc.vy.abs());
        let (own, mut fastest) = (self.own.iter().fold(0.0, faster), 0.0);
        self.clock.call(Partners::All, || {
            self.world.all_reduce_into(&own, &mut fastest, SystemOperation::max());
        });
        self.traffic.sent(&[own]);
        let reach = reach(self.square, fastest);
        Range { reach, furthest: 3.0 * (fastest + reach) }
    }

    /// Sends each of `partners` its list and returns the lists that they send; does `work` meanwhile.
    pub(crate) fn exchange<T, R>(
        &mut self,
        partners: &[usize],
        lists: Vec<Vec<T>>,
        work: impl FnOnce() -> R,
    ) -> (Vec<Vec<T>>, R)
    where
        T: Equivalence + Default + Clone,
    {
        let outgoing: Vec<_> =
            partners.iter().zip(lists).map(|(partner, list)| (*partner as Rank, list)).collect();
        for (_, list) in &outgoing {
            self.traffic.sent(&[0_u64]);
            self.traffic.sent(list);
        }
        let work = || self.clock.work(work);
        self.clock
            .call(Partners::receivers(&outgoing), || exchange_beside(&self.world, &outgoing, work))
    }

    /// Fills `self.seen` with the own discs and `ghosts`.
    pub(crate) fn see(&mut self, ghosts: &[Vec<DiscWire>], range: Range) {
        let mut ghosts = ghosts.concat();
        ghosts.sort_by_key(|ghost| ghost.number);
        self.ghosts += ghosts.len() as u64;
        self.seen.fill(&self.own, &ghosts, |disc| self.strips.reached(disc, range.reach));
    }

    /// Starts the decisions with the discs seen, and enters what could happen to them: the `walls` of the
    /// own discs, and the pairs at which this rank has to look; lab 7's finder finds them.
    ///
    /// As in lab 7 the step is cut into windows of time, and a disc that has been taken in one window
    /// need not be looked at in the next. Here these are the discs of candidates that are certain after
    /// each window ([`Decisions::take_certain`]): later windows have later candidates, so the first so
    /// far stays the first. For the same reason walls are entered in their windows.
    pub(crate) fn find(&mut self, mut walls: Vec<Candidate>) {
        let Seen { numbers, discs, reach, .. } = &self.seen;
        self.decisions.start(numbers, reach, &[]);
        if discs.is_empty() {
            return;
        }
        let rank = self.world.rank() as usize;
        let windows = self.finder.windows(discs, self.square);
        walls.sort_unstable_by(|a, b| a.time.total_cmp(&b.time));
        let (mut walls, before) = (&walls[..], self.found.pair_tests);
        for k in 0..windows {
            let window = Window::part(k, windows);
            self.found.clear(1);
            self.finder.find(discs, &self.decisions.free, self.square, window, &mut self.found);
            let (now, later) = walls.split_at(walls.partition_point(|wall| wall.time < window.to));
            walls = later;
            let pairs = self.found.lists.iter().flatten().filter(|candidate| match candidate.hit {
                Hit::Pair(a, b) => looks_at(rank, reach[a as usize], reach[b as usize]),
                _ => false,
            });
            let here = now.iter().map(|wall| self.decisions.local(wall)).chain(pairs.copied());
            let here: Vec<Candidate> = here.collect();
            self.tally.candidates += here.len() as u64;
            self.decisions.queues.enter(here);
            self.decisions.take_certain();
        }
        self.tally.pair_tests += self.found.pair_tests - before;
    }

    /// The sum of a number over all ranks, on all ranks.
    pub(crate) fn add_up(&mut self, own: usize) -> u64 {
        self.rounds += 1;
        let (own, mut sum) = (own as u64, 0_u64);
        self.clock.call(Partners::All, || {
            self.world.all_reduce_into(&own, &mut sum, SystemOperation::sum());
        });
        self.traffic.sent(&[own]);
        sum
    }

    /// Sends discs to the ranks in whose strips they are. No disc flies further than to a partner.
    pub(crate) fn bring(&mut self, partners: &[usize], moved: Vec<DiscWire>) {
        let (rank, strips) = (self.rank(), &self.strips);
        let mut lists = vec![Vec::new(); partners.len()];
        self.own = moved;
        self.own.retain(|disc| {
            let owner = strips.rank_of(disc.y);
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

/// The wall collisions that could happen to `discs` in this step.
pub fn walls_of(discs: &[DiscWire], square: Square) -> Vec<Candidate> {
    discs.iter().filter_map(|disc| wall_hit(disc.number as u32, &disc.into(), square)).collect()
}
