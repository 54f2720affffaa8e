//! Candidates, as numbers and in words, and what a rank may have found.

use std::collections::BTreeSet;

use hard_disc_ranks::{Decisions, Reach};
use oracle::Random;
use solution7::{Candidate, Hit, Lab7, order};

/// Numbers of a candidate in an answer.
pub(crate) const NUMBERS: usize = 4;

/// What these numbers are, for questions.
pub(crate) const CANDIDATE: &str = "time, kind (0 a corner, 1 an x wall, 2 a y wall, 3 a pair), first disc, second disc (-1: none)";

/// The numbers of a candidate.
pub(crate) fn value(c: &Candidate) -> [f64; NUMBERS] {
    let [kind, first] = match c.hit {
        Hit::Corner(a) => [0.0, f64::from(a)],
        Hit::WallX(a) => [1.0, f64::from(a)],
        Hit::WallY(a) => [2.0, f64::from(a)],
        Hit::Pair(a, _) => [3.0, f64::from(a)],
    };
    [c.time, kind, first, c.hit.second().map_or(-1.0, f64::from)]
}

/// The candidate of these numbers.
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

/// The candidates in their order, so that a list in any order can be compared.
pub(crate) fn sorted(mut all: Vec<Candidate>) -> Vec<Candidate> {
    all.sort_by(order);
    all
}

/// Which discs meet: `0+3`, or `3+wall`.
pub(crate) fn meeting(candidate: &Candidate) -> String {
    match candidate.hit {
        Hit::Pair(a, b) => format!("{a}+{b}"),
        Hit::Corner(a) => format!("{a}+corner"),
        Hit::WallX(a) | Hit::WallY(a) => format!("{a}+wall"),
    }
}

/// Which discs meet, and when: `0+3 at 0.5`.
pub(crate) fn words(candidate: &Candidate) -> String {
    format!("{} at {}", meeting(candidate), candidate.time)
}

/// The discs of a candidate.
pub(crate) fn discs_of(candidate: &Candidate) -> impl Iterator<Item = u32> + Clone + use<> {
    [Some(candidate.hit.first()), candidate.hit.second()].into_iter().flatten()
}

/// Discs a and b at a time.
pub(crate) fn pair(time: f64, a: u32, b: u32) -> Candidate {
    Candidate { time, hit: Hit::Pair(a, b) }
}

/// A time, one of eight: many candidates have exactly the same.
pub(crate) fn time(random: &mut Random) -> f64 {
    random.below(8) as f64 / 8.0
}

/// Candidates among these discs, no two of the same discs, many of them at exactly the same time.
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
    /// Some of so many discs.
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

    /// What the rank knows of decisions before the first.
    pub(crate) fn decisions(&self) -> Decisions {
        let mut decisions = Decisions::default();
        decisions.start::<Lab7>(&self.numbers, &self.reach, &self.candidates);
        decisions
    }

    /// The slots of a candidate's discs that the rank has.
    pub(crate) fn slots(&self, candidate: &Candidate) -> Vec<usize> {
        let slots = discs_of(candidate).map(|disc| self.numbers.binary_search(&disc).ok());
        slots.flatten().collect()
    }
}
