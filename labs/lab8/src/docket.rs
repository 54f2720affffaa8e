//! Tasks 8.10 and 8.11: deciding with others.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use solution7::{Candidate, Hit, order};

use crate::queues::discs_of;
use crate::{CandidateWire, Queues, Reach};

/// What a rank knows of the decision: the discs that it has, own and ghosts, its candidates, and what
/// it has heard from others.
///
/// All lists of discs are in ascending order of numbers; a *place* is an index into them.
/// Candidates in `queues` name discs by their places, all others by their numbers.
#[derive(Clone, Debug, Default)]
pub struct Docket {
    /// The numbers of the discs, ascending.
    pub numbers: Vec<u32>,
    /// Which ranks have the disc.
    pub reach: Vec<Reach>,
    /// Whether the disc has not collided yet in this step, as far as is known here.
    pub free: Vec<bool>,
    /// The earliest candidate of the disc among those of *other* ranks, as far as is known here. No
    /// candidate of the disc may be taken here that does not come before it.
    pub rivals: Vec<Option<Candidate>>,
    /// The candidates found here, in a queue for each disc.
    pub queues: Queues,
    /// Those that are open, neither taken nor dropped, and the earliest such of a disc of theirs.
    pub front: Vec<Candidate>,
    /// Those found here that happen.
    pub taken: Vec<Candidate>,
    /// So many of `taken` have been told to others.
    pub told: usize,
    /// Whether the disc waits for an open candidate to be decided. Nobody does between two calls.
    pub waits: Vec<bool>,
}

/// Earlier than anything: what stands for the candidates of others before they have spoken.
pub const UNKNOWN: Candidate = Candidate { time: f64::NEG_INFINITY, hit: Hit::Corner(0) };

impl Docket {
    /// Starts over with these discs and candidates. All discs are free. Of a disc that no other
    /// rank has nobody else has candidates; of the others nobody has spoken yet.
    pub fn start(&mut self, numbers: &[u32], reach: &[Reach], found: &[Candidate]) {
        self.numbers.clear();
        self.numbers.extend_from_slice(numbers);
        self.reach.clear();
        self.reach.extend_from_slice(reach);
        self.free.clear();
        self.free.resize(numbers.len(), true);
        self.rivals.clear();
        self.rivals.extend(reach.iter().map(|reach| reach.is_shared().then_some(UNKNOWN)));
        self.waits.clear();
        self.waits.resize(numbers.len(), false);
        self.front.clear();
        self.taken.clear();
        self.told = 0;
        self.queues.start(numbers.len());
        self.queues.enter(found.iter().map(|candidate| self.local(candidate)).collect());
    }

    /// The place of a disc; none if it is not here.
    pub fn place(&self, number: u32) -> Option<usize> {
        self.numbers.binary_search(&number).ok()
    }

    /// The places of a candidate's discs, as far as they are here. Of one that was found here all
    /// are, in the order first, second.
    pub fn places(&self, candidate: &Candidate) -> impl Iterator<Item = usize> + Clone + use<> {
        let discs = [Some(candidate.hit.first()), candidate.hit.second()];
        discs.map(|number| self.place(number?)).into_iter().flatten()
    }

    /// A candidate found here, with places in place of numbers: as `queues` has it.
    pub fn local(&self, candidate: &Candidate) -> Candidate {
        renamed(candidate, |number| self.place(number).expect("its discs are here") as u32)
    }

    /// A candidate with places in place of numbers, with its numbers again.
    pub fn named(&self, candidate: &Candidate) -> Candidate {
        renamed(candidate, |place| self.numbers[place as usize])
    }

    /// Whether `rank` has one of a candidate's discs.
    fn concerns(&self, candidate: &Candidate, rank: usize) -> bool {
        self.places(candidate).any(|place| self.reach[place].contains(rank))
    }

    /// Takes every open candidate that is certain to happen, and drops those that cannot.
    ///
    /// This is lab 7's choice ([`solution7::take_in_order`]) by somebody who does not see everything.
    /// Of each free disc look at the first candidate in its queue, the earliest of all of them first:
    ///
    /// - One of its discs is not free: it cannot happen. Drop it: in the queue of a disc that is
    ///   free, if it is the first there, [advance](Queues::advance), and look at the next of that
    ///   queue when it is its turn.
    /// - No disc of it `waits`, and it comes before the rival of each of them, if there is one:
    ///   neither a candidate from here nor one of others can come in between. It is certain: append it
    ///   to `taken`, and mark its discs as not free.
    /// - Else it stays open, and its discs wait: what comes later for them is not certain before this
    ///   one is decided. If one of its discs did not wait before, it is that disc's earliest, which
    ///   others may have to hear of: append it to `front`.
    ///
    /// `front` begins empty, and in the end nobody waits any more. Who is first in two queues comes up
    /// twice, and the second time nothing is left to do.
    ///
    /// A [`BinaryHeap`] of [`Reverse`]d indices gives the earliest: a lower index comes earlier. It
    /// would be as right to go through [all](Queues::all) candidates. But this is done in every round,
    /// and in a crowd there are millions of candidates, most of them behind one that waits, and a
    /// hundred rounds.
    ///
    /// Rivals may be out of date, which does no harm: other ranks' candidates only become fewer, so
    /// who comes before an old rival comes before what is left.
    ///
    /// Book: chapter 8, *What is certain*.
    pub fn take_certain(&mut self) {
        todo!("task 8.10: what is certain")
    }

    /// What `partner` must hear: the candidates with a disc that the partner has as well
    /// (`concerns`), first those of `taken` that nobody has been told of, from `told` on, as
    /// [`CandidateWire::taken`], then those of `front`. Open ones that are not the earliest of
    /// any disc need not be told: the earliest keeps the others waiting as well.
    ///
    /// Book: chapter 8, *News*.
    pub fn news_for(&self, partner: usize) -> Vec<CandidateWire> {
        todo!("task 8.11: what the others must hear")
    }

    /// Takes in what all partners have said.
    ///
    /// Everybody has spoken, so what was known of rivals is replaced: forget all of them. Then,
    /// for each candidate of the news and each of its discs that is here: if the candidate was
    /// taken, the disc is not free any more; if it is open, it is a rival, and the disc keeps the
    /// earliest.
    ///
    /// Book: chapter 8, *News*.
    pub fn hear(&mut self, news: &[CandidateWire]) {
        todo!("task 8.11b: news from the others")
    }
}

/// The same candidate with other names for its discs.
fn renamed(candidate: &Candidate, name: impl Fn(u32) -> u32) -> Candidate {
    let hit = match candidate.hit {
        Hit::Corner(a) => Hit::Corner(name(a)),
        Hit::WallX(a) => Hit::WallX(name(a)),
        Hit::WallY(a) => Hit::WallY(name(a)),
        Hit::Pair(a, b) => Hit::Pair(name(a), name(b)),
    };
    Candidate { time: candidate.time, hit }
}
