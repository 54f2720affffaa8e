//! What the course reports printed, to be shown beside what is measured here.
//!
//! All are seconds for 1,000 steps of the soft discs, except CS3210's, which are seconds for 50
//! steps of 10,000 hard discs.

use super::rubric::{strong_efficiency, weak_efficiency};

/// Steps of a run of soft discs in the reports.
pub(crate) const SOFT_STEPS: f64 = 1000.0;

/// Steps of a run of hard discs in the report.
pub(crate) const HARD_STEPS: f64 = 50.0;

/// Seconds against the number of particles.
#[derive(Debug)]
pub(crate) struct Growth {
    pub(crate) name: &'static str,
    /// (n, seconds).
    pub(crate) points: &'static [(f64, f64)],
}

/// Seconds against the number of workers.
#[derive(Debug)]
pub(crate) struct Scaling {
    pub(crate) name: &'static str,
    /// Seconds of the serial program on the scene of the strong scaling.
    serial: f64,
    /// (workers, seconds), on one scene.
    strong: &'static [(usize, f64)],
    /// (workers, seconds), on a scene that grows with the workers; may be empty.
    weak: &'static [(usize, f64)],
}

impl Scaling {
    /// The numbers of workers.
    pub(crate) fn workers(&self) -> impl Iterator<Item = f64> {
        self.strong.iter().map(|&(p, _)| p as f64)
    }

    /// Serial time over parallel time.
    pub(crate) fn speedups(&self) -> Vec<f64> {
        self.strong.iter().map(|&(_, t)| self.serial / t).collect()
    }

    /// Strong efficiency for each number of workers.
    pub(crate) fn strong_efficiencies(&self) -> Vec<f64> {
        self.strong.iter().map(|&(p, t)| strong_efficiency(self.serial, p, t)).collect()
    }

    /// Weak efficiency for each number of workers; its scene for one worker is the strong one's.
    pub(crate) fn weak_efficiencies(&self) -> Vec<f64> {
        self.weak.iter().map(|&(_, t)| weak_efficiency(self.serial, t)).collect()
    }
}

pub(crate) static CSC581_SERIAL: Growth = Growth {
    name: "CSC581 §3.4, serial",
    points: &[
        (500.0, 0.07854),
        (1000.0, 0.162432),
        (2000.0, 0.338598),
        (4000.0, 0.701901),
        (8000.0, 1.50626),
    ],
};

pub(crate) static CSC581_OPENMP: Scaling = Scaling {
    name: "CSC581 §4.2, OpenMP",
    serial: 0.08331,
    strong: &[(1, 0.086536), (2, 0.051989), (4, 0.041003), (8, 0.035748), (16, 0.032117)],
    weak: &[(1, 0.086536), (2, 0.094091), (4, 0.130803), (8, 0.177745), (16, 0.394284)],
};

pub(crate) static CSC581_MPI: Scaling = Scaling {
    name: "CSC581 §5.2, MPI",
    serial: 0.078272,
    strong: &[(1, 0.102531), (2, 0.056528), (4, 0.049255), (8, 0.050913), (16, 0.05004)],
    weak: &[(1, 0.102531), (2, 0.121643), (4, 0.186784), (8, 0.256663), (16, 0.334702)],
};

pub(crate) static CSC367_SERIAL: Growth = Growth {
    name: "CSC367 Table 1, serial",
    points: &[
        (500.0, 0.030393),
        (1000.0, 0.05855),
        (1500.0, 0.088162),
        (2000.0, 0.11771),
        (3000.0, 0.178473),
        (4000.0, 0.239568),
        (6000.0, 0.365514),
        (8000.0, 0.491129),
        (10_000.0, 0.619183),
        (20_000.0, 1.25964),
        (40_000.0, 2.60111),
        (80_000.0, 5.10243),
        (160_000.0, 10.4678),
    ],
};

pub(crate) static CS267_PRELIMINARY: Growth = Growth {
    name: "CS267 Table 1, preliminary",
    points: &[
        (500.0, 0.459),
        (1000.0, 0.918),
        (2000.0, 1.900),
        (3000.0, 2.946),
        (4000.0, 4.047),
        (5000.0, 5.161),
        (10_000.0, 10.888),
        (15_000.0, 16.569),
        (20_000.0, 22.362),
        (25_000.0, 28.110),
        (50_000.0, 58.169),
        (100_000.0, 119.722),
        (125_000.0, 153.117),
        (150_000.0, 183.293),
        (200_000.0, 246.894),
        (225_000.0, 295.802),
        (250_000.0, 328.120),
        (500_000.0, 974.418),
    ],
};

