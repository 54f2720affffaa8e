//! Candidates, as numbers and in words, and random results of a rank's search.

use std::collections::BTreeSet;

use hard_disc_ranks::{Decisions, Reach};
use oracle::Random;
use solution7::{Candidate, Hit, Lab7, order};

/// Count of numbers per candidate in an answer.
pub(crate) const NUMBERS: usize = 4;

/// Description of these numbers for questions.
pub(crate) const CANDIDATE: &str = "time, kind (0 a corner, 1 an x wall, 2 a y wall, 3 a pair), first disc, second disc (-1: none)";

/// Returns the numbers of a candidate.
pub(crate) fn value(c: &Candidate) -> [f64; NUMBERS] {
    let [kind, first] = match c.hit {
        Hit::Corner(a) => [0.0, f64::from(a)],
        Hit::WallX(a) => [1.0, f64::from(a)],
        Hit::WallY(a) => [2.0, f64::from(a)],
        Hit::Pair(a, _) => [3.0, f64::from(a)],
    };
    [c.time, kind, first, c.hit.second().map_or(-1.0, f64::from)]
}

/// Returns the candidate with these numbers.
pub(crate) fn of_value(numbers: &[f64]) -> Candidate {
    let [first, second] = [numbers[2] as u32, numbers[3] as u32];
    let hit = match numbers[1] as usize {
        0 => Hit::Corner(first),
        1 => Hit::WallX(first),
        2 => Hit::WallY(first),
        _ => Hit::Pair(first, second),
    };
    Candidate { time: numbers[0], hit }
}

/// Sorts the candidates, so that lists in any order can be compared.
pub(crate) fn sorted(mut all: Vec<Candidate>) -> Vec<Candidate> {
    all.sort_by(order);
    all
}

/// Names the discs of a candidate: `0+3`, or `3+wall`.
pub(crate) fn meeting(candidate: &Candidate) -> String {
    match candidate.hit {
        Hit::Pair(a, b) => format!("{a}+{b}"),
        Hit::Corner(a) => format!("{a}+corner"),
        Hit::WallX(a) | Hit::WallY(a) => format!("{a}+wall"),
    }
}

/// Names the discs of a candidate and its time: `0+3 at 0.5`.
pub(crate) fn words(candidate: &Candidate) -> String {
    format!("{} at {}", meeting(candidate), candidate.time)
}

/// Returns the discs of a candidate.
pub(crate) fn discs_of(candidate: &Candidate) -> impl Iterator<Item = u32> + Clone + use<> {
    [Some(candidate.hit.first()), candidate.hit.second()].into_iter().flatten()
}

/// Returns the candidate of discs a and b at a time.
pub(crate) fn pair(time: f64, a: u32, b: u32) -> Candidate {
    Candidate { time, hit: Hit::Pair(a, b) }
}

/// Draws one of eight times, so that many candidates have exactly the same time.
pub(crate) fn time(random: &mut Random) -> f64 {
    random.below(8) as f64 / 8.0
}

/// Draws candidates among these discs, each for different discs, many of them at exactly the same
/// time.
pub(crate) fn among(random: &mut Random, numbers: &[u32]) -> Vec<Candidate> {
    let mut hits = BTreeSet::new();
    for _ in 0..(3 * numbers.len()) / 2 {
        let a = numbers[random.below(numbers.len())];
        let b = numbers[random.below(numbers.len())];
        hits.insert(if a == b { Hit::WallX(a) } else { Hit::Pair(a.min(b), a.max(b)) });
    }
    let mut all: Vec<Candidate> =
        hits.into_iter().map(|hit| Candidate { time: time(random), hit }).collect();
    random.shuffle(&mut all);
    all
}

/// The discs that rank 1 of three has, and the candidates that it has found.
pub(crate) struct Found {
    pub(crate) numbers: Vec<u32>,
    pub(crate) reach: Vec<Reach>,
    pub(crate) candidates: Vec<Candidate>,
}

impl Found {
    /// Draws some of `discs` discs.
    pub(crate) fn drawn(random: &mut Random, discs: u32) -> Self {
        let mut found = Self { numbers: Vec::new(), reach: Vec::new(), candidates: Vec::new() };
        for number in 0..discs {
            if random.below(4) > 0 {
                found.numbers.push(2 * number + random.below(2) as u32);
                let (first, last) = [(1, 1), (0, 1), (1, 2), (0, 2), (1, 1)][random.below(5)];
                found.reach.push(Reach { first, last });
            }
        }
        found.candidates = among(random, &found.numbers);
        found
    }

    /// Returns the rank's state before the first decision.
    pub(crate) fn decisions(&self) -> Decisions {
        let mut decisions = Decisions::default();
        decisions.start::<Lab7>(&self.numbers, &self.reach, &self.candidates);
        decisions
    }

    /// Returns the slots of those of a candidate's discs that the rank has.
    pub(crate) fn slots(&self, candidate: &Candidate) -> Vec<usize> {
        let slots = discs_of(candidate).map(|disc| self.numbers.binary_search(&disc).ok());
        slots.flatten().collect()
    }
}
