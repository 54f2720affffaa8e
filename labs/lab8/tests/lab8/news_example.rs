//! The worked example of news: three ranks decide about a tower of discs.

use std::slice;

use hard_disc_ranks::{CandidateWire, Decisions, Reach};
use lab8::{hear, news_for, take_certain};
use oracle::{Ask, Columns, Random, spaced};
use solution7::{Candidate, Lab7};

use super::candidates::{meeting, pair, sorted, words};

/// Shows the news for a tower of eight discs on three ranks. Discs 2 and 5 are at the cuts, and
/// known on both sides.
pub(crate) fn table_of_news(_: &mut Random, ask: &mut impl Ask) {
    // Calls this task's function first, so that an unsolved starter stops at this task's `todo!`.
    news_for(&Decisions::default(), 0);
    ask.example(|| {
        let found = [
            vec![pair(0.25, 0, 1), pair(0.75, 1, 2)],
            vec![pair(0.5, 2, 3), pair(0.375, 3, 4), pair(0.25, 4, 5)],
            vec![pair(0.125, 5, 6), pair(0.5, 6, 7)],
        ];
        let mut all: Vec<Decisions> = (0..3).map(|rank| of_tower(rank, &found[rank])).collect();
        let mut table = Columns::new((0..3).map(|rank| format!("rank {rank}")));
        table.row(
            "finds",
            found.map(|found| found.iter().map(words).collect::<Vec<_>>().join(", ")),
        );
        for round in 1..=3 {
            all.iter_mut().for_each(take_certain);
            let taken = |d: &Decisions| meetings(&d.taken[d.reported..]);
            table.row(format!("round {round}: takes"), all.iter().map(taken));
            table.row("  leaves open", all.iter().map(|d| meetings(&d.front)));
            tell(&mut all, &mut table);
        }
        table.to_string()
    });
}

/// Returns a rank's knowledge before the first round.
fn of_tower(rank: usize, found: &[Candidate]) -> Decisions {
    let reach = [(0, 0), (0, 0), (0, 1), (1, 1), (1, 1), (1, 2), (2, 2), (2, 2)];
    let reach = reach.map(|(first, last)| Reach { first, last });
    let here: Vec<u32> = (0..8).filter(|&disc| reach[disc as usize].contains(rank)).collect();
    let reach: Vec<Reach> = here.iter().map(|&disc| reach[disc as usize]).collect();
    let mut decisions = Decisions::default();
    decisions.start::<Lab7>(&here, &reach, found);
    decisions
}

/// Passes the news between all ranks, and adds them to the table row by row.
fn tell(all: &mut [Decisions], table: &mut Columns) {
    let mut mail: Vec<Vec<CandidateWire>> = Vec::new();
    for partner in 0..all.len() {
        let sent: Vec<Vec<CandidateWire>> = (0..all.len())
            .map(|rank| if rank == partner { Vec::new() } else { news_for(&all[rank], partner) })
            .collect();
        table.row(format!("  tells rank {partner}"), sent.iter().map(|news| reports(news)));
        mail.push(sent.concat());
    }
    for (decisions, mail) in all.iter_mut().zip(&mail) {
        decisions.reported = decisions.taken.len();
        hear(decisions, mail);
    }
}

fn reports(news: &[CandidateWire]) -> String {
    let reports = news.iter().map(|wire| {
        let end = if wire.is_taken() { "taken" } else { "open" };
        format!("{} {end}", meetings(slice::from_ref(&Candidate::from(wire))))
    });
    reports.collect::<Vec<_>>().join(", ")
}

/// Names the discs of each candidate.
fn meetings(candidates: &[Candidate]) -> String {
    spaced(sorted(candidates.to_vec()).iter().map(meeting))
}
