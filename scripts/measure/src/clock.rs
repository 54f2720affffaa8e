//! Repeated timings (takes) of the same run, and the rule that decides whether two programs differ.

use lab_kit::table::three_digits;
use serde::{Deserialize, Serialize};

/// Times, in seconds, of a run that was measured several times.
///
/// Each measurement is a *take*. There is at least one take.
#[derive(Clone, Debug, Deserialize, Serialize)]
pub struct Times {
    /// The shortest take. It is the most reliable one, because noise only adds time.
    pub min: f64,
    /// The median of the takes.
    pub median: f64,
    /// All takes, in ascending order.
    pub takes: Vec<f64>,
}

/// A quantity that is computed twice: from the shortest take, and from the median.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Serialize)]
pub struct Span {
    /// The quantity from the shortest take.
    pub min: f64,
    /// The quantity from the median.
    pub median: f64,
}

/// Times of a run divided by the times of another run.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Ratio {
    /// Ratio of the shortest takes.
    pub of_minima: f64,
    /// Ratio of the medians.
    pub of_medians: f64,
    /// Whether one run is faster: its range, from the shortest take to the median, does not overlap
    /// the range of the other run.
    pub decided: bool,
}

impl Times {
    /// Summarises takes, which are seconds in any order. Returns `None` if there are no takes.
    pub fn of(mut takes: Vec<f64>) -> Option<Self> {
        takes.sort_by(f64::total_cmp);
        let min = *takes.first()?;
        let last = takes.len() - 1;
        // For an even number of takes the median is halfway between the two in the middle.
        let median = 0.5 * (takes[last / 2] + takes[takes.len() / 2]);
        Some(Self { min, median, takes })
    }

    /// Multiplies the seconds by `scale`.
    pub fn span(&self, scale: f64) -> Span {
        Span { min: self.min * scale, median: self.median * scale }
    }

    /// Whether the times are too short for a grade.
    ///
    /// The times are too short if there is only one take, or if the shortest take is below a
    /// hundredth of a second. A grade would then mostly measure the clock and the start of threads.
    pub fn are_too_short(&self) -> bool {
        self.takes.len() < 2 || self.min < SHORTEST
    }

    /// Returns how far the median is above the shortest take, as a share of the shortest take.
    pub fn spread(&self) -> f64 {
        self.median / self.min - 1.0
    }
}

impl Span {
    /// Computes `of` twice: for the shortest takes, and for the medians.
    pub fn both(of: impl Fn(fn(&Self) -> f64) -> f64) -> Self {
        Self { min: of(|span| span.min), median: of(|span| span.median) }
    }

    /// Returns the least shortest take and the least median of some runs, or `None` if there are no
    /// runs.
    ///
    /// The two times may be from different runs.
    pub fn least(runs: impl IntoIterator<Item = Self>) -> Option<Self> {
        runs.into_iter()
            .reduce(|a, b| Self { min: a.min.min(b.min), median: a.median.min(b.median) })
    }

    /// Compares the run with another run.
    ///
    /// The true time of a run is between its shortest take and its median. If the ranges of the two
    /// runs overlap, the comparison is undecided.
    pub fn over(self, other: Self) -> Ratio {
        Ratio {
            of_minima: self.min / other.min,
            of_medians: self.median / other.median,
            decided: self.min > other.median || other.min > self.median,
        }
    }
}

/// Least length of the shortest take, in seconds, that is enough for a grade.
const SHORTEST: f64 = 0.01;

/// Message in place of a grade.
pub const TOO_SHORT: &str =
    "Too short to grade: take more particles or --steps, and two --rounds or more.";

/// Largest difference between the two grades (for shortest takes and for medians) that is not
/// noise.
const NOISE: f64 = 5.0;

/// Whether the times vary too much for this grade out of 100.
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

/// Formats a ratio with few digits: 1.24, or 1/6493 if it is far below 1.
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
        // One disturbed take out of three does not change a clear result.
        assert!(span(&[2.0, 2.1, 9.0]).over(span(&[1.0, 1.1, 5.0])).decided);
    }

    #[test]
    fn minima_and_medians_have_their_own_least() {
        // The first run has the shortest take, and the second run has the least median.
        let runs = [span(&[1.0, 4.0, 5.0]), span(&[2.0, 3.0, 6.0])];
        let least = Span::least(runs).expect("there are runs");
        assert_eq!((least.min, least.median), (1.0, 3.0));
        let ratio = least.over(span(&[0.25, 0.5, 9.0]));
        assert_eq!((ratio.of_minima, ratio.of_medians, ratio.decided), (4.0, 6.0, true));
        assert!(Span::least([]).is_none());
    }
}
