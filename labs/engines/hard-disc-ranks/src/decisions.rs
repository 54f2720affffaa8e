//! A rank's knowledge of the decisions of a step.

use hard_discs::{Candidate, Collisions, Hit};

use crate::queues::Queues;
use crate::strips::Reach;

/// A rank's knowledge of the decisions of a step.
///
/// The rank knows its own discs and ghosts, the candidates that it has found, and the news of other
/// ranks. All lists of discs are in ascending order of numbers; a *slot* is an index into them.
/// Candidates in `queues` name discs by their slots, and all other candidates name them by their
/// numbers.
// ANCHOR: decisions
#[derive(Clone, Debug, Default)]
pub struct Decisions {
    /// The numbers of the discs, ascending.
    pub numbers: Vec<u32>,
    /// The ranks that have each disc.
    pub reach: Vec<Reach>,
    /// Whether each disc has not collided yet in this step, as far as this rank knows.
    pub free: Vec<bool>,
    /// Each disc's *rival*: its earliest candidate that another rank has found, as far as this rank
    /// knows.
    ///
    /// This rank may take only candidates that come before the rivals.
    pub rivals: Vec<Option<Candidate>>,
    /// The candidates that this rank has found, in a queue for each disc.
    pub queues: Queues,
    /// The open candidates of this rank that are the earliest for one or both of their discs.
    ///
    /// A candidate is open if it is neither taken nor dropped.
    pub front: Vec<Candidate>,
    /// The candidates that this rank has found and that really happen.
    pub taken: Vec<Candidate>,
    /// Number of `taken` candidates that have been sent to the partners.
    pub reported: usize,
    /// Whether each disc waits for the decision about an open candidate.
    ///
    /// Only [`Deciding::take_certain`](crate::Deciding::take_certain) uses it.
    pub waits: Vec<bool>,
}
// ANCHOR_END: decisions

/// A candidate earlier than any other: the rival of a disc until the other ranks that have this
/// disc send their candidates.
pub const UNKNOWN: Candidate = Candidate { time: f64::NEG_INFINITY, hit: Hit::Corner(0) };

impl Decisions {
    /// Starts with these discs and candidates. All discs are free.
    ///
    /// A disc that other ranks have too gets the rival [`UNKNOWN`]; a disc that only this rank has
    /// gets no rival.
    pub fn start<C: Collisions>(&mut self, numbers: &[u32], reach: &[Reach], found: &[Candidate]) {
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
        self.reported = 0;
        self.queues.start(numbers.len());
        self.queues.enter::<C>(found.iter().map(|candidate| self.local(candidate)).collect());
    }

    /// Returns the slot of a disc, or `None` if this rank does not have the disc.
    pub fn slot(&self, number: u32) -> Option<usize> {
        self.numbers.binary_search(&number).ok()
    }

    /// Returns the slots of a candidate's discs that this rank has, in the order first, second.
    ///
    /// A rank that has found a candidate has all its discs.
    pub fn slots(&self, candidate: &Candidate) -> impl Iterator<Item = usize> + Clone + use<> {
        let discs = [Some(candidate.hit.first()), candidate.hit.second()];
        discs.map(|number| self.slot(number?)).into_iter().flatten()
    }

    /// Returns a candidate in the form of `queues`: its discs are slots, not numbers. This rank
    /// must have found the candidate.
    pub fn local(&self, candidate: &Candidate) -> Candidate {
        renamed(candidate, |number| self.slot(number).expect("its discs are here") as u32)
    }

    /// Returns a candidate with numbers instead of slots, the inverse of [`Self::local`].
    pub fn named(&self, candidate: &Candidate) -> Candidate {
        renamed(candidate, |slot| self.numbers[slot as usize])
    }

    /// Whether `rank` has one of a candidate's discs.
    pub fn concerns(&self, candidate: &Candidate, rank: usize) -> bool {
        self.slots(candidate).any(|slot| self.reach[slot].contains(rank))
    }
}

/// Returns the candidate with different names for its discs.
fn renamed(candidate: &Candidate, name: impl Fn(u32) -> u32) -> Candidate {
    let hit = match candidate.hit {
        Hit::Corner(a) => Hit::Corner(name(a)),
        Hit::WallX(a) => Hit::WallX(name(a)),
        Hit::WallY(a) => Hit::WallY(name(a)),
        Hit::Pair(a, b) => Hit::Pair(name(a), name(b)),
    };
    Candidate { time: candidate.time, hit }
}
