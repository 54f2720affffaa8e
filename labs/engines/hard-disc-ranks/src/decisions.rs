//! What a rank knows of the decisions of a step.

use hard_discs::{Candidate, Collisions, Hit};

use crate::queues::Queues;
use crate::strips::Reach;

/// What a rank knows of the decisions of a step: the discs that it has, own and ghosts, the candidates
/// that it has found, and what other ranks have told.
///
/// All lists of discs are in ascending order of numbers; a *slot* is an index into them.
/// Candidates in `queues` name discs by their slots, all others by their numbers.
// ANCHOR: decisions
#[derive(Clone, Debug, Default)]
pub struct Decisions {
    /// The numbers of the discs, ascending.
    pub numbers: Vec<u32>,
    /// Which ranks have the disc.
    pub reach: Vec<Reach>,
    /// Whether the disc has not collided yet in this step, as far as is known here.
    pub free: Vec<bool>,
    /// The disc's *rival*: its earliest candidate that another rank has found, as far as is known here.
    /// Only a candidate that comes before it may be taken here.
    pub rivals: Vec<Option<Candidate>>,
    /// The candidates found here, in a queue for each disc.
    pub queues: Queues,
    /// The candidates found here that are open, neither taken nor dropped, and the earliest open one
    /// of one of their discs or of both.
    pub front: Vec<Candidate>,
    /// The candidates found here that happen.
    pub taken: Vec<Candidate>,
    /// How many of `taken` the partners have been told of.
    pub told: usize,
    /// Whether the disc waits for an open candidate to be decided; used within
    /// [`Deciding::take_certain`](crate::Deciding::take_certain) only.
    pub waits: Vec<bool>,
}
// ANCHOR_END: decisions

/// Earlier than any candidate: the rival of a disc whose other ranks have not told theirs yet.
pub const UNKNOWN: Candidate = Candidate { time: f64::NEG_INFINITY, hit: Hit::Corner(0) };

impl Decisions {
    /// Starts over with these discs and candidates. All discs are free. A disc that other ranks have
    /// too has the rival [`UNKNOWN`]; a disc that no other rank has has none.
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
        self.told = 0;
        self.queues.start(numbers.len());
        self.queues.enter::<C>(found.iter().map(|candidate| self.local(candidate)).collect());
    }

    /// The slot of a disc; none if it is not here.
    pub fn slot(&self, number: u32) -> Option<usize> {
        self.numbers.binary_search(&number).ok()
    }

    /// The slots of a candidate's discs, as far as this rank has them: all of them if the candidate
    /// was found here, in the order first, second.
    pub fn slots(&self, candidate: &Candidate) -> impl Iterator<Item = usize> + Clone + use<> {
        let discs = [Some(candidate.hit.first()), candidate.hit.second()];
        discs.map(|number| self.slot(number?)).into_iter().flatten()
    }

    /// A candidate found here, with slots instead of numbers, as `queues` has it.
    pub fn local(&self, candidate: &Candidate) -> Candidate {
        renamed(candidate, |number| self.slot(number).expect("its discs are here") as u32)
    }

    /// The candidate of [`Self::local`], with numbers again.
    pub fn named(&self, candidate: &Candidate) -> Candidate {
        renamed(candidate, |slot| self.numbers[slot as usize])
    }

    /// Whether `rank` has one of a candidate's discs.
    pub fn concerns(&self, candidate: &Candidate, rank: usize) -> bool {
        self.slots(candidate).any(|slot| self.reach[slot].contains(rank))
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
