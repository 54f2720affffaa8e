//! A dot plot of the variants' times, on a logarithmic axis.
//!
//! Each row is HTML with its own SVG. Positions in the SVG are percentages, so the plot fits every
//! width. The plot needs no script: check boxes hide rows through the style sheet.

use lab_kit::Lab;
use lab_kit::facts::Workers;

use crate::digits::Format;

/// A program and its times.
pub(crate) struct Row {
    pub(crate) lab: Lab,
    pub(crate) name: String,
    pub(crate) workers: Workers,
    /// Times of the program with few, some and many particles.
    pub(crate) times: [Time; 3],
}

/// The time of a program with a number of particles.
pub(crate) struct Time {
    /// The number of particles.
    pub(crate) n: &'static str,
    /// Nanoseconds per particle and step on one worker, as printed; `None` if it was not measured.
    pub(crate) printed: Option<String>,
}

impl Time {
    fn nanoseconds(&self) -> Option<f64> {
        self.printed.as_ref()?.replace(',', "").parse().ok()
    }
}

/// The radii of the dots of the three sizes.
const RADII: [f64; 3] = [2.5, 4.5, 6.5];

/// The kinds of workers: their class in the style sheet, and their name.
const WORKERS: [(Workers, &str, &str); 3] = [
    (Workers::Threads, "threads", "threads"),
    (Workers::Ranks, "ranks", "ranks (MPI)"),
    (Workers::Device, "device", "GPU"),
];

/// Returns the plot of these rows.
///
/// Rows without a time are left out. The plot is empty if no row has a time.
pub(crate) fn plot(rows: &[Row]) -> String {
    let rows: Vec<&Row> = rows.iter().filter(|row| row.numbers().next().is_some()).collect();
    let Some(axis) = Axis::of(rows.iter().flat_map(|row| row.numbers())) else {
        return String::new();
    };
    let decades = axis.last - axis.first;
    let label = format!(
        "The times of {} programs in nanoseconds per particle and step, on a logarithmic axis. The \
         table below has the same numbers.",
        rows.len()
    );
    let mut out = format!("\n<figure class=\"plot\" style=\"--decades: {decades}\">\n");
    out += &filter(&rows);
    out += &format!("<div role=\"img\" aria-label=\"{label}\">\n");
    out += &axis.row();
    for row in &rows {
        out += &row.drawn(&axis);
    }
    out += "</div>\n<figcaption>Nanoseconds per particle and step on one worker (1k is 1,000). ";
    for (time, radius) in rows[0].times.iter().zip(RADII) {
        let dot = dot(50.0, radius);
        out += &format!("<svg class=\"plot-key\">{dot}</svg> n&nbsp;=&nbsp;{} ", time.n);
    }
    out + "Point at a row for its numbers. The number before a name is the lab.</figcaption>\n</figure>\n"
}

/// Returns a check box for each kind of workers, if there are several kinds.
fn filter(rows: &[&Row]) -> String {
    let kinds = WORKERS.iter().filter(|kind| rows.iter().any(|row| row.workers == kind.0));
    let mut boxes = Vec::new();
    for (_, class, name) in kinds {
        let input = format!("<input type=\"checkbox\" class=\"only-{class}\" checked>");
        boxes.push(format!("<label>{input} {name}</label>"));
    }
    if boxes.len() < 2 {
        return String::new();
    }
    format!("<fieldset><legend>Programs on</legend>{}</fieldset>\n", boxes.concat())
}

/// Returns a dot at this percentage of the width.
fn dot(at: f64, radius: f64) -> String {
    format!("<circle cx=\"{at:.1}%\" cy=\"50%\" r=\"{radius}\"></circle>")
}

impl Row {
    fn numbers(&self) -> impl Iterator<Item = f64> {
        self.times.iter().filter_map(Time::nanoseconds)
    }