pub(crate) static CS267_FINAL: Growth = Growth {
    name: "CS267 Table 1, final",
    points: &[
        (500.0, 0.109),
        (1000.0, 0.232),
        (2000.0, 0.497),
        (3000.0, 0.842),
        (4000.0, 1.279),
        (5000.0, 1.545),
        (10_000.0, 3.622),
        (15_000.0, 5.266),
        (20_000.0, 7.685),
        (25_000.0, 9.436),
        (50_000.0, 20.554),
        (100_000.0, 41.236),
        (125_000.0, 54.758),
        (150_000.0, 67.827),
        (200_000.0, 92.731),
        (225_000.0, 104.014),
        (250_000.0, 123.786),
        (500_000.0, 340.213),
    ],
};

pub(crate) static CS267_4_THREADS: Growth = Growth {
    name: "CS267 Table 2, 4 threads",
    points: &[
        (500.0, 0.189),
        (1000.0, 0.296),
        (2000.0, 0.609),
        (3000.0, 0.960),
        (4000.0, 1.291),
        (5000.0, 1.643),
        (10_000.0, 3.483),
        (20_000.0, 6.992),
        (25_000.0, 8.763),
        (50_000.0, 18.012),
        (100_000.0, 37.178),
        (125_000.0, 46.995),
        (150_000.0, 56.708),
        (200_000.0, 77.157),
        (225_000.0, 88.162),
        (250_000.0, 97.676),
        (500_000.0, 269.298),
    ],
};

pub(crate) static CS267_16_THREADS: Growth = Growth {
    name: "CS267 Table 2, 16 threads",
    points: &[
        (500.0, 0.086),
        (1000.0, 0.139),
        (2000.0, 0.237),
        (3000.0, 0.359),
        (4000.0, 0.420),
        (5000.0, 0.529),
        (10_000.0, 1.067),
        (20_000.0, 2.073),
        (25_000.0, 2.617),
        (50_000.0, 5.295),
        (100_000.0, 10.939),
        (125_000.0, 13.857),
        (150_000.0, 16.745),
        (200_000.0, 22.219),
        (225_000.0, 25.219),
        (250_000.0, 28.203),
        (500_000.0, 73.499),
    ],
};

pub(crate) static CS267_32_THREADS: Growth = Growth {
    name: "CS267 Table 2, 32 threads",
    points: &[
        (500.0, 0.097),
        (1000.0, 0.119),
        (2000.0, 0.155),
        (3000.0, 0.258),
        (4000.0, 0.323),
        (5000.0, 0.383),
        (10_000.0, 0.698),
        (20_000.0, 1.386),
        (25_000.0, 1.709),
        (50_000.0, 3.508),
        (100_000.0, 7.200),
        (125_000.0, 9.134),
        (150_000.0, 10.962),
        (200_000.0, 14.906),
        (225_000.0, 17.003),
        (250_000.0, 19.061),
        (500_000.0, 47.586),
    ],
};

pub(crate) static CS3210_OPENMP: Scaling = Scaling {
    name: "CS3210 Table 6, OpenMP",
    serial: 43.35,
    strong: &[
        (1, 43.35),
        (2, 28.44),
        (4, 18.28),
        (8, 11.26),
        (16, 7.3),
        (20, 6.23),
        (32, 6.19),
        (64, 6.29),
        (128, 6.38),
    ],
    weak: &[],
};

/// The report's serial program needs 41.94 s (its Table 7); one of the processes is the master.
pub(crate) static CS3210_MPI: Scaling = Scaling {
    name: "CS3210 §5.2.1, MPI",
    serial: 41.94,
    strong: &[
        (2, 44.964),
        (3, 57.775),
        (4, 26.48),
        (8, 13.419),
        (16, 5.884),
        (32, 9.151),
        (64, 12.904),
    ],
    weak: &[],
};

pub(crate) static CS3210_OPENMP_GROWTH: Growth = Growth {
    name: "CS3210 Table 15, OpenMP, 20 threads",
    points: &[
        (5000.0, 1.7),
        (10_000.0, 6.23),
        (20_000.0, 23.82),
        (30_000.0, 52.6),
        (40_000.0, 91.76),
    ],
};

pub(crate) static CS3210_CUDA_GROWTH: Growth = Growth {
    name: "CS3210 Table 15, CUDA",
    points: &[
        (5000.0, 0.394),
        (10_000.0, 0.847),
        (20_000.0, 2.583),
        (30_000.0, 5.492),
        (40_000.0, 9.35),
    ],
};

