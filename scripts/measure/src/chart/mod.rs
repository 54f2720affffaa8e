//! Charts of lines and bars as SVG, the one look of all figures.
//!
//! ```ignore
//! let chart = Chart::new("Run time against n", Axis::log("particles n"), Axis::log("time [s]"))
//!     .with(Series::new(Kind::Measured, "sorted", points))
//!     .with(Series::new(Kind::Published, "CS267, Table 1", table))
//!     .with(Series::new(Kind::Guide, "slope 1", line));
//! write_file(&path, &chart.svg())?;
//! ```
//!
//! Points are (x, y) pairs in any order. On a logarithmic axis a value that is not positive, and
//! on every axis one that is not finite, is left out. Colours can be told apart with any kind of
//! colour vision, and every series has its own mark as well.

mod axis;
mod draw;
mod layout;
mod look;

pub use axis::{Axis, number};

/// A chart of one or more series over common axes.
#[derive(Clone, Debug)]
pub struct Chart {
    title: String,
    x: Axis,
    y: Axis,
    series: Vec<Series>,
    /// From where on the area is shaded, and what is said there.
    beyond: Option<(f64, String)>,
    /// Whether names stand at the ends of their lines instead of in a legend.
    direct: bool,
}

/// A figure: rows of charts. Those in one row show the same series, and share a legend.
pub type Sheet = Vec<Vec<Chart>>;

/// What shows a figure: a page, or a phone, which has less than half the width.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "said above")]
pub enum Form {
    Page,
    Phone,
}

/// One line of a chart.
#[derive(Clone, Debug)]
pub struct Series {
    /// None in a legend if it is empty.
    name: String,
    kind: Kind,
    /// In ascending x; of a part of bars the start and the end, bar by bar.
    points: Vec<(f64, f64)>,
    /// Lower and upper bound (x, low, high), in ascending x; may be empty.
    band: Vec<(f64, f64, f64)>,
}

/// What a line stands for, which decides how it looks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Measured on this machine: a full line with filled marks.
    Measured,
    /// The same in marks alone: its points have no order.
    Apart,
    /// The same in grey, only there to be compared with.
    Behind,
    /// One of many that are alike, of which one is named: a thin grey line, without marks.
    Crowd,
    /// Printed in a course report, whose name comes first: dashes with hollow marks.
    Published,
    /// Given by a formula: a full line without marks, with a band.
    Model,
    /// A line for the eye, such as an ideal or a slope: thin, grey, no marks.
    Guide,
    /// A part of each bar, between two points.
    Part,
}

impl Chart {
    /// An empty chart.
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

    /// A chart of one bar for each of `rows`, from the upper end down: a name, and the lengths of the parts
    /// that follow each other in the bar.
    pub fn bars<'p>(
        title: impl Into<String>,
        x: Axis,
        parts: &[&'p str],
        rows: &[(String, Vec<f64>)],
    ) -> Self {
        let part = |(at, &name): (usize, &&'p str)| {
            let stretches = rows.iter().enumerate().map(|(row, (_, lengths))| {
                let start: f64 = lengths[..at].iter().sum();
                (row, start, start + lengths[at])
            });
            (name, stretches.collect())
        };
        let names = rows.iter().map(|(name, _)| name.clone()).collect();
        Self::lanes(title, x, names, parts.iter().enumerate().map(part))
    }

    /// A chart of one lane for each of `names`, from the upper end down. Each part has its name, and stretches
    /// of lanes: which lane, start and end.
    pub fn lanes<'p>(
        title: impl Into<String>,
        x: Axis,
        names: Vec<String>,
        parts: impl IntoIterator<Item = (&'p str, Vec<(usize, f64, f64)>)>,
    ) -> Self {
        let part = |(name, stretches): (&str, Vec<(usize, f64, f64)>)| {
            let ends = |(lane, start, end)| [(start, lane as f64), (end, lane as f64)];
            let points = stretches.into_iter().flat_map(ends).collect();
            Series { name: name.into(), kind: Kind::Part, points, band: Vec::new() }
        };
        Self::new(title, x, Axis::names(names)).with_all(parts.into_iter().map(part))
    }

