//! Three rankings. Two entries are tied if the rounds do not decide which one is better.

use super::entry::Entry;
use crate::clock::Span;

/// Median error up to which an entry counts as accurate, as a multiple of the official step's
/// error. Rounding and chaos change the error a little.
pub(super) const ACCURATE: f64 = 1.05;

/// A ranking.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Ranking {
    /// By time, among the entries whose error is at most the official step's error.
    Fastest,
    /// By error, among the entries whose time is at most the reference's time.
    MostAccurate,
    /// By counted instructions, among the entries whose error is at most the official step's error.
    FewestInstructions,
}

impl Ranking {
    pub(super) const ALL: [Self; 3] = [Self::Fastest, Self::MostAccurate, Self::FewestInstructions];

    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Fastest => "fastest",
            Self::MostAccurate => "most accurate",
            Self::FewestInstructions => "fewest instr.",
        }
    }

    /// Returns the quantity that the ranking compares; `None` if the entry is not ranked.
    fn of(self, entry: &Entry) -> Option<Span> {
        if !entry.faults.is_empty() {
            return None;
        }
        let time = entry.time?;
        let is_accurate = || {
            let mut all = oracle::contest::Kind::ALL.into_iter();
            all.all(|kind| entry.errors(kind).is_some_and(|errors| errors.median <= ACCURATE))
        };
        match self {
            Self::Fastest => is_accurate().then_some(time),
            Self::MostAccurate => {
                if time.min <= 1.0 {
                    entry.error
                } else {
                    None
                }
            }
            Self::FewestInstructions => {
                let count = entry.instructions.filter(|_| is_accurate())?;
                // Counts of two runs differ by at most a thousandth.
                Some(Span { min: 0.999 * count, median: 1.001 * count })
            }
        }
    }

    /// Returns the place of an entry among all: one more than the number of entries that are
    /// certainly better. `None` if it is not ranked.
    pub(super) fn place(self, entry: &Entry, all: &[&Entry]) -> Option<usize> {
        self.of(entry)?;
        Some(all.iter().filter(|other| self.is_better(other, entry)).count() + 1)
    }

    /// Whether an entry is certainly better than another entry. Both must be ranked.
    pub(super) fn is_better(self, entry: &Entry, other: &Entry) -> bool {
        self.of(entry).zip(self.of(other)).is_some_and(|(own, other)| own.median < other.min)
    }
}

#[cfg(test)]
mod tests {
    use super::super::entry::tests::entry;
    use super::*;

    #[test]
    fn what_is_not_decided_is_a_tie() {
        let quick = entry(&[(0.5, 1.0), (0.6, 1.0), (0.7, 1.0)]);
        let alike = entry(&[(0.55, 1.0), (0.65, 1.0), (0.75, 1.0)]);
        let slow = entry(&[(2.0, 0.1), (2.1, 0.1), (2.2, 0.1)]);
        let wrong = entry(&[(0.1, 9.0)]);
        let mut lost = entry(&[(0.1, 1.0)]);
        lost.faults.push("crowd, seed 1: particle 3 is missing".into());
        let all = [&quick, &alike, &slow, &wrong, &lost];
        let places = |ranking: Ranking| all.map(|entry| ranking.place(entry, &all));
        assert_eq!(places(Ranking::Fastest), [Some(1), Some(1), Some(3), None, None]);
        assert_eq!(places(Ranking::MostAccurate), [Some(1), Some(1), None, Some(3), None]);
        assert_eq!(places(Ranking::FewestInstructions), [None; 5]);
    }
}
