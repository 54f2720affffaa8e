//! For each disc the candidates that it is in, in the order in which they are decided.

use hard_discs::{Candidate, Collisions};

/// The end of a queue.
const END: u32 = u32::MAX;

/// Candidates, in a queue for each disc: one of two discs stands in two queues.
///
/// Discs are named by their slots. A queue is a list linked through the candidates, so that a
/// queue costs eight bytes, and eight for each candidate, however they are spread. A candidate that
/// leaves its queues stays in memory until [`Self::start`].
#[derive(Clone, Debug, Default)]
pub struct Queues {
    candidates: Vec<Candidate>,
    /// For each candidate the next one in the queue of its first disc, and of its second.
    behind: Vec<[u32; 2]>,
    /// For each disc the first in its queue, and the last.
    ends: Vec<[u32; 2]>,
}

impl Queues {
    /// Starts over with empty queues of `discs` discs.
    pub fn start(&mut self, discs: usize) {
        self.candidates.clear();
        self.behind.clear();
        self.ends.clear();
        self.ends.resize(discs, [END; 2]);
    }

    /// Puts candidates at the ends of the queues, in the order of [`Collisions::order`]. None of them may come
    /// before one that has been put there already.
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

    /// The first candidate in the queue of a disc, by its index. The lower index comes first in the
    /// order of all.
    #[inline]
    pub fn first(&self, slot: usize) -> Option<u32> {
        Some(self.ends[slot][0]).filter(|first| *first != END)
    }

    /// Takes the first candidate out of the queue of a disc, and returns the one that is first now.
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

    /// The candidate of an index.
    #[inline]
    pub fn candidate(&self, index: u32) -> Candidate {
        self.candidates[index as usize]
    }

    /// All that have been entered, in their order.
    pub fn all(&self) -> &[Candidate] {
        &self.candidates
    }

    /// Which disc of a candidate is the one at `slot`: 0 the first, 1 the second.
    #[inline]
    fn side(&self, index: u32, slot: usize) -> usize {
        usize::from(self.candidates[index as usize].hit.first() as usize != slot)
    }
}

/// The slots of a candidate's discs.
#[inline]
pub fn slots_of(candidate: &Candidate) -> impl Iterator<Item = usize> + Clone + use<> {
    let discs = [Some(candidate.hit.first()), candidate.hit.second()];
    discs.into_iter().flatten().map(|slot| slot as usize)
}
