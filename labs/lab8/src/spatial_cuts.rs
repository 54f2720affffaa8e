//! Task 8.13: no master.

use common::hard::{Disc, Scene, Simulation};
use common_mpi::Traffic;
use mpi::Rank;
use mpi::collective::SystemOperation;
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;
use solution5::Cut;
use solution6::{exchange_all, exchange_beside};
use solution7::{Candidate, Find, Found, Hit, Planned, Square, Window, Workers, reach, wall_hit};

use crate::tally::Tally;
use crate::{Crew, DiscWire, Docket, Reach, Strips, collect, ghosts_for, looks_at, move_on};

/// One rank of the job: the discs of its strip, and ghosts of those that fly into it.
pub struct SpatialCuts {
    world: SimpleCommunicator,
    /// Steps between two cuts; 0 cuts only once.
    recut: u64,
    square: Square,
    strips: Strips,
    /// The discs of this rank's strip, in ascending order of numbers.
    own: Vec<DiscWire>,
    seen: Seen,
    docket: Docket,
    finder: Planned,
    found: Found,
    traffic: Traffic,
    tally: Tally,
    steps: u64,
    rounds: u64,
    ghosts: u64,
}

/// What this rank sees in a step: its own discs and ghosts, in ascending order of numbers.
#[derive(Default)]
struct Seen {
    numbers: Vec<u32>,
    discs: Vec<Disc>,
    owns: Vec<bool>,
    reach: Vec<Reach>,
}

impl Seen {
    fn clear(&mut self) {
        self.numbers.clear();
        self.discs.clear();
        self.owns.clear();
        self.reach.clear();
    }

    fn push(&mut self, disc: &DiscWire, owns: bool, reach: Reach) {
        self.numbers.push(disc.number as u32);
        self.discs.push(disc.into());
        self.owns.push(owns);
        self.reach.push(reach);
    }
}

/// What is the same for all ranks in a step.
#[derive(Clone, Copy)]
struct Range {
    /// How far a swept box goes beyond the way of its centre.
    reach: f64,
    /// How far from the strip of a rank that has it a disc can be at any time of the step.
    furthest: f64,
}

impl SpatialCuts {
    /// One rank of all in `world`, that cuts the square anew every `recut` steps.
    pub fn new(world: SimpleCommunicator, recut: u64) -> Self {
        let cuts = solution6::Cuts { starts: vec![0] };
        Self {
            world,
            recut,
            square: Square { side: 1.0, radius: 0.5 },
            strips: Strips { bottom: 0.0, height: 0.0, cuts },
            own: Vec::new(),
            seen: Seen::default(),
            docket: Docket::default(),
            finder: Planned::new(Workers::One, None),
            found: Found::default(),
            traffic: Traffic::default(),
            tally: Tally::default(),
            steps: 0,
            rounds: 0,
            ghosts: 0,
        }
    }

    fn rank(&self) -> usize {
        self.world.rank() as usize
    }

    fn ranks(&self) -> usize {
        self.world.size() as usize
    }

    /// Cuts the square so that all ranks have as many discs, and brings each to its rank.
    fn cut(&mut self) {
        self.strips = Strips::balanced(&self.world, &self.own, &mut self.traffic);
        let mut lists = vec![Vec::new(); self.ranks()];
        for disc in self.own.drain(..) {
            lists[self.strips.rank_of(disc.y)].push(disc);
        }
        let rank = self.world.rank() as usize;
        for (_, list) in lists.iter().enumerate().filter(|(other, _)| *other != rank) {
            self.traffic.sent(&[0_i32]);
            self.traffic.sent(list);
        }
        self.own = exchange_all(&self.world, &lists);
        self.own.sort_by_key(|disc| disc.number);
    }

