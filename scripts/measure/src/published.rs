//! What the course reports printed, to be shown beside what is measured here: book/published.toml.

use std::collections::BTreeMap;
use std::sync::LazyLock;

use lab_kit::Workers;
use serde::{Deserialize, Serialize};

use super::rubric::{strong_efficiency, weak_efficiency};

/// Steps of a run of soft discs in the reports.
pub const SOFT_STEPS: f64 = 1000.0;

/// Steps of a run of hard discs in the report.
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
    /// (n, seconds).
    pub points: Vec<(f64, f64)>,
}

/// Seconds against the number of workers.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Scaling {
    /// The report and its section.
    pub name: String,
    /// Our variants that do what its program did, where several reports have programs of such a kind.
    #[serde(default)]
    programs: Vec<String>,
    /// Seconds of the serial program on the scene of the strong scaling.
    serial: f64,
    /// (workers, seconds), on one scene.
    pub strong: Vec<(usize, f64)>,
    /// (workers, seconds), on a scene that grows with the workers; may be empty.
    #[serde(default)]
    weak: Vec<(usize, f64)>,
}

/// What CS3210 measured of one program of hard discs beside its growth and its scaling.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Swept {
    /// Our variant that does what its program did.
    variant: String,
    /// (side of the square, seconds).
    by_side: Vec<(f64, f64)>,
    /// (radius, seconds).
    by_radius: Vec<(f64, f64)>,
    /// Seconds of its other programs on the usual scene, by our variants' names.
    #[serde(default)]
    variants: BTreeMap<String, f64>,
}

/// The growth of this name, such as `csc581-serial`; the names are those of the file.
pub fn growth(name: &str) -> &'static Growth {
    &REPORTS.growth[name]
}

/// The scaling of this name, such as `csc581-openmp`; the names are those of the file.
pub fn scaling(name: &str) -> &'static Scaling {
    &REPORTS.scaling[name]
}

/// The scalings whose programs are among ours.
pub fn scalings_of(is_ours: impl Fn(&str) -> bool) -> Vec<&'static Scaling> {
    let ours = |scaling: &&Scaling| scaling.programs.iter().any(|name| is_ours(name));
    REPORTS.scaling.values().filter(ours).collect()
}

impl Scaling {
    /// The numbers of workers.
    pub fn workers(&self) -> impl Iterator<Item = f64> {
        self.strong.iter().map(|&(p, _)| p as f64)
    }

    /// Serial time over parallel time.
    pub fn speedups(&self) -> Vec<f64> {
        self.strong.iter().map(|&(_, t)| self.serial / t).collect()
    }

    /// Strong efficiency for each number of workers.
    pub fn strong_efficiencies(&self) -> Vec<f64> {
        self.strong.iter().map(|&(p, t)| strong_efficiency(self.serial, p, t)).collect()
    }

    /// Weak efficiency for each number of workers; its scene for one worker is the strong one's.
    pub fn weak_efficiencies(&self) -> Vec<f64> {
        self.weak.iter().map(|&(_, t)| weak_efficiency(self.serial, t)).collect()
    }
}

/// What the CS3210 report has for a run of [`HARD_STEPS`] steps.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Report {
    /// Its program died of a segmentation fault.
    Crashes,
    /// The shortest of three takes.
    #[serde(untagged)]
    Seconds(f64),
}

impl Report {
    /// The same in another unit.
    pub(crate) fn scaled(self, scale: f64) -> Self {
        match self {
            Self::Seconds(seconds) => Self::Seconds(seconds * scale),
            Self::Crashes => Self::Crashes,
        }
    }
}

/// What the report has for one of its programs, with threads (OpenMP), ranks (MPI) or a device (CUDA); a scene (N, L, r);
/// the number of workers where that is what varies. Its own sweeps ran on 20 threads or 16
/// processes, its Table 2 on 20 threads.
pub fn hard_discs(
    with: Workers,
    variant: &str,
    (n, side, radius): (usize, f64, f64),
    workers: Option<usize>,
) -> Option<Report> {
    let (swept, by_n, by_workers) = match with {
        Workers::Threads => ("threads", "cs3210-openmp-growth", Some("cs3210-openmp")),
        Workers::Ranks => ("ranks", "cs3210-mpi-growth", Some("cs3210-mpi")),
        Workers::Device => ("device", "cs3210-cuda-growth", None),
    };
    let swept = &REPORTS.hard[swept];
    let of = |points: &[(f64, f64)], x: f64| {
        points.iter().find(|point| point.0 == x).map(|point| Report::Seconds(point.1))
    };
    let usual = (n == 10_000, side == 2e4, radius == 1.0);
    if let Some(workers) = workers {
        let strong = scaling(by_workers?).strong.iter().find(|(p, _)| *p == workers);
        let there = usual == (true, true, true) && variant == swept.variant;
        return strong.filter(|_| there).map(|&(_, seconds)| Report::Seconds(seconds));
    }
    if usual == (true, true, true) && !swept.variants.is_empty() {
        return swept.variants.get(variant).map(|&seconds| Report::Seconds(seconds));
    }
    if variant != swept.variant {
        return None;
    }
    match usual {
        (_, true, true) if n == 50_000 => Some(Report::Crashes),
        (_, true, true) => of(&growth(by_n).points, n as f64),
        (true, _, true) => of(&swept.by_side, side),
        (true, true, _) => of(&swept.by_radius, radius),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use lab_kit::Workers;

    use super::{Report, hard_discs};

    #[test]
    fn the_report_is_found_for_its_own_scenes_only() {
        let openmp =
            |variant, scene, workers| hard_discs(Workers::Threads, variant, scene, workers);
        let usual = (10_000, 2e4, 1.0);
        let seconds = |s| Some(Report::Seconds(s));
        assert_eq!(openmp("grid", usual, None), seconds(30.84));
        assert_eq!(openmp("outer-dynamic", (40_000, 2e4, 1.0), None), seconds(91.76));
        assert_eq!(openmp("outer-dynamic", (50_000, 2e4, 1.0), None), Some(Report::Crashes));
        assert_eq!(openmp("outer-dynamic", (10_000, 1e7, 1.0), None), seconds(6.29));
        assert_eq!(openmp("outer-dynamic", (10_000, 2e4, 1024.0), None), seconds(64.01));
        assert_eq!(openmp("outer-dynamic", usual, Some(4)), seconds(18.28));
        assert_eq!(openmp("outer-dynamic", usual, Some(3)), None);
        assert_eq!(openmp("planned", usual, None), None);
        assert_eq!(openmp("outer-dynamic", (20_000, 1e7, 1.0), None), None);
        let cuda = |variant, scene| hard_discs(Workers::Device, variant, scene, None);
        assert_eq!(cuda("balanced-f32", (10_000, 1e7, 1.0)), seconds(0.821));
        assert_eq!(cuda("balanced-f32", (20_000, 2e4, 1.0)), seconds(2.583));
        assert_eq!(cuda("basic-f32", usual), None);
    }
}
