//! The question about the joint decision of ranks that have their own candidates and the news of
//! the others.

use std::collections::BTreeSet;

use hard_disc_ranks::{CandidateWire, Decisions, Reach};
use lab8::{hear, news_for, take_certain};
use oracle::{Ask, Random, truth};
use solution7::{Candidate, Hit, take_in_order};

use super::candidates::{CANDIDATE, Found, NUMBERS, of_value, time, value, words};

/// Asks two to five ranks for their decision about the same candidates. Each candidate was found by
/// one rank.
pub(crate) fn together(random: &mut Random, ask: &mut impl Ask) {
    // Calls this task's function first, so that an unsolved starter stops at this task's `todo!`.
    news_for(&Decisions::default(), 0);
    for case in 0..200 {
        let ranks = 2 + case % 4;
        let all = Ranks::drawn(random, ranks, 40);
        let question = format!(
            "case {case}, {ranks} ranks that have found {} candidates of 40 discs: (1) 1 if the ranks come to an end, \
             0 if not, (2) for each candidate taken, its rank and {CANDIDATE}",
            all.found.len()
        );
        ask.judge(&question, || all.decide(), |found| all.is_decided(found));
    }
}

/// Candidates of discs that several ranks may have, each with the rank that found it.
struct Ranks {
    reach: Vec<Reach>,
    found: Vec<(usize, Candidate)>,
}

impl Ranks {
    /// Draws candidates. Each candidate is known to the rank that tests its pair, or to the owner
    /// of its disc.
    fn drawn(random: &mut Random, ranks: usize, discs: usize) -> Self {
        let mut reach = Vec::new();
        for _ in 0..discs {
            let first = random.below(ranks);
            let last = (first + [0, 0, 1, 2][random.below(4)]).min(ranks - 1);
            reach.push(Reach { first, last });
        }
        let mut hits = BTreeSet::new();
        let mut found = Vec::new();
        for _ in 0..2 * discs {
            let mut ends = [random.below(discs), random.below(discs)];
            ends.sort_unstable();
            let [a, b] = ends;
            let owner = reach[a].first.max(reach[b].first);
            let hit = if a == b { Hit::WallX(a as u32) } else { Hit::Pair(a as u32, b as u32) };
            if owner <= reach[a].last.min(reach[b].last) && hits.insert(hit) {
                found.push((owner, Candidate { time: time(random), hit }));
            }
        }
        Self { reach, found }
    }

    /// Runs rounds until no rank has open candidates or news.
    fn decide(&self) -> Vec<f64> {
        let ranks = 1 + self.reach.iter().map(|reach| reach.last).max().unwrap_or(0);
        let mut all: Vec<Decisions> = (0..ranks).map(|rank| self.decisions(rank)).collect();
        let mut has_ended = false;
        for _ in 0..100 {
            all.iter_mut().for_each(take_certain);
            has_ended = all.iter().all(|d| d.front.is_empty() && d.reported == d.taken.len());
            if has_ended {
                break;
            }
            let news: Vec<Vec<CandidateWire>> = (0..ranks).map(|to| news_to(&all, to)).collect();
            for (decisions, news) in all.iter_mut().zip(&news) {
                decisions.reported = decisions.taken.len();
                hear(decisions, news);
            }
        }
        let mut numbers = vec![truth(has_ended)];
        for (rank, decisions) in all.iter().enumerate() {
            numbers.extend(
                decisions.taken.iter().flat_map(|c| [&[rank as f64], &value(c)[..]].concat()),
            );
        }
        numbers
    }

    fn decisions(&self, rank: usize) -> Decisions {
        let here: Vec<usize> =
            (0..self.reach.len()).filter(|&disc| self.reach[disc].contains(rank)).collect();
        let own = self.found.iter().filter(|(finder, _)| *finder == rank);
        let found = Found {
            numbers: here.iter().map(|&disc| disc as u32).collect(),
            reach: here.iter().map(|&disc| self.reach[disc]).collect(),
            candidates: own.map(|(_, candidate)| *candidate).collect(),
        };
        found.decisions()
    }

    /// Checks that the outcomes of the candidates are the same as in lab 7.
    fn is_decided(&self, found: &[f64]) -> Result<(), String> {
        if found.first() != Some(&1.0) {
            return Err("some candidate is still open after 100 rounds".into());
        }
        let mut all: Vec<Candidate> = self.found.iter().map(|(_, candidate)| *candidate).collect();
        let mut right = Vec::new();
        take_in_order(&mut all, &mut vec![true; self.reach.len()], &mut right);
        let mut seen = Vec::new();
        for taken in found[1..].chunks(1 + NUMBERS).filter(|taken| taken.len() > NUMBERS) {
            let candidate = of_value(&taken[1..]);
            let name = words(&candidate);
            if seen.contains(&candidate) {
                return Err(format!("rank {} takes {name}, which is already taken", taken[0]));
            }
            if !right.contains(&candidate) {
                return Err(format!(
                    "rank {} takes {name}, although a disc of this candidate belongs to an earlier candidate that is \
                     taken",
                    taken[0]
                ));
            }
            seen.push(candidate);
        }
        match right.iter().find(|candidate| !seen.contains(candidate)) {
            Some(missing) => {
                Err(format!("no rank has taken {}, which must be taken", words(missing)))
            }
            None => Ok(()),
        }
    }
}

/// Returns the news that the other ranks send to a rank.
fn news_to(all: &[Decisions], to: usize) -> Vec<CandidateWire> {
    let others = (0..all.len()).filter(|from| *from != to);
    others.flat_map(|from| news_for(&all[from], to)).collect()
}
