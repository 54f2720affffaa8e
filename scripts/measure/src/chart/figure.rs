//! A figure: its charts, and their series.

use super::axis::Axis;

/// A chart of one or more series over common axes.
#[derive(Clone, Debug)]
pub struct Chart {
    pub(super) title: String,
    pub(super) x: Axis,
    pub(super) y: Axis,
    pub(super) series: Vec<Series>,
    /// Value of x where a shaded area begins, and the text in it.
    pub(super) beyond: Option<(f64, String)>,
    /// Whether names are at the ends of their lines instead of in a legend.
    pub(super) direct: bool,
}

/// A figure: rows of charts. The charts of a row show the same series, and share a legend.
pub type Sheet = Vec<Vec<Chart>>;

/// The medium of a figure: a page, or a phone, which has less than half the width.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "said above")]
pub enum Form {
    Page,
    Phone,
}

/// A line of a chart.
#[derive(Clone, Debug)]
pub struct Series {
    /// Name in the legend; empty for a series that is not in the legend.
    pub(super) name: String,
    pub(super) kind: Kind,
    /// Points in ascending order of x. For parts of bars, each pair of points is the start and the
    /// end of a part.
    pub(super) points: Vec<(f64, f64)>,
    /// Lower and upper bounds (x, low, high) in ascending order of x; may be empty.
    pub(super) band: Vec<(f64, f64, f64)>,
}

/// The meaning of a line, which determines its look.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Measurements: a full line with filled marks.
    Measured,
    /// Measurements without an order: filled marks only.
    Apart,
    /// Measurements that are shown only for comparison: grey marks.
    Behind,
    /// One of many similar lines that share one name: thin and grey, without marks.
    Crowd,
    /// Numbers of a course report, named after the report: dashes with hollow marks.
    Published,
    /// Values of a formula: a full line without marks, with a band.
    Model,
    /// A guide such as an ideal or a slope: thin and grey, without marks.
    Guide,
    /// A part of each bar, between two points.
    Part,
}

impl Chart {
    /// Makes an empty chart.
    pub fn new(title: impl Into<String>, x: Axis, y: Axis) -> Self {
        Self { title: title.into(), x, y, series: Vec::new(), beyond: None, direct: false }
    }

    /// Adds a series; the legend keeps the order.
    #[must_use]
    pub fn with(mut self, series: Series) -> Self {
        self.series.push(series);
        self
    }

    /// Adds several series.
    #[must_use]
    pub fn with_all(mut self, series: impl IntoIterator<Item = Series>) -> Self {
        self.series.extend(series);
        self
    }

    /// Makes a chart with a bar for each of `rows`, from the upper end down.
    ///
    /// A row is a name, and the lengths of the parts that follow each other in the bar.
    pub fn bars(
        title: impl Into<String>,
        x: Axis,
        parts: &[&str],
        rows: &[(String, Vec<f64>)],
    ) -> Self {
        let names = rows.iter().map(|(name, _)| name.clone()).collect();
        let parts = parts.iter().enumerate().map(|(at, &name)| {
            let stretches = rows.iter().enumerate().map(|(row, (_, lengths))| {
                let start: f64 = lengths[..at].iter().sum();
                (row, start, start + lengths[at])
            });
            (name, stretches.collect())
        });
        Self::lanes(title, x, names, parts)
    }

    /// Makes a chart with a lane for each of `names`, from the upper end down.
    ///
    /// A part is a name, and periods in lanes: the number of the lane, start and end.
    pub fn lanes<'p>(
        title: impl Into<String>,
        x: Axis,
        names: Vec<String>,
        parts: impl IntoIterator<Item = (&'p str, Vec<(usize, f64, f64)>)>,
    ) -> Self {
        let mut chart = Self::new(title, x, Axis::names(names));
        for (name, stretches) in parts {
            let mut points = Vec::new();
            for (lane, start, end) in stretches {
                points.extend([(start, lane as f64), (end, lane as f64)]);
            }
            let part = Series { name: name.into(), kind: Kind::Part, points, band: Vec::new() };
            chart.series.push(part);
        }
        chart
    }

    /// Shades the area to the right of this x, and writes `what` in it. An example is the area with
    /// more workers than cores.
    #[must_use]
    pub fn shaded_beyond(mut self, x: Option<f64>, what: &str) -> Self {
        self.beyond = x.map(|x| (x, what.into()));
        self
    }

    /// Puts each name at the end of its line, and omits the legend.
    #[must_use]
    pub fn labelled_directly(mut self) -> Self {
        self.direct = true;
        self
    }

    /// Iterates over the series that have a name.
    pub(super) fn named(&self) -> impl Iterator<Item = &Series> {
        self.series.iter().filter(|series| !series.name.is_empty())
    }
}

impl Series {
    /// Makes a line through points (x, y), in any order.
    pub fn new(kind: Kind, name: impl Into<String>, mut points: Vec<(f64, f64)>) -> Self {
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
        Self { name: name.into(), kind, points, band: Vec::new() }
    }

    /// Shades the area between a lower and an upper bound: (x, low, high).
    #[must_use]
    pub fn with_band(mut self, mut band: Vec<(f64, f64, f64)>) -> Self {
        band.sort_by(|a, b| a.0.total_cmp(&b.0));
        self.band = band;
        self
    }
}
