//! Three rankings. Two entries are tied if the rounds do not decide which one is better.

use oracle::contest::Kind;

use super::entry::Entry;
use crate::clock::Span;

/// Median error up to which an entry counts as accurate, as a multiple of the official step's
/// error. Rounding and chaos change the error a little. For the same reason smaller differences
/// between two errors are ties.
pub(super) const ACCURATE: f64 = 1.05;

/// A ranking of the entries whose error is at most the official step's error on every kind of scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Ranking {
    /// The entry with the shortest time is first.
    Fastest,
    /// The entry with the least error is first. Only entries that take at most the reference's time
    /// take part.
    MostAccurate,
    /// The entry with the fewest counted instructions is first.
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
        if unranked(entry).is_some() {
            return None;
        }
        let time = entry.time?;
        match self {
            Self::Fastest => Some(time),
            Self::MostAccurate => {
                let error = entry.error.filter(|_| time.min <= 1.0)?;
                Some(Span { min: error.min / ACCURATE, ..error })
            }
            Self::FewestInstructions => {
                let count = entry.instructions?;
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

/// Returns why an entry takes part in no ranking; `None` if it takes part.
pub fn unranked(entry: &Entry) -> Option<String> {
    let fault = entry.faults.first().cloned();
    fault.or_else(|| Some(format!("{}: the error is above {ACCURATE}", inaccurate(entry)?.name())))
}

/// Returns the first kind of scene with too great an error; `None` if the entry is accurate on all
/// kinds. One kind without forces would otherwise buy time for the other kinds.
fn inaccurate(entry: &Entry) -> Option<Kind> {
    Kind::ALL
        .into_iter()
        .find(|kind| entry.errors(*kind).is_none_or(|errors| errors.median > ACCURATE))
}

#[cfg(test)]
mod tests {
    use super::super::entry::tests::entry;
    use super::*;

    #[test]
    fn what_is_not_decided_is_a_tie() {
        let quick = entry(&[(0.5, 1.0), (0.6, 1.0), (0.7, 1.0)]);
        let rounded = entry(&[(0.55, 0.999), (0.65, 0.999), (0.75, 0.999)]);
        let exact = entry(&[(0.9, 0.1), (0.95, 0.1), (0.99, 0.1)]);
        let slow = entry(&[(2.0, 0.1), (2.1, 0.1), (2.2, 0.1)]);
        let wrong = entry(&[(0.1, 9.0)]);
        let mut lost = entry(&[(0.1, 1.0)]);
        lost.faults.push("crowd, seed 1: particle 3 is missing".into());
        let all = [&quick, &rounded, &exact, &slow, &wrong, &lost];
        let places = |ranking: Ranking| all.map(|entry| ranking.place(entry, &all));
        assert_eq!(places(Ranking::Fastest), [Some(1), Some(1), Some(3), Some(4), None, None]);
        assert_eq!(places(Ranking::MostAccurate), [Some(2), Some(2), Some(1), None, None, None]);
        assert_eq!(places(Ranking::FewestInstructions), [None; 6]);
    }
}
