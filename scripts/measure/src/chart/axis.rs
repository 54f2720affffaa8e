//! Axes: the positions of values, and the values with a label.

use std::ops::Range;

use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter};

/// One axis of a chart.
#[derive(Clone, Debug)]
pub struct Axis {
    pub(super) label: String,
    scale: Scale,
    ticks: Option<Vec<f64>>,
    from: Option<f64>,
}

/// Rule that maps a value to its position.
#[derive(Clone, Debug, PartialEq)]
enum Scale {
    Linear,
    Logarithmic,
    /// Value k has name k. The first name is at the upper end.
    Names(Vec<String>),
}

/// An axis that is fitted to its values. A position is a value, or its logarithm.
pub(super) struct Fitted {
    scale: Scale,
    positions: (f64, f64),
    /// Positions with a label and a line across the chart.
    ticks: Vec<f64>,
    /// Positions with a faint line and no label.
    between: Vec<f64>,
}

impl Axis {
    /// Makes an axis with equal steps for equal differences.
    pub fn linear(label: impl Into<String>) -> Self {
        Self { label: label.into(), scale: Scale::Linear, ticks: None, from: None }
    }

    /// Makes an axis with equal steps for equal ratios.
    pub fn log(label: impl Into<String>) -> Self {
        Self { scale: Scale::Logarithmic, ..Self::linear(label) }
    }

    /// Makes an axis with a name for each of the values 0, 1, 2, …, from the upper end down.
    pub fn names(names: Vec<String>) -> Self {
        let ticks = (0..names.len()).map(|at| at as f64).collect();
        Self { scale: Scale::Names(names), ticks: Some(ticks), ..Self::linear("") }
    }

    /// Returns the names on the axis; empty if it has numbers.
    pub(super) fn named(&self) -> &[String] {
        if let Scale::Names(names) = &self.scale { names } else { &[] }
    }

    /// Labels exactly these values, such as the numbers of threads that were measured.
    #[must_use]
    pub fn with_ticks(mut self, ticks: impl IntoIterator<Item = f64>) -> Self {
        let mut ticks: Vec<f64> = ticks.into_iter().collect();
        ticks.sort_by(f64::total_cmp);
        ticks.dedup();
        self.ticks = Some(ticks);
        self
    }

    /// Starts a linear axis at this value if all data are greater. For example, efficiencies start
    /// at 0.
    #[must_use]
    pub fn starting_at(mut self, value: f64) -> Self {
        self.from = Some(value);
        self
    }

    /// Whether the axis can show this value.
    pub(super) fn shows(&self, value: f64) -> bool {
        self.scale.position(value).is_finite()
    }

    /// Fits the axis to values that it can show, with about `most` labels if no labels were chosen.
    pub(super) fn fit(&self, values: impl IntoIterator<Item = f64>, most: usize) -> Fitted {
        let given = self.ticks.iter().flatten().filter(|tick| self.shows(**tick));
        let given: Vec<f64> = given.map(|tick| self.scale.position(*tick)).collect();
        let values = values.into_iter().map(|value| self.scale.position(value));
        let shown: Vec<f64> = values.chain(given.iter().copied()).collect();
        let least = shown.iter().copied().reduce(f64::min).unwrap_or(0.0);
        let high = shown.iter().copied().reduce(f64::max).unwrap_or(1.0);
        let start = self.from.filter(|from| self.scale == Scale::Linear && *from <= least);
        let low = start.unwrap_or(least);
        let margin = match self.scale {
            Scale::Names(_) => 0.7,
            _ if high > low => 0.04 * (high - low),
            _ => 0.5,
        };
        let positions = (if start.is_some() { low } else { low - margin }, high + margin);

        let (ticks, between) = match &self.ticks {
            Some(_) => (given, Vec::new()),
            None if self.scale == Scale::Logarithmic => decades(positions, most),
            None => (round_steps(positions, most), Vec::new()),
        };
        Fitted { scale: self.scale.clone(), positions, ticks, between }
    }
}

impl Scale {
    fn position(&self, value: f64) -> f64 {
        match self {
            Self::Linear => value,
            Self::Logarithmic => value.log10(),
            Self::Names(_) => -value,
        }
    }

    fn value(&self, position: f64) -> f64 {
        match self {
            Self::Linear => position,
            Self::Logarithmic => 10f64.powf(position),
            Self::Names(_) => -position,
        }
    }
}

