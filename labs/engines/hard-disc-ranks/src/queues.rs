//! A queue of candidates for each disc, in the order of decisions.

use hard_discs::{Candidate, Collisions};

/// The end of a queue.
const END: u32 = u32::MAX;

/// Candidates in a queue for each disc. The candidate of a pair is in two queues.
///
/// Discs are named by their slots. A queue is a list that is linked through the candidates. So a
/// queue takes eight bytes and a candidate eight more, however the candidates are distributed. A
/// candidate that leaves its queues stays in memory until [`Self::start`].
#[derive(Clone, Debug, Default)]
pub struct Queues {
    candidates: Vec<Candidate>,
    /// For each candidate, the next candidates in the queues of its first and its second disc.
    behind: Vec<[u32; 2]>,
    /// For each disc, the first and the last candidate in its queue.
    ends: Vec<[u32; 2]>,
}

impl Queues {
    /// Starts with empty queues for `discs` discs.
    pub fn start(&mut self, discs: usize) {
        self.candidates.clear();
        self.behind.clear();
        self.ends.clear();
        self.ends.resize(discs, [END; 2]);
    }

    /// Appends candidates to the queues, in the order of [`Collisions::order`].
    ///
    /// The candidates must not come before any candidate that has been entered earlier.
    pub fn enter<C: Collisions>(&mut self, mut candidates: Vec<Candidate>) {
        candidates.sort_unstable_by(C::order);
        for candidate in candidates {
            let index =
                u32::try_from(self.candidates.len()).expect("memory ends before numbers do");
            for slot in slots_of(&candidate) {
                match self.ends[slot] {
                    [END, _] => self.ends[slot] = [index; 2],
                    [_, last] => {
                        let side = self.side(last, slot);
                        self.behind[last as usize][side] = index;
                        self.ends[slot][1] = index;
                    }
                }
            }
            self.candidates.push(candidate);
            self.behind.push([END; 2]);
        }
    }

    /// Returns the index of the first candidate in the queue of a disc, or `None` if the queue is
    /// empty.
    ///
    /// Indices are in the order of the candidates.
    #[inline]
    pub fn first(&self, slot: usize) -> Option<u32> {
        Some(self.ends[slot][0]).filter(|first| *first != END)
    }

    /// Removes the first candidate from the queue of a disc, and returns the new first candidate.
    ///
    /// # Panics
    /// The queue is empty.
    #[inline]
    pub fn advance(&mut self, slot: usize) -> Option<u32> {
        let first = self.ends[slot][0];
        let side = self.side(first, slot);
        self.ends[slot][0] = self.behind[first as usize][side];
        self.first(slot)
    }

    /// Returns the candidate at an index.
    #[inline]
    pub fn candidate(&self, index: u32) -> Candidate {
        self.candidates[index as usize]
    }

    /// Returns all candidates that have been entered, in their order.
    pub fn all(&self) -> &[Candidate] {
        &self.candidates
    }

    /// Returns 0 if the candidate's first disc is at `slot`, and 1 if the second is.
    #[inline]
    fn side(&self, index: u32, slot: usize) -> usize {
        usize::from(self.candidates[index as usize].hit.first() as usize != slot)
    }
}

/// Returns the slots of a candidate's discs.
#[inline]
pub fn slots_of(candidate: &Candidate) -> impl Iterator<Item = usize> + Clone + use<> {
    let discs = [Some(candidate.hit.first()), candidate.hit.second()];
    discs.into_iter().flatten().map(|slot| slot as usize)
}
