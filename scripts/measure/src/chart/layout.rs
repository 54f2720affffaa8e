//! How large a chart and what is in it are, by what shows it.

use super::{Chart, Form};

const BAR_ROW: u32 = 22;
/// The width of a character, in sizes of its text.
const CHARACTER: f64 = 0.45;

/// Where a chart is drawn: its width, the height of its plot, and whether its legend stands below.
#[derive(Clone, Copy)]
pub(super) struct Layout {
    form: Form,
    pub(super) width: u32,
    pub(super) plot: u32,
    pub(super) legend: bool,
}

/// Sizes of text, 1.24 times its height in pixels. None is less than 12 pixels high as it is shown: a page scales a
/// figure by 0.91.
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

    /// Height of the plot of a chart, and of one in a row of several.
    fn plots(self) -> (u32, u32) {
        match self {
            Self::Page => (460, 300),
            Self::Phone => (300, 260),
        }
    }
}

impl Layout {
    /// A chart that has the whole width.
    pub(super) fn alone(chart: &Chart, form: Form) -> Self {
        let plot = match chart.y.named().len() as u32 {
            0 => form.plots().0,
            bars => 110 + bars * BAR_ROW,
        };
        let legend = form == Form::Phone || !chart.direct;
        Self { form, width: form.width(), plot, legend }
    }

    /// One of several charts of a row, whose legend stands below them all.
    pub(super) fn beside(charts: usize, form: Form) -> Self {
        let width = match form {
            Form::Page => form.width() / charts.max(1) as u32,
            Form::Phone => form.width(),
        };
        Self { form, width, plot: form.plots().1, legend: false }
    }

    /// A legend alone.
    pub(super) fn below(form: Form) -> Self {
        Self { form, width: form.width(), plot: 0, legend: true }
    }

    pub(super) fn height(self, chart: &Chart) -> u32 {
        let rows = chart.named().count().div_ceil(self.columns()) as u32;
        self.plot + if self.legend { rows * self.entry_row() + 12 } else { 0 }
    }

    pub(super) fn is_narrow(self) -> bool {
        self.width < Form::Page.width()
    }

    /// Names at the ends of the lines need room there.
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

    /// How many values an axis labels at most, if it may choose: to the right and upwards.
    pub(super) fn ticks(self) -> (usize, usize) {
        if self.is_narrow() { (5, 7) } else { (8, 8) }
    }

    /// Columns of the legend.
    pub(super) fn columns(self) -> usize {
        if self.form == Form::Phone { 1 } else { 2 }
    }

    pub(super) fn entry_row(self) -> u32 {
        if self.form == Form::Phone { 21 } else { 24 }
    }

    /// Room for names beside an axis.
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

    /// Whether what the chart shows upwards is said above it; beside it a phone has too little room.
    pub(super) fn says_above(self) -> bool {
        self.form == Form::Phone
    }

    /// A text of that size in lines that are as wide as the chart at most.
    pub(super) fn lines(self, text: &str, size: u32) -> Vec<String> {
        let fits = f64::from(self.width - 12) / (CHARACTER * f64::from(size));
        let mut lines: Vec<String> = Vec::new();
        for word in text.split_whitespace() {
            match lines.last_mut() {
                Some(line) if (line.chars().count() + word.chars().count()) < fits as usize => {
                    *line += " ";
                    *line += word;
                }
                _ => lines.push(word.into()),
            }
        }
        lines
    }
}