impl Ranged for Fitted {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, (first, last): (i32, i32)) -> i32 {
        let (low, high) = self.positions;
        let share = (self.scale.position(*value) - low) / (high - low);
        first + (share * f64::from(last - first)).round() as i32
    }

    fn key_points<Hint: KeyPointHint>(&self, hint: Hint) -> Vec<f64> {
        let positions =
            if hint.weight().allow_light_points() { &self.between } else { &self.ticks };
        positions.iter().map(|&position| self.scale.value(position)).collect()
    }

    fn range(&self) -> Range<f64> {
        self.scale.value(self.positions.0)..self.scale.value(self.positions.1)
    }
}

impl ValueFormatter<f64> for Fitted {
    fn format_ext(&self, value: &f64) -> String {
        match &self.scale {
            Scale::Names(names) => names.get(value.round() as usize).cloned().unwrap_or_default(),
            _ => number(*value),
        }
    }
}

/// Returns the positions of labels on a logarithmic axis, and of the faint lines between them.
///
/// Labels are powers of ten. If there are fewer than three powers, their multiples by 2 and by 5
/// have labels too. If there are more than `most` powers, only some of them have labels.
fn decades(positions: (f64, f64), most: usize) -> (Vec<f64>, Vec<f64>) {
    let ticks = multiples(&[1], positions);
    let between = multiples(&[2, 3, 4, 5, 6, 7, 8, 9], positions);
    match ticks.len() {
        0..3 => (multiples(&[1, 2, 5], positions), between),
        3..6 => (ticks, between),
        powers => {
            let labelled = ticks.iter().copied().step_by(powers.div_ceil(most)).collect();
            (labelled, ticks)
        }
    }
}

/// Returns the positions of these multiples of powers of ten, from `low` to `high`.
fn multiples(of: &[u8], (low, high): (f64, f64)) -> Vec<f64> {
    let mut positions = Vec::new();
    for exponent in low.floor() as i32..=high.ceil() as i32 {
        positions.extend(of.iter().map(|&m| f64::from(m).log10() + f64::from(exponent)));
    }
    positions.retain(|position| (low..=high).contains(position));
    positions
}

/// Returns at most `most` + 1 multiples of one step, which is 1, 2 or 5 times a power of ten.
fn round_steps((low, high): (f64, f64), most: usize) -> Vec<f64> {
    let rough = (high - low) / most as f64;
    let power = 10f64.powf(rough.log10().floor());
    let step = [1.0, 2.0, 5.0, 10.0].map(|m| m * power).into_iter().find(|s| *s >= rough);
    let step = step.unwrap_or(rough);
    let first = (low / step).ceil() as i64;
    let last = (high / step).floor() as i64;
    (first..=last).map(|k| k as f64 * step).collect()
}

/// Formats a number as a label: plainly if it is short, otherwise as a power of ten.
pub fn number(value: f64) -> String {
    let rounded = format!("{value:.3e}").parse().unwrap_or(value);
    let size = f64::abs(rounded);
    if size == 0.0 || (1e-3..1e5).contains(&size) {
        return rounded.to_string();
    }
    let text = format!("{rounded:e}");
    let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    let exponent: String = exponent.chars().map(superscript).collect();
    if mantissa == "1" { format!("10{exponent}") } else { format!("{mantissa}·10{exponent}") }
}

fn superscript(digit: char) -> char {
    match digit {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        _ => digit.to_digit(10).and_then(|d| char::from_u32('⁰' as u32 + d)).unwrap_or(digit),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_are_short() {
        for (value, label) in [
            (0.0, "0"),
            (0.2 + 0.1, "0.3"),
            (64_000.0, "64000"),
            (1e6, "10⁶"),
            (2e-5, "2·10⁻⁵"),
            (10f64.powf(3.0), "1000"),
        ] {
            assert_eq!(number(value), label);
        }
    }

    #[test]
    fn an_axis_has_enough_ticks_and_not_too_many() {
        for high in [1.0, 1.3, 2.0, 7.0, 16.0, 99.0, 12_345.0] {
            let ticks = Axis::linear("").fit([0.0, high], 8).ticks.len();
            assert!((3..=9).contains(&ticks), "{ticks} ticks up to {high}");
        }
        for high in [0.3, 1.0, 2.0, 5.0, 9.0] {
            let ticks = Axis::log("").fit([0.1, high], 8).ticks.len();
            assert!((2..=10).contains(&ticks), "{ticks} ticks over {high} decades");
        }
    }
}
