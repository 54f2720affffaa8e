//! Numbers that the course reports printed, for comparison with measurements: book/published.toml.

use std::collections::BTreeMap;
use std::sync::LazyLock;

use serde::Deserialize;

use super::autograder::{strong_efficiency, weak_efficiency};

/// Number of steps of a run of soft discs in the reports.
pub const SOFT_STEPS: f64 = 1000.0;

/// Number of steps of a run of hard discs in the report.
pub const HARD_STEPS: f64 = 50.0;

static REPORTS: LazyLock<Reports> = LazyLock::new(|| {
    let text = include_str!("../../../book/published.toml");
    basic_toml::from_str(text).expect("the kit's own file, which a test reads")
});

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Reports {
    growth: BTreeMap<String, Growth>,
    scaling: BTreeMap<String, Scaling>,
    hard: BTreeMap<String, Swept>,
}

/// Seconds against the number of particles.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Growth {
    /// The report and its table.
    pub name: String,
    /// Points (n, seconds).
    pub points: Vec<(f64, f64)>,
}

/// Seconds against the number of workers.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Scaling {
    /// The report and its section.
    pub name: String,
    /// Variants of the kit that work like the report's program, if several reports have programs of
    /// this kind.
    #[serde(default)]
    programs: Vec<String>,
    /// Seconds of the serial program on the scene of the strong scaling.
    serial: f64,
    /// Points (workers, seconds) on one scene.
    pub strong: Vec<(usize, f64)>,
    /// Points (workers, seconds) on a scene that grows with the workers; may be empty.
    #[serde(default)]
    weak: Vec<(usize, f64)>,
}

/// The CS3210 report's measurements of a program, in addition to its growth and its scaling.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Swept {
    /// Variant of the kit that works like the report's program.
    pub(crate) variant: String,
    /// Points (side of the square, seconds).
    pub(crate) by_side: Vec<(f64, f64)>,
    /// Points (radius, seconds).
    pub(crate) by_radius: Vec<(f64, f64)>,
    /// Seconds of the report's other programs on the usual scene, by the names of the kit's
    /// variants.
    #[serde(default)]
    pub(crate) variants: BTreeMap<String, f64>,
}

/// Finds the growth of this name in the file, such as `csc581-serial`.
pub fn growth(name: &str) -> &'static Growth {
    &REPORTS.growth[name]
}

/// Finds the scaling of this name in the file, such as `csc581-openmp`.
pub fn scaling(name: &str) -> &'static Scaling {
    &REPORTS.scaling[name]
}

/// Finds the sweeps of hard discs of this name: `threads`, `ranks` or `device`.
pub(crate) fn swept(name: &str) -> &'static Swept {
    &REPORTS.hard[name]
}

/// Finds the scalings of programs that are among these variants.
pub fn scalings_of(variants: &[&str]) -> Vec<&'static Scaling> {
    let mut scalings: Vec<&Scaling> = REPORTS.scaling.values().collect();
    scalings.retain(|scaling| scaling.programs.iter().any(|name| variants.contains(&&**name)));
    scalings
}

impl Scaling {
    /// Iterates over the numbers of workers.
    pub fn workers(&self) -> impl Iterator<Item = f64> {
        self.strong.iter().map(|&(p, _)| p as f64)
    }

    /// Returns the serial time divided by the parallel time, for each number of workers.
    pub fn speedups(&self) -> Vec<f64> {
        self.strong.iter().map(|&(_, t)| self.serial / t).collect()
    }

    /// Returns the strong-scaling efficiency for each number of workers.
    pub fn strong_efficiencies(&self) -> Vec<f64> {
        self.strong.iter().map(|&(p, t)| strong_efficiency(self.serial, p, t)).collect()
    }

    /// Returns the weak-scaling efficiency for each number of workers. With one worker the scene is
    /// the same as for strong scaling.
    pub fn weak_efficiencies(&self) -> Vec<f64> {
        self.weak.iter().map(|&(_, t)| weak_efficiency(self.serial, t)).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::autograder::{complexity_grade, scaling_grade, slope};

    /// Rounds a value as a report prints it.
    fn printed(value: f64, digits: usize) -> String {
        format!("{value:.digits$}")
    }

    /// Rounds a row of a report.
    fn row(values: &[f64]) -> String {
        values.iter().map(|value| printed(*value, 2)).collect::<Vec<_>>().join(" ")
    }

    #[test]
    fn csc581_serial_slope_and_grade() {
        let slope = slope(&growth("csc581-serial").points);
        assert_eq!(printed(slope, 6), "1.063423");
        assert_eq!(printed(complexity_grade(slope), 2), "100.00");
    }

    #[test]
    fn csc581_slopes_between_neighbours() {
        let points = &growth("csc581-serial").points;
        let slopes: Vec<_> = points.windows(2).map(|two| printed(slope(two), 6)).collect();
        assert_eq!(slopes, ["1.048336", "1.059738", "1.051694", "1.101631"]);
    }

    fn mean(values: &[f64]) -> f64 {
        values.iter().sum::<f64>() / values.len() as f64
    }

    fn csc581(report: &Scaling, speedups: &str, strong: &str, weak: &str, rest: &str) {
        assert_eq!(row(&report.speedups()), speedups);
        assert_eq!(row(&report.strong_efficiencies()), strong);
        assert_eq!(row(&report.weak_efficiencies()), weak);
        let strong = mean(&report.strong_efficiencies());
        let weak = mean(&report.weak_efficiencies());
        assert_eq!(row(&[strong, weak, scaling_grade(strong, weak)]), rest);
    }

    #[test]
    fn csc581_openmp_efficiencies_and_grade() {
        csc581(
            scaling("csc581-openmp"),
            "0.96 1.60 2.03 2.33 2.59",
            "0.96 0.80 0.51 0.29 0.16",
            "0.96 0.89 0.64 0.47 0.21",
            "0.55 0.63 82.42",
        );
    }

    #[test]
    fn csc581_mpi_efficiencies_and_grade() {
        csc581(
            scaling("csc581-mpi"),
            "0.76 1.38 1.59 1.54 1.56",
            "0.76 0.69 0.40 0.19 0.10",
            "0.76 0.64 0.42 0.30 0.23",
            "0.43 0.47 67.61",
        );
    }

    /// CS267 prints times with three decimals, so the third decimal of a slope is uncertain.
    #[test]
    fn cs267_slopes() {
        for (name, printed) in [
            ("cs267-preliminary", 1.073_064),
            ("cs267-final", 1.133_384),
            ("cs267-4-threads", 1.045_478),
            ("cs267-16-threads", 0.978_134),
            ("cs267-32-threads", 0.932_867),
        ] {
            let slope = slope(&growth(name).points);
            assert!((slope - printed).abs() < 1e-3, "{name}: {slope}, not {printed}");
            assert_eq!(complexity_grade(slope), 100.0);
        }
    }

    /// CSC367 prints no slope. Its text says «linear», so by this rubric its Table 1 must be
    /// linear.
    #[test]
    fn csc367_is_linear() {
        let slope = slope(&growth("csc367-serial").points);
        assert!((1.0..1.05).contains(&slope), "{slope}");
    }
}
