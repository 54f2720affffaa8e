//! Questions about certain candidates: what a rank takes, leaves open and drops.

use hard_disc_ranks::{Decisions, Reach, UNKNOWN};
use lab8::take_certain;
use oracle::{Ask, Random, flags};
use solution7::{Candidate, Hit, Lab7};

use super::candidates::{CANDIDATE, Found, pair, time, value};
use super::decided::{After, Known, Ordered};

/// A rank's candidates, and the news before each round of deciding.
struct Case {
    found: Found,
    rounds: Vec<Round>,
}

/// Knowledge about each disc at the beginning of a round.
struct Round {
    rivals: Vec<Option<Candidate>>,
    /// Whether another rank has reported that it took the disc.
    gone: Vec<bool>,
}

/// Asks for a rank's decisions in several rounds. Between the rounds other ranks report fewer
/// candidates, and discs that they have taken.
pub(crate) fn rounds(random: &mut Random, ask: &mut impl Ask) {
    for discs in [1, 2, 3, 9, 33, 300].into_iter().flat_map(|discs| [discs; 20]) {
        let case = Case::drawn(random, discs + 2);
        let question = format!(
            "rank 1 of three has {} discs and {} candidates, and decides in {} rounds. After each round: (1) number \
             of candidates taken, (2) number of candidates in the front, (3) {CANDIDATE} of each taken candidate and \
             of each candidate in the front, (4) for each disc 1 if it is free, 0 if not, (5) for each disc 1 if it \
             waits, 0 if not",
            case.found.numbers.len(),
            case.found.candidates.len(),
            case.rounds.len()
        );
        ask.judge(&question, || case.decide(), |found| case.is_decided(found));
    }
}

impl Case {
    fn drawn(random: &mut Random, discs: u32) -> Self {
        let found = Found::drawn(random, discs);
        let mut rivals = found.decisions().rivals;
        let mut rounds = Vec::new();
        for round in 0..4 {
            for (slot, reach) in found.reach.iter().enumerate() {
                if reach.is_shared() && random.below(3) > 0 {
                    let rival = rival(random, found.numbers[slot], discs);
                    rivals[slot] = rival.filter(|_| round < 2);
                }
            }
            let gone = found.reach.iter().map(|_| random.below(20) == 0).collect();
            rounds.push(Round { rivals: rivals.clone(), gone });
        }
        Self { found, rounds }
    }

    /// Returns the lab's decisions as numbers.
    fn decide(&self) -> Vec<f64> {
        let mut decisions = self.found.decisions();
        let mut numbers = Vec::new();
        for Round { rivals, gone } in &self.rounds {
            decisions.rivals.clone_from(rivals);
            for (free, gone) in decisions.free.iter_mut().zip(gone) {
                *free &= !gone;
            }
            take_certain(&mut decisions);
            numbers.extend(numbers_of(&decisions));
        }
        numbers
    }

    fn is_decided(&self, mut found: &[f64]) -> Result<(), String> {
        let ordered = Ordered::of(&self.found);
        let mut free = vec![true; self.found.numbers.len()];
        let mut before = Vec::new();
        for (number, round) in (1..).zip(&self.rounds) {
            for (free, gone) in free.iter_mut().zip(&round.gone) {
                *free &= !gone;
            }
            let after = After::read(&mut found, free.len()).ok_or("the answer is not complete")?;
            let known = Known { ordered: &ordered, rivals: &round.rivals, free: &free };
            known.judge(&before, &after).map_err(|words| format!("round {number}: {words}"))?;
            free = after.free;
            before = after.taken;
        }
        Ok(())
    }
}

/// Draws the report of other ranks about a disc: a different candidate of it, no candidate, or no
/// report yet.
fn rival(random: &mut Random, number: u32, discs: u32) -> Option<Candidate> {
    let other = random.below(2 * discs as usize + 2) as u32;
    let pair = Hit::Pair(other.min(number), other.max(number));
    let hit = if other == number { Hit::WallY(number) } else { pair };
    let candidate = Candidate { time: time(random), hit };
    [Some(candidate), Some(candidate), None, Some(UNKNOWN)][random.below(4)]
}

fn numbers_of(decisions: &Decisions) -> Vec<f64> {
    let Decisions { taken, front, free, waits, .. } = decisions;
    let mut numbers = vec![taken.len() as f64, front.len() as f64];
    numbers.extend(taken.iter().chain(front).flat_map(value));
    numbers.extend(flags(free.iter().chain(waits)));
    numbers
}

/// Asks about a million candidates that wait for one candidate, which stays open. A program that
/// goes through all of them in every round does not finish.
pub(crate) fn crowd_behind_one(_: &mut Random, ask: &mut impl Ask) {
    let question = format!(
        "a list with 1,000,000 copies of one candidate of two discs. The other ranks send no news in 100,000 rounds: \
         {CANDIDATE} of each candidate in the front"
    );
    let open = pair(0.5, 0, 1);
    let found = || {
        let mut decisions = Decisions::default();
        let reach = Reach { first: 0, last: 1 };
        decisions.start::<Lab7>(&[0, 1], &[reach; 2], &vec![open; 1_000_000]);
        (0..100_000).for_each(|_| take_certain(&mut decisions));
        decisions.front.iter().flat_map(value).collect()
    };
    ask.exact(&question, found, || value(&open).to_vec());
}