pub(crate) static CS3210_MPI_GROWTH: Growth = Growth {
    name: "CS3210 Table 15, MPI, 16 processes",
    points: &[
        (5000.0, 1.697),
        (10_000.0, 5.884),
        (20_000.0, 23.688),
        (30_000.0, 52.039),
        (40_000.0, 91.078),
    ],
};

/// What the CS3210 report has for a run of [`HARD_STEPS`] steps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Report {
    /// The shortest of three takes.
    Seconds(f64),
    /// Its program died of a segmentation fault.
    Crashes,
}

/// Table 2 and Table 7: seconds of the report's programs on 10,000 discs, by our variants' names.
static CS3210_VARIANTS: [(&str, f64); 8] = [
    ("sequential", 41.94),
    ("outer-static", 10.65),
    ("inner-static", 8.51),
    ("nested-dynamic", 464.6),
    ("outer-dynamic", 6.24),
    ("inner-dynamic", 94.24),
    ("grid", 30.84),
    ("grid-parallel", 6.9),
];

static CS3210_OPENMP_LENGTH: &[(f64, f64)] =
    &[(5e3, 6.23), (1e4, 6.2), (2e4, 6.23), (1e5, 6.19), (1e6, 6.3), (1e7, 6.29)];

static CS3210_MPI_LENGTH: &[(f64, f64)] =
    &[(5e3, 6.232), (1e4, 6.154), (2e4, 5.884), (1e5, 5.684), (1e6, 7.72), (1e7, 7.227)];

static CS3210_OPENMP_RADIUS: &[(f64, f64)] = &[
    (1.0, 6.23),
    (4.0, 6.13),
    (64.0, 8.72),
    (128.0, 9.33),
    (256.0, 13.89),
    (512.0, 29.2),
    (1024.0, 64.01),
];

static CS3210_MPI_RADIUS: &[(f64, f64)] = &[
    (1.0, 5.884),
    (4.0, 6.162),
    (64.0, 7.666),
    (128.0, 10.444),
    (256.0, 14.891),
    (512.0, 27.462),
    (1024.0, 52.795),
];

/// What the report has for one of its programs: `lab` 7 for OpenMP, 8 for MPI; a scene (N, L, r);
/// the number of workers where that is what varies. Its own sweeps ran on 20 threads or 16
/// processes, its Table 2 on 20 threads.
pub(crate) fn hard_discs(
    lab: u8,
    variant: &str,
    (n, side, radius): (usize, f64, f64),
    workers: Option<usize>,
) -> Option<Report> {
    let (swept, by_n, by_side, by_radius, by_workers) = match (lab, variant) {
        (7, _) => (
            "outer-dynamic",
            &CS3210_OPENMP_GROWTH,
            CS3210_OPENMP_LENGTH,
            CS3210_OPENMP_RADIUS,
            &CS3210_OPENMP,
        ),
        (8, _) => (
            "master-workers",
            &CS3210_MPI_GROWTH,
            CS3210_MPI_LENGTH,
            CS3210_MPI_RADIUS,
            &CS3210_MPI,
        ),
        _ => return None,
    };
    let of = |points: &[(f64, f64)], x: f64| {
        points.iter().find(|point| point.0 == x).map(|point| Report::Seconds(point.1))
    };
    let usual = (n == 10_000, side == 2e4, radius == 1.0);
    if let Some(workers) = workers {
        let strong = by_workers.strong.iter().find(|(p, _)| *p == workers);
        let there = usual == (true, true, true) && variant == swept;
        return strong.filter(|_| there).map(|&(_, seconds)| Report::Seconds(seconds));
    }
    if usual == (true, true, true) && lab == 7 {
        return of_variant(variant);
    }
    if variant != swept {
        return None;
    }
    match usual {
        (_, true, true) if n == 50_000 => Some(Report::Crashes),
        (_, true, true) => of(by_n.points, n as f64),
        (true, _, true) => of(by_side, side),
        (true, true, _) => of(by_radius, radius),
        _ => None,
    }
}

fn of_variant(variant: &str) -> Option<Report> {
    let found = CS3210_VARIANTS.iter().find(|(name, _)| *name == variant);
    found.map(|&(_, seconds)| Report::Seconds(seconds))
}

#[cfg(test)]
mod tests {
    use super::{Report, hard_discs};

    #[test]
    fn the_report_is_found_for_its_own_scenes_only() {
        let openmp = |variant, scene, workers| hard_discs(7, variant, scene, workers);
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
        assert_eq!(hard_discs(2, "sorted", usual, None), None);
    }
}
