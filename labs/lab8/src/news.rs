//! Task 8.11: the decisions that ranks tell each other.

use hard_disc_ranks::{CandidateWire, Decisions};
use solution7::{Candidate, order};

/// Returns the news for `partner`: candidates with a disc that the partner also has.
///
/// [`Decisions::concerns`] tests whether the partner has a disc of a candidate. The news contains,
/// in this order:
///
/// 1. The candidates of `decisions.taken` that have not been reported yet, from index `reported` on, as
///    [`CandidateWire::taken`].
/// 2. The candidates in `front`. The partner need not know the other open candidates: the earliest
///    candidate of a disc keeps all its later candidates waiting.
///
/// Book: chapter 8, *News*.
pub fn news_for(decisions: &Decisions, partner: usize) -> Vec<CandidateWire> {
    todo!("task 8.11: what a partner must hear")
}

/// Takes in the news of all partners.
///
/// First forget the old rivals, because every partner has sent its open candidates again. Then look
/// at each candidate of the news, and at each of its discs that this rank has. If the candidate was
/// taken, the disc is not free any more. If the candidate is open, it is a rival of the disc. A
/// disc keeps its earliest rival.
///
/// Book: chapter 8, *News*.
pub fn hear(decisions: &mut Decisions, news: &[CandidateWire]) {
    todo!("task 8.11b: news from the partners")
}
