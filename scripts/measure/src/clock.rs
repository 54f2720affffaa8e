//! Takes of the same run, and the rule by which two programs can be told apart.

use lab_kit::table::three_digits;
use serde::{Deserialize, Serialize};

/// Seconds of the takes of one run: at least one take.
#[derive(Clone, Debug, Deserialize, Serialize)]
pub struct Times {
    /// The shortest take: noise only ever adds.
    pub min: f64,
    /// The median of the takes.
    pub median: f64,
    /// All takes, in ascending order.
    pub takes: Vec<f64>,
}

/// A quantity by the shortest take and by the median.
#[derive(Clone, Copy, Debug, Deserialize, Serialize)]
pub struct Span {
    /// By the shortest take.
    pub min: f64,
    /// By the median.
    pub median: f64,
}

/// Times of one run over those of another run.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Ratio {
    /// By the shortest takes.
    pub of_minima: f64,
    /// By the medians.
    pub of_medians: f64,
    /// Whether the takes of the two lie apart, so that one can be called faster.
    pub decided: bool,
}

impl Times {
    /// Sums up takes, in any order; `None` if there are none.
    pub fn of(mut takes: Vec<f64>) -> Option<Self> {
        takes.sort_by(f64::total_cmp);
        let min = *takes.first()?;
        let last = takes.len() - 1;
        // With an even number of takes, halfway between the two in the middle.
        let median = 0.5 * (takes[last / 2] + takes[takes.len() / 2]);
        Some(Self { min, median, takes })
    }

    /// Multiplies the seconds by `scale`.
    pub fn span(&self, scale: f64) -> Span {
        Span { min: self.min * scale, median: self.median * scale }
    }

    /// Whether a grade would be a grade of the clock and of the start of threads: there is only one take, or
    /// the shortest take ends before a hundredth of a second is over.
    pub fn are_too_short(&self) -> bool {
        self.takes.len() < 2 || self.min < SHORTEST
    }

    /// Returns how far the median lies above the shortest take, as a share of it.
    pub fn spread(&self) -> f64 {
        self.median / self.min - 1.0
    }
}

impl Span {
    /// Computes `of` twice: by the shortest takes, and by the medians.
    pub fn both(of: impl Fn(fn(&Self) -> f64) -> f64) -> Self {
        Self { min: of(|span| span.min), median: of(|span| span.median) }
    }

    /// Returns the least of some runs, by each statistic for itself: the run with the shortest take need not have
    /// the least median. `None` if there are no runs.
    pub fn least(runs: impl IntoIterator<Item = Self>) -> Option<Self> {
        runs.into_iter()
            .reduce(|a, b| Self { min: a.min.min(b.min), median: a.median.min(b.median) })
    }

    /// Compares with another run. The true time of a run lies between its shortest take and its median: if these two
    /// stretches overlap, nothing is decided.
    pub fn over(self, other: Self) -> Ratio {
        Ratio {
            of_minima: self.min / other.min,
            of_medians: self.median / other.median,
            decided: self.min > other.median || other.min > self.median,
        }
    }
}

/// Seconds of the shortest take that counts for a grade.
const SHORTEST: f64 = 0.01;

/// Message in place of a grade.
pub const TOO_SHORT: &str =
    "Too short to grade: take more particles or --steps, and two --rounds or more.";

/// Greatest difference between a grade by the shortest takes and the grade by the medians that is not noise.
const NOISE: f64 = 5.0;

/// Whether the times of a grade, of 100, spread too wide to decide.
pub fn is_noisy(grade: Span) -> bool {
    (grade.min - grade.median).abs() > NOISE
}

/// Returns the warning below a noisy grade; empty if the grade is not noisy.
pub fn warning(grade: Span, by_medians: f64) -> String {
    if !is_noisy(grade) {
        return String::new();
    }
    format!(
        "\nBy the medians it is {by_medians:.3}: the times spread too wide to decide.\n\
         Close other programs and measure again."
    )
}

/// Writes a ratio in few digits: 1.24, or 1/6493 where it is far below 1.
pub fn times_longer(ratio: f64) -> String {
    if ratio < 0.1 && ratio > 0.0 {
        format!("1/{}", three_digits(1.0 / ratio))
    } else {
        three_digits(ratio)
    }
}

#[cfg(test)]
mod tests {
    use super::{Span, Times, times_longer};

    fn times(takes: &[f64]) -> Times {
        Times::of(takes.to_vec()).expect("there are takes")
    }

    fn span(takes: &[f64]) -> Span {
        times(takes).span(1.0)
    }

    #[test]
    fn one_take_or_a_glance_is_too_short() {
        assert!(times(&[3.0]).are_too_short() && times(&[0.009, 2.0]).are_too_short());
        assert!(!times(&[0.02, 0.03]).are_too_short());
    }

    #[test]
    fn a_small_ratio_is_a_fraction() {
        for (ratio, text) in [(1.0 / 6493.2, "1/6493"), (0.5, "0.500"), (12.34, "12.3")] {
            assert_eq!(times_longer(ratio), text);
        }
    }

    #[test]
    fn the_median_lies_in_the_middle() {
        assert_eq!(times(&[3.0, 1.0, 2.0]).median, 2.0);
        assert_eq!(times(&[4.0, 1.0, 3.0, 2.0]).median, 2.5);
        assert_eq!(times(&[5.0]).median, 5.0);
        assert_eq!(times(&[3.0, 1.0, 2.0]).min, 1.0);
        assert_eq!(times(&[3.0, 1.0, 2.0]).spread(), 1.0);
        assert!(Times::of(Vec::new()).is_none());
    }

    #[test]
    fn overlapping_takes_decide_nothing() {
        let quick = span(&[1.0, 1.1, 1.2]);
        assert!(span(&[1.3, 1.4, 1.5]).over(quick).decided);
        assert!(quick.over(span(&[1.3, 1.4, 1.5])).decided);
        assert!(!span(&[1.05, 1.4, 1.5]).over(quick).decided);
        assert!(!quick.over(quick).decided);
        // One bad take out of three does not spoil a clear case.
        assert!(span(&[2.0, 2.1, 9.0]).over(span(&[1.0, 1.1, 5.0])).decided);
    }

    #[test]
    fn minima_and_medians_have_their_own_least() {
        // The first run has the shortest take, the second the least median.
        let runs = [span(&[1.0, 4.0, 5.0]), span(&[2.0, 3.0, 6.0])];
        let least = Span::least(runs).expect("there are runs");
        assert_eq!((least.min, least.median), (1.0, 3.0));
        let ratio = least.over(span(&[0.25, 0.5, 9.0]));
        assert_eq!((ratio.of_minima, ratio.of_medians, ratio.decided), (4.0, 6.0, true));
        assert!(Span::least([]).is_none());
    }
}
