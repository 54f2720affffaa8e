//! Sizes of a chart and of its parts, for a medium.

use super::figure::{Chart, Form};
use lab_kit::terminal::fold;

const BAR_ROW: u32 = 22;
/// The width of a character, as a multiple of the text size.
const CHARACTER: f64 = 0.45;

/// Layout of a row of charts: the number of charts side by side, the height of each plot, and the
/// height of the legend below them, which is 0 without a legend.
#[derive(Clone, Copy)]
pub(super) struct Layout {
    form: Form,
    pub(super) across: usize,
    pub(super) width: u32,
    pub(super) plot: u32,
    pub(super) legend: u32,
}

/// Text sizes. A size is 1.24 times the height of the text in pixels. No text is displayed less
/// than 12 pixels high. A page scales a figure by 0.91.
pub(super) struct Sizes {
    pub(super) title: u32,
    pub(super) label: u32,
    pub(super) tick: u32,
    pub(super) entry: u32,
}

impl Form {
    pub(super) fn width(self) -> u32 {
        match self {
            Self::Page => 820,
            Self::Phone => 350,
        }
    }

    /// Returns the height of a plot in a row of `charts` charts.
    fn plot(self, charts: usize) -> u32 {
        match self {
            Self::Page if charts == 1 => 460,
            Self::Page => 300,
            Self::Phone if charts == 1 => 300,
            Self::Phone => 260,
        }
    }
}

impl Layout {
    pub(super) fn of(row: &[Chart], form: Form) -> Self {
        let across = if form == Form::Phone { 1 } else { row.len().max(1) };
        let width = form.width() / across as u32;
        let plot = match row {
            [chart] if !chart.y.named().is_empty() => 110 + chart.y.named().len() as u32 * BAR_ROW,
            _ => form.plot(row.len()),
        };
        let mut layout = Self { form, across, width, plot, legend: 0 };
        if let Some(chart) = row.first()
            && (row.len() > 1 || !layout.names_lines(chart))
        {
            let rows = chart.named().count().div_ceil(layout.columns()) as u32;
            layout.legend = rows * layout.entry_row() + 12;
        }
        layout
    }

    /// Returns the height of a row of this number of charts.
    pub(super) fn height(self, charts: usize) -> u32 {
        self.plot * charts.div_ceil(self.across) as u32 + self.legend
    }

    pub(super) fn is_narrow(self) -> bool {
        self.width < Form::Page.width()
    }

    /// Whether names are at the ends of the lines, which requires enough width.
    pub(super) fn names_lines(self, chart: &Chart) -> bool {
        chart.direct && self.form == Form::Page
    }

    pub(super) fn sizes(self) -> Sizes {
        let [title, label, tick, entry] = match self.form {
            Form::Phone => [18, 16, 15, 16],
            Form::Page if self.is_narrow() => [18, 17, 17, 18],
            Form::Page => [22, 19, 17, 18],
        };
        Sizes { title, label, tick, entry }
    }

    /// Returns the greatest number of labels on the x axis and on the y axis, if the axis chooses
    /// its labels.
    pub(super) fn ticks(self) -> (usize, usize) {
        if self.is_narrow() { (5, 7) } else { (8, 8) }
    }

    /// Returns the number of columns of the legend.
    pub(super) fn columns(self) -> usize {
        if self.form == Form::Phone { 1 } else { 2 }
    }

    pub(super) fn entry_row(self) -> u32 {
        if self.form == Form::Phone { 21 } else { 24 }
    }

    /// Returns the width for names beside an axis.
    pub(super) fn beside_axis(self, chart: &Chart) -> u32 {
        let longest = chart.y.named().iter().map(|name| name.chars().count()).max();
        let numbers = match self.form {
            Form::Phone => 48,
            Form::Page if self.is_narrow() => 60,
            Form::Page => 72,
        };
        longest.map_or(numbers, |characters| {
            (CHARACTER * f64::from(self.sizes().tick) * characters as f64) as u32 + 12
        })
    }

    /// Whether the label of the y axis is above the chart, because a phone has too little room
    /// beside it.
    pub(super) fn says_above(self) -> bool {
        self.form == Form::Phone
    }

    /// Folds a text of this size into lines that are at most as wide as the chart.
    pub(super) fn lines(self, text: &str, size: u32) -> String {
        fold("", text, (f64::from(self.width - 12) / (CHARACTER * f64::from(size))) as usize)
    }
}