    fn drawn(&self, axis: &Axis) -> String {
        let Self { lab, name, workers, times } = self;
        let class = WORKERS.iter().find(|kind| kind.0 == *workers).map_or("", |kind| kind.1);
        let mut dots = String::new();
        let mut labels = Vec::new();
        for (time, radius) in times.iter().zip(RADII) {
            if let (Some(printed), Some(number)) = (&time.printed, time.nanoseconds()) {
                labels.push(format!("{printed} ns with {}", time.n));
                dots += &dot(axis.at(number), radius);
            }
        }
        let least = axis.at(self.numbers().fold(f64::INFINITY, f64::min));
        let greatest = axis.at(self.numbers().fold(0.0, f64::max));
        format!(
            "<div class=\"plot-row {class} lab-{lab}\" title=\"{name}: {}\"><span><b>{lab}</b> {name}</span>\
             <svg><line x1=\"{least:.1}%\" x2=\"{greatest:.1}%\" y1=\"50%\" y2=\"50%\"></line>{dots}</svg></div>\n",
            labels.join(", "),
        )
    }
}

/// A logarithmic axis between two powers of ten.
struct Axis {
    first: i32,
    last: i32,
}

impl Axis {
    /// Returns the shortest axis that contains all these numbers; `None` if there are no numbers.
    fn of(numbers: impl Iterator<Item = f64>) -> Option<Self> {
        let powers: Vec<f64> = numbers.map(f64::log10).collect();
        let first = powers.iter().copied().min_by(f64::total_cmp)?.floor();
        let last = powers.iter().copied().max_by(f64::total_cmp)?.ceil();
        Some(Self { first: first as i32, last: (last as i32).max(first as i32 + 1) })
    }

    /// Returns the place of a number, in per cent of the width.
    fn at(&self, number: f64) -> f64 {
        100.0 * (number.log10() - f64::from(self.first)) / f64::from(self.last - self.first)
    }

    fn row(&self) -> String {
        let mut ticks = String::new();
        for power in self.first..=self.last {
            let at = self.at(10f64.powi(power));
            let text = Format::of(".0").unwrap_or_default().print(10f64.powi(power));
            // A phone has no room for the zeros of thousands.
            let text = text.replace(",000", "k");
            ticks += &format!("<text x=\"{at:.1}%\" y=\"75%\">{text}</text>");
        }
        format!("<div class=\"plot-row plot-axis\"><span></span><svg>{ticks}</svg></div>\n")
    }
}

#[cfg(test)]
mod tests {
    use super::{Row, Time, plot};
    use lab_kit::facts::Workers;

    fn row(lab: &str, workers: Workers, printed: [Option<&str>; 3]) -> Row {
        let [few, some, many] = printed.map(|text| text.map(Into::into));
        let times = [("10", few), ("100", some), ("1000", many)];
        let times = times.map(|(n, printed)| Time { n, printed });
        Row { lab: lab.parse().unwrap(), name: format!("program-{lab}"), workers, times }
    }

    #[test]
    fn dots_are_on_a_logarithmic_axis() {
        let rows = [
            row("1", Workers::Threads, [Some("10.0"), Some("1,000"), None]),
            row("6", Workers::Ranks, [Some("316"), None, None]),
            row("9", Workers::Device, [None, None, None]),
        ];
        let plot = plot(&rows);
        for there in
            ["--decades: 2\"", "cx=\"0.0%\"", "cx=\"100.0%\"", "cx=\"75.0%\"", "only-ranks"]
        {
            assert!(plot.contains(there), "{there} is not in {plot}");
        }
        assert!(plot.contains("title=\"program-1: 10.0 ns with 10, 1,000 ns with 100\""), "{plot}");
        assert!(!plot.contains("program-9") && !plot.contains("only-device"), "{plot}");
        assert!(!plot.trim().contains("\n\n"), "a blank line would end the HTML");
    }

    #[test]
    fn programs_without_times_have_no_plot() {
        assert_eq!(plot(&[]), "");
        assert_eq!(plot(&[row("1", Workers::Threads, [None, None, None])]), "");
    }
}