    /// What all ranks must agree on before a step: it follows from the greatest velocity component
    /// of the scene.
    ///
    /// A disc is at most that and the reach away from a strip that its box reaches. A collision may
    /// make it faster: it gains the other's component along the line between them, so the sum of
    /// both speeds squared bounds its own squared, and no component is more than twice the greatest
    /// of before. Three times the greatest is the furthest, all in all.
    fn range(&mut self) -> Range {
        let faster = |most: f64, disc: &DiscWire| most.max(disc.vx.abs()).max(disc.vy.abs());
        let (own, mut fastest) = (self.own.iter().fold(0.0, faster), 0.0);
        self.world.all_reduce_into(&own, &mut fastest, SystemOperation::max());
        self.traffic.sent(&[own]);
        let reach = reach(self.square, fastest);
        Range { reach, furthest: 3.0 * (fastest + reach) }
    }

    /// Sends each of `partners` its list and returns what they send, while `work` is done.
    fn exchange<T, R>(
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
        exchange_beside(&self.world, &outgoing, work)
    }

    /// Fills `self.seen` with the own discs and `ghosts`, merged in the order of numbers.
    fn see(&mut self, ghosts: &[Vec<DiscWire>], range: Range) {
        let mut ghosts = ghosts.concat();
        ghosts.sort_by_key(|ghost| ghost.number);
        self.ghosts += ghosts.len() as u64;
        self.seen.clear();
        let mut see = |disc: &DiscWire, owns: bool| {
            self.seen.push(disc, owns, self.strips.reached(disc, range.reach));
        };
        let mut ghosts = ghosts.iter().peekable();
        for disc in &self.own {
            while let Some(ghost) = ghosts.next_if(|ghost| ghost.number < disc.number) {
                see(ghost, false);
            }
            see(disc, true);
        }
        ghosts.for_each(|ghost| see(ghost, false));
    }