    /// Shades the area from this x on, such as more workers than cores, and says so there.
    #[must_use]
    pub fn shaded_beyond(mut self, x: Option<f64>, what: &str) -> Self {
        self.beyond = x.map(|x| (x, what.into()));
        self
    }

    /// Puts each name at the end of its line, and leaves the legend out.
    #[must_use]
    pub fn labelled_directly(mut self) -> Self {
        self.direct = true;
        self
    }

    /// The series that have a name.
    fn named(&self) -> impl Iterator<Item = &Series> {
        self.series.iter().filter(|series| !series.name.is_empty())
    }

    /// Several charts in one SVG document, white behind, with fonts that every reader has.
    pub fn sheet(rows: &[Vec<Self>], form: Form) -> String {
        draw::sheet(rows, form)
    }

    /// This chart alone, for a page.
    pub fn svg(self) -> String {
        Self::sheet(&[vec![self]], Form::Page)
    }
}

impl Series {
    /// A line through (x, y), in any order.
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_chart_names_what_it_shows() {
        let line = vec![(1000.0, 0.1), (2000.0, 0.2), (64_000.0, 6.0)];
        let svg = Chart::new("Time < n & more", Axis::log("particles n"), Axis::log("time [s]"))
            .with(Series::new(Kind::Measured, "sorted", line.clone()))
            .with(Series::new(Kind::Published, "CS267, Table 1", line.clone()))
            .with(Series::new(Kind::Guide, "slope 1", line))
            .svg();
        for text in
            ["Time &lt; n &amp; more", "particles n", "time [s]", "sorted", "CS267, Table 1"]
        {
            assert!(svg.contains(text), "{text} is missing");
        }
        assert!(svg.starts_with("<svg") && svg.trim_end().ends_with("</svg>"));
    }

    #[test]
    fn the_parts_of_a_bar_follow_each_other() {
        let rows = [("one".into(), vec![2.0, 1.0]), ("two".into(), vec![0.5, 0.25])];
        let chart = Chart::bars("Where", Axis::linear("ms"), &["work", "wait"], &rows);
        let points: Vec<_> = chart.series.iter().map(|part| part.points.clone()).collect();
        let work = vec![(0.0, 0.0), (2.0, 0.0), (0.0, 1.0), (0.5, 1.0)];
        assert_eq!(points, [work, vec![(2.0, 0.0), (3.0, 0.0), (0.5, 1.0), (0.75, 1.0)]]);
        let svg = chart.svg();
        assert!(
            ["one", "two", "work", "wait", "ms"].iter().all(|text| svg.contains(text)),
            "{svg}"
        );
    }

    #[test]
    fn text_can_be_read_on_a_page_and_on_a_phone() {
        // As wide as a page of the book, and a phone, show it.
        for (form, shown) in [(Form::Page, 750.0), (Form::Phone, 350.0)] {
            let chart =
                Chart::new("A long title of some words", Axis::linear("x"), Axis::linear("y"))
                    .with(Series::new(Kind::Measured, "a", vec![(0.0, 1.0), (1.0, 2.0)]))
                    .shaded_beyond(Some(0.5), "more than cores");
            let direct = chart.clone().labelled_directly();
            let svg = Chart::sheet(&[vec![chart.clone(), chart], vec![direct]], form);
            let sizes = svg.split("font-size=\"").skip(1).filter_map(|rest| rest.split('"').next());
            let least = sizes.map(|size| size.parse().unwrap()).fold(f64::INFINITY, f64::min);
            let least = least * f64::min(1.0, shown / f64::from(form.width()));
            assert!(least >= 12.0, "{form:?}: {least} px");
        }
    }

    #[test]
    fn what_cannot_be_drawn_is_left_out() {
        let svg = Chart::new("", Axis::log("x"), Axis::log("y"))
            .with(Series::new(
                Kind::Measured,
                "a",
                vec![(0.0, 1.0), (1.0, f64::NAN), (2.0, -1.0), (3.0, 1.0)],
            ))
            .svg();
        assert!(svg.contains("circle") && !svg.contains("NaN") && !svg.contains("inf"));
        assert!(
            Chart::new("nothing", Axis::linear("x"), Axis::linear("y")).svg().contains("nothing")
        );
    }
}
