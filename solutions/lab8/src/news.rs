//! Task 8.11: what ranks tell each other of their decisions.

use hard_disc_ranks::{CandidateWire, Decisions};
use solution7::{Candidate, order};

/// What `partner` must hear: candidates with a disc that the partner has too
/// ([`Decisions::concerns`]). First the ones in `decisions.taken` that have not been told, from `told` on, as
/// [`CandidateWire::taken`]; then the ones in `front`. Other open candidates need not be told: the
/// earliest of a disc keeps all its later ones waiting.
///
/// Book: chapter 8, *News*.
pub fn news_for(decisions: &Decisions, partner: usize) -> Vec<CandidateWire> {
    // task 8.11: what a partner must hear
    let concerning = |candidate: &&Candidate| decisions.concerns(candidate, partner);
    let taken =
        decisions.taken[decisions.told..].iter().filter(concerning).map(CandidateWire::taken);
    let open = decisions.front.iter().filter(concerning).map(CandidateWire::from);
    taken.chain(open).collect()
    // end 8.11
}

/// Takes in the news of all partners.
///
/// Every partner has told its rivals again, so forget the old ones. Then, for each candidate
/// of the news and each of its discs that is here: if the candidate was taken, the disc is not free
/// any more; if it is open, it is a rival, and the disc keeps the earliest.
///
/// Book: chapter 8, *News*.
pub fn hear(decisions: &mut Decisions, news: &[CandidateWire]) {
    // task 8.11b: news from the partners
    decisions.rivals.fill(None);
    for wire in news {
        let candidate = Candidate::from(wire);
        for slot in decisions.slots(&candidate) {
            if wire.is_taken() {
                decisions.free[slot] = false;
            } else if decisions.rivals[slot].is_none_or(|old| order(&candidate, &old).is_lt()) {
                decisions.rivals[slot] = Some(candidate);
            }
        }
    }
    // end 8.11b
}