    /// Starts the docket with the discs seen, and enters what could happen to them: the `walls` of the
    /// own discs, and the pairs that are this rank's to look at, which lab 7's finder finds.
    ///
    /// As in lab 7 the step is cut into windows of time, and who has been taken in one window need
    /// not be looked at in the next. Here that holds for what is certain after each window
    /// ([`Docket::take_certain`]): later windows have later candidates, so the first so far stays
    /// the first. Walls must be entered in their windows for the same reason.
    fn find(&mut self, mut walls: Vec<Candidate>) {
        let Seen { numbers, discs, reach, .. } = &self.seen;
        self.docket.start(numbers, reach, &[]);
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
            self.finder.find(discs, &self.docket.free, self.square, window, &mut self.found);
            let (now, later) = walls.split_at(walls.partition_point(|wall| wall.time < window.to));
            walls = later;
            let pairs = self.found.lists.iter().flatten().filter(|candidate| match candidate.hit {
                Hit::Pair(a, b) => looks_at(rank, reach[a as usize], reach[b as usize]),
                _ => false,
            });
            let here = now.iter().map(|wall| self.docket.local(wall)).chain(pairs.copied());
            let here: Vec<Candidate> = here.collect();
            self.tally.candidates += here.len() as u64;
            self.docket.queues.enter(here);
            self.docket.take_certain();
        }
        self.tally.pair_tests += self.found.pair_tests - before;
    }

    /// Decides together with the others, starting from what `self.docket` knows.
    ///
    /// In rounds:
    ///
    /// 1. Take what is certain ([`Docket::take_certain`]).
    /// 2. All ranks add up how much there is to say: candidates in `front`, which is empty only if
    ///    none is open, and candidates taken that nobody has been told of ([`Self::add_up`]). If it
    ///    is nothing, all are done. All get the same sum, so all end in the same round.
    /// 3. Make the news for each partner ([`Docket::news_for`]); from now on all that was taken
    ///    counts as told. Exchange them ([`Self::exchange`], with nothing to do beside), and hear
    ///    what has arrived, all of it at once ([`Docket::hear`]).
    ///
    /// In every round the earliest candidate that is open anywhere is taken or dropped, so it ends.
    /// Mostly after two or three; in a crowd, where a decision waits for a decision across the cut
    /// and that for another back across it, after a hundred.
    ///
    /// All ranks call it together, those without partners or candidates too.
    ///
    /// Book: chapter 8, *Deciding together*.
    fn decide(&mut self, partners: &[usize]) {
        todo!("task 8.13: decide together")
    }

    /// The sum of a number over all ranks, on all ranks.
    fn add_up(&mut self, own: usize) -> u64 {
        self.rounds += 1;
        let (own, mut sum) = (own as u64, 0_u64);
        self.world.all_reduce_into(&own, &mut sum, SystemOperation::sum());
        self.traffic.sent(&[own]);
        sum
    }

    /// One step.
    ///
    /// 1. Agree on the `range` of this step ([`Self::range`]), which says who the partners are:
    ///    [`Strips::partners`] of this rank within `range.furthest`.
    /// 2. Send ghosts to the partners ([`ghosts_for`], [`Self::exchange`]), and while they travel
    ///    find the wall collisions of the own discs ([`walls_of`]). Ghosts are not looked at for
    ///    walls: their owners do that.
    /// 3. See everybody ([`Self::see`]), and find the pairs ([`Self::find`]): this fills the docket
    ///    and takes what is certain at once.
    /// 4. Decide about the rest ([`Self::decide`]).
    /// 5. Move the discs ([`move_on`]), count what was taken (`self.tally.taken`), and bring each disc to
    ///    the rank in whose strip it is now ([`Self::bring`]).
    ///
    /// All ranks call it together.
    ///
    /// Book: chapter 8, *A step without a master*.
    fn step_once(&mut self) {
        todo!("task 8.13b: a step without a master")
    }

    /// Brings discs to the ranks in whose strips they are. Nobody gets further than to a partner.
    fn bring(&mut self, partners: &[usize], moved: Vec<DiscWire>) {
        let (rank, strips) = (self.rank(), &self.strips);
        let mut lists = vec![Vec::new(); partners.len()];
        self.own = moved;
        self.own.retain(|disc| {
            let owner = strips.rank_of(disc.y);
            if owner != rank {
                let partner = partners.binary_search(&owner);
                lists[partner.expect("nobody flies further than a partner")].push(*disc);
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

impl Simulation for SpatialCuts {
    fn load(&mut self, scene: &Scene) {
        self.square = Square::of(scene);
        // Any share will do to begin with: cutting brings everybody home.
        let share = Cut { rows: scene.len(), ranks: self.ranks() }.block(self.rank());
        self.own = share.map(|number| DiscWire::new(number, &scene.discs()[number])).collect();
        self.finder = Planned::new(Workers::One, None);
        self.found = Found::default();
        self.cut();
        self.traffic = Traffic::default();
        self.tally = Tally::default();
        (self.steps, self.rounds, self.ghosts) = (0, 0, 0);
    }

    fn step(&mut self) {
        self.traffic.begin_step();
        if self.recut > 0 && self.steps > 0 && self.steps.is_multiple_of(self.recut) {
            self.cut();
        }
        self.steps += 1;
        self.step_once();
    }

    fn read(&self, first: usize, out: &mut [Disc]) {
        let wanted = |disc: &&DiscWire| (first..first + out.len()).contains(&disc.place());
        let own: Vec<DiscWire> = self.own.iter().filter(wanted).copied().collect();
        for wire in collect(&self.world, Crew::new(self.ranks(), true), &own) {
            out[wire.place() - first] = Disc::from(&wire);
        }
    }

    fn counters(&self) -> Vec<(&'static str, f64)> {
        let mut counters = self.tally.report(&self.world, &self.traffic);
        let mut ghosts = 0_u64;
        self.world.all_reduce_into(&self.ghosts, &mut ghosts, SystemOperation::sum());
        let steps = self.steps.max(1) as f64;
        counters.push(("ghosts per step, all ranks", ghosts as f64 / steps));
        counters.push(("rounds of deciding per step", self.rounds as f64 / steps));
        counters
    }
}
