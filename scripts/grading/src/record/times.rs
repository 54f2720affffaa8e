//! Timed runs, and the grades of their times.

use serde::{Deserialize, Serialize};

/// The repeated timings (takes) of one program on scenes of one size.
///
/// A take lasts, by the grader's clock, from the sending of the scene until the program's last
/// particle has arrived.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub(crate) struct Run {
    /// Owner of the program.
    pub(crate) whose: Whose,
    /// Name of the program in the lab.
    pub(crate) variant: String,
    /// Number of particles.
    pub(crate) n: usize,
    /// Number of workers: threads or ranks.
    pub(crate) workers: usize,
    /// Number of time steps. A run with 0 steps measures the time for making a scene and sending
    /// the result.
    pub(crate) steps: u64,
    /// Seconds of each take.
    pub(crate) seconds: Vec<f64>,
    /// Processor time of all takes, in seconds; `None` if the system does not report it.
    pub(crate) processors: Option<f64>,
    /// Whether the times are valid.
    pub(crate) outcome: Outcome,
    /// Reason why the times are not valid; empty if they are.
    pub(crate) message: String,
}

impl Run {
    /// Makes a run without takes.
    pub(crate) fn planned(
        whose: Whose,
        variant: &str,
        n: usize,
        workers: usize,
        steps: u64,
    ) -> Self {
        Self {
            whose,
            variant: variant.to_owned(),
            n,
            workers,
            steps,
            seconds: Vec::new(),
            processors: Some(0.0),
            outcome: Outcome::Timed,
            message: String::new(),
        }
    }
}

/// Outcome of a run.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum Outcome {
    /// Every take had the right result.
    Timed,
    /// A take exceeded its time limit. The last of `seconds` is this limit.
    TooSlow,
    /// A take had no result or a wrong result.
    Wrong,
}

/// Owner of a program.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum Whose {
    /// The submission.
    Own,
    /// The solution.
    Solution,
    /// The best serial program of earlier labs.
    Serial,
}

/// The grade of a measure that is computed from times.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub(crate) struct Measure {
    /// Kind of the measure.
    pub(crate) kind: Kind,
    /// Name of the program in the lab.
    pub(crate) variant: String,
    /// Whether the measure could be graded.
    pub(crate) verdict: Verdict,
    /// The measurement in words, or the reason why there is no grade.
    pub(crate) message: String,
    /// Grade from 0 to 100; `None` if there is none.
    pub(crate) grade: Option<f64>,
    /// Points of the submission.
    pub(crate) points: f64,
    /// Points that the measure is worth. Until the measure is graded, these points are neither
    /// earned nor lost.
    pub(crate) out_of: f64,
}

/// Kind of a measure.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum Kind {
    /// Growth of the time with the number of particles.
    Complexity,
    /// Speedup with more workers.
    Scaling,
    /// Time relative to the solution's time.
    Speed,
}

/// Whether a measure could be graded.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum Verdict {
    /// The measure is graded.
    Graded,
    /// The program's result was wrong, so its time gives no points.
    Wrong,
    /// The repeated timings differ too much from each other.
    TooNoisy,
    /// The program was not timed.
    NotTimed,
}

impl Measure {
    /// Whether the measure is graded. If not, its points are neither earned nor lost.
    pub(crate) fn counts(&self) -> bool {
        matches!(self.verdict, Verdict::Graded | Verdict::Wrong)
    }
}

impl Kind {
    /// Returns the name of the kind.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Complexity => "complexity",
            Self::Scaling => "scaling",
            Self::Speed => "speed",
        }
    }
}
