//! Numbers that the CS3210 report printed for runs of hard discs.

use lab_kit::Workers;
use serde::Serialize;

use super::published::{growth, scaling, swept};

/// A number of the CS3210 report for a run of [`HARD_STEPS`](crate::published::HARD_STEPS) steps, in
/// seconds unless it is scaled.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Printed {
    /// The report's program ended with a segmentation fault.
    Crashes,
    /// The shortest of three takes.
    #[serde(untagged)]
    Seconds(f64),
}

impl Printed {
    /// Converts the number to another unit.
    pub(crate) fn scaled(self, scale: f64) -> Self {
        match self {
            Self::Seconds(seconds) => Self::Seconds(seconds * scale),
            Self::Crashes => Self::Crashes,
        }
    }
}

/// Finds the report's number for one of its programs and a scene (N, L, r); `None` if it has none.
///
/// A program runs with threads (OpenMP), ranks (MPI) or a device (CUDA). `workers` is the number of
/// workers if it varies. Other runs of the report used 20 threads or 16 processes, and its Table 2
/// used 20 threads.
pub(crate) fn hard_discs(
    with: Workers,
    variant: &str,
    (n, side, radius): (usize, f64, f64),
    workers: Option<usize>,
) -> Option<Printed> {
    let (name, by_n) = match with {
        Workers::Threads => ("threads", "cs3210-openmp-growth"),
        Workers::Ranks => ("ranks", "cs3210-mpi-growth"),
        Workers::Device => ("device", "cs3210-cuda-growth"),
    };
    let swept = swept(name);
    let is_its_own = variant == swept.variant;
    let usual = (n == 10_000, side == 2e4, radius == 1.0);
    let seconds = match (usual, workers) {
        ((true, true, true), Some(workers)) if is_its_own => {
            let by_workers = match with {
                Workers::Threads => "cs3210-openmp",
                Workers::Ranks => "cs3210-mpi",
                Workers::Device => return None,
            };
            scaling(by_workers).strong.iter().find(|(p, _)| *p == workers).map(|point| point.1)
        }
        (_, Some(_)) => None,
        ((true, true, true), None) if !swept.variants.is_empty() => {
            swept.variants.get(variant).copied()
        }
        _ if !is_its_own => None,
        ((_, true, true), None) if n == 50_000 => return Some(Printed::Crashes),
        ((_, true, true), None) => at(&growth(by_n).points, n as f64),
        ((true, _, true), None) => at(&swept.by_side, side),
        ((true, true, _), None) => at(&swept.by_radius, radius),
        _ => None,
    };
    seconds.map(Printed::Seconds)
}

/// Returns y at this x; `None` if there is no such point.
fn at(points: &[(f64, f64)], x: f64) -> Option<f64> {
    points.iter().find(|point| point.0 == x).map(|point| point.1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_report_is_found_for_its_own_scenes_only() {
        let usual = (10_000, 2e4, 1.0);
        for (variant, scene, workers, printed) in [
            ("grid", usual, None, Some(30.84)),
            ("outer-dynamic", (40_000, 2e4, 1.0), None, Some(91.76)),
            ("outer-dynamic", (10_000, 1e7, 1.0), None, Some(6.29)),
            ("outer-dynamic", (10_000, 2e4, 1024.0), None, Some(64.01)),
            ("outer-dynamic", usual, Some(4), Some(18.28)),
            ("outer-dynamic", usual, Some(3), None),
            ("planned", usual, None, None),
            ("outer-dynamic", (20_000, 1e7, 1.0), None, None),
        ] {
            let found = hard_discs(Workers::Threads, variant, scene, workers);
            assert_eq!(found, printed.map(Printed::Seconds), "{variant} {scene:?}");
        }
        let many = hard_discs(Workers::Threads, "outer-dynamic", (50_000, 2e4, 1.0), None);
        assert_eq!(many, Some(Printed::Crashes));
        for (variant, scene, printed) in [
            ("balanced-f32", (10_000, 1e7, 1.0), Some(0.821)),
            ("balanced-f32", (20_000, 2e4, 1.0), Some(2.583)),
            ("basic-f32", usual, None),
        ] {
            let found = hard_discs(Workers::Device, variant, scene, None);
            assert_eq!(found, printed.map(Printed::Seconds), "{variant} {scene:?}");
        }
    }
}
