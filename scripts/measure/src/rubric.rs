//! The grades of the original autograder: complexity by slope, scaling by efficiency.
//!
//! Its rules are not in any of the course reports, but its outputs are: the tests below get the
//! grades that the reports print from the times that they print.

use super::clock::Span;

/// Slope of the least-squares line through (ln x, ln y): the exponent b of y ∝ xᵇ.
///
/// Not a number if there are fewer than two different x; points must be positive.
pub fn slope(points: &[(f64, f64)]) -> f64 {
    let count = points.len() as f64;
    let logs = || points.iter().map(|&(x, y)| (x.ln(), y.ln()));
    let mean_x = logs().map(|(x, _)| x).sum::<f64>() / count;
    let mean_y = logs().map(|(_, y)| y).sum::<f64>() / count;
    let over: f64 = logs().map(|(x, y)| (x - mean_x) * (y - mean_y)).sum();
    let under: f64 = logs().map(|(x, _)| (x - mean_x).powi(2)).sum();
    over / under
}

/// The slope by the shortest takes, and by the medians.
pub fn slopes(points: &[(f64, Span)]) -> Span {
    let line = |way: fn(&Span) -> f64| points.iter().map(|(x, y)| (*x, way(y))).collect::<Vec<_>>();
    Span::both(|way| slope(&line(way)))
}

/// Grade of a program whose time grows as n to the power `slope`.
pub fn complexity_grade(slope: f64) -> f64 {
    match slope {
        b if b < 1.3 => 100.0,
        b if b < 1.5 => 75.0 + (1.5 - b) / 0.2 * 25.0,
        b if b < 2.0 => (2.0 - b) / 0.5 * 75.0,
        _ => 0.0,
    }
}

/// Strong scaling: the share of `workers` times the speed that `workers` workers reach on the
/// same scene, from the seconds of one worker and of all.
pub fn strong_efficiency(one: f64, workers: usize, all: f64) -> f64 {
    one / (workers as f64 * all)
}

/// Weak scaling: one worker's seconds over those of all on a scene that is larger in proportion.
pub fn weak_efficiency(one: f64, all: f64) -> f64 {
    one / all
}

/// Mean efficiency over the numbers of workers, one worker included; none without any.
pub fn average(efficiencies: &[f64]) -> Option<f64> {
    (!efficiencies.is_empty()).then(|| efficiencies.iter().sum::<f64>() / efficiencies.len() as f64)
}

/// The same by the shortest takes and by the medians; none without any.
pub fn averages(efficiencies: &[Span]) -> Option<Span> {
    let all = |way: fn(&Span) -> f64| average(&efficiencies.iter().map(way).collect::<Vec<_>>());
    all(|span| span.min)?;
    Some(Span::both(|way| all(way).unwrap_or(f64::NAN)))
}

/// Grade of an average efficiency.
pub fn efficiency_grade(average: f64) -> f64 {
    match average {
        e if e > 0.8 => 100.0,
        e if e > 0.5 => 75.0 + 25.0 * (e - 0.5) / 0.3,
        e => 150.0 * e,
    }
}

/// Grade of a parallel program: the mean of the grades of its average strong and weak efficiency.
pub fn scaling_grade(strong: f64, weak: f64) -> f64 {
    0.5 * (efficiency_grade(strong) + efficiency_grade(weak))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::published::{self, Scaling};

    /// Rounded as a report prints it.
    fn printed(value: f64, digits: usize) -> String {
        format!("{value:.digits$}")
    }

    #[test]
    fn csc581_serial_slope_and_grade() {
        let slope = slope(&published::growth("csc581-serial").points);
        assert_eq!(printed(slope, 6), "1.063423");
        assert_eq!(printed(complexity_grade(slope), 2), "100.00");
    }

    #[test]
    fn csc581_slopes_between_neighbours() {
        let slopes: Vec<_> = published::growth("csc581-serial")
            .points
            .windows(2)
            .map(|two| printed(slope(two), 6))
            .collect();
        assert_eq!(slopes, ["1.048336", "1.059738", "1.051694", "1.101631"]);
    }

    fn csc581(report: &Scaling, speedups: &str, strong: &str, weak: &str, rest: [&str; 3]) {
        let row = |values: Vec<f64>| {
            values.into_iter().map(|v| printed(v, 2)).collect::<Vec<_>>().join(" ")
        };
        let strong_of = report.strong_efficiencies();
        let weak_of = report.weak_efficiencies();
        assert_eq!(row(report.speedups()), speedups);
        assert_eq!(row(strong_of.clone()), strong);
        assert_eq!(row(weak_of.clone()), weak);
        let strong = average(&strong_of).unwrap();
        let weak = average(&weak_of).unwrap();
        let grade = scaling_grade(strong, weak);
        assert_eq!([printed(strong, 2), printed(weak, 2), printed(grade, 2)], rest);
    }

    #[test]
    fn csc581_openmp_efficiencies_and_grade() {
        csc581(
            published::scaling("csc581-openmp"),
            "0.96 1.60 2.03 2.33 2.59",
            "0.96 0.80 0.51 0.29 0.16",
            "0.96 0.89 0.64 0.47 0.21",
            ["0.55", "0.63", "82.42"],
        );
    }

    #[test]
    fn csc581_mpi_efficiencies_and_grade() {
        csc581(
            published::scaling("csc581-mpi"),
            "0.76 1.38 1.59 1.54 1.56",
            "0.76 0.69 0.40 0.19 0.10",
            "0.76 0.64 0.42 0.30 0.23",
            ["0.43", "0.47", "67.61"],
        );
    }

    /// The times of CS267 are printed with three decimals, which leaves the third decimal of a
    /// slope open.
    #[test]
    fn cs267_slopes() {
        for (table, printed) in [
            (published::growth("cs267-preliminary"), 1.073_064),
            (published::growth("cs267-final"), 1.133_384),
            (published::growth("cs267-4-threads"), 1.045_478),
            (published::growth("cs267-16-threads"), 0.978_134),
            (published::growth("cs267-32-threads"), 0.932_867),
        ] {
            let slope = slope(&table.points);
            assert!((slope - printed).abs() < 1e-3, "{}: {slope}, not {printed}", table.name);
            assert_eq!(complexity_grade(slope), 100.0);
        }
    }

    /// CSC367 prints no slope: «linear» is what its Table 1 must be by this rubric.
    #[test]
    fn csc367_is_linear() {
        let slope = slope(&published::growth("csc367-serial").points);
        assert!((1.0..1.05).contains(&slope), "{slope}");
    }

    #[test]
    fn grades_are_continuous_where_the_rule_changes() {
        let near = |a: f64, b: f64| assert!((a - b).abs() < 1e-6, "{a} against {b}");
        for edge in [1.3, 1.5, 2.0] {
            near(complexity_grade(edge - 1e-9), complexity_grade(edge + 1e-9));
        }
        for edge in [0.5, 0.8] {
            near(efficiency_grade(edge - 1e-9), efficiency_grade(edge + 1e-9));
        }
        near(complexity_grade(1.4), 87.5);
        near(complexity_grade(1.75), 37.5);
        near(complexity_grade(2.2), 0.0);
        near(efficiency_grade(1.2), 100.0);
        near(efficiency_grade(0.65), 87.5);
        near(efficiency_grade(0.2), 30.0);
        assert_eq!(average(&[]), None);
    }
}
