//! What was timed, and what it is worth.

use serde::{Deserialize, Serialize};

/// The takes of one program on scenes of one size. The grader's clock timed them, from the moment
/// when the program heard of the scene to the moment when its last particle had come back.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub(crate) struct Run {
    /// Whose program.
    pub(crate) whose: Whose,
    /// Which program of the lab.
    pub(crate) variant: String,
    /// Particles.
    pub(crate) n: usize,
    /// Threads.
    pub(crate) workers: usize,
    /// Time steps; none shows what it takes to make a scene and to send the result.
    pub(crate) steps: u64,
    /// Seconds of each take.
    pub(crate) seconds: Vec<f64>,
    /// Seconds of processors in all takes; none where the system does not say.
    pub(crate) processors: Option<f64>,
    /// Whether these times say anything.
    pub(crate) outcome: Outcome,
    /// Why they do not; empty if they do.
    pub(crate) message: String,
}

impl Run {
    /// Without any take yet.
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

/// How runs ended.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum Outcome {
    /// With the right result, every time.
    Timed,
    /// Not within the time that is allowed, the last of `seconds`.
    TooSlow,
    /// With none or with a wrong one.
    Wrong,
}

/// Whose program runs.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum Whose {
    /// The submission's.
    Own,
    /// The solution's.
    Solution,
    /// The best serial program of the labs before.
    Serial,
}

/// What times are worth.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub(crate) struct Measure {
    /// Which measure.
    pub(crate) kind: Kind,
    /// Which program of the lab.
    pub(crate) variant: String,
    /// Whether it could be graded.
    pub(crate) verdict: Verdict,
    /// What was measured, or why it is not graded, in words.
    pub(crate) message: String,
    /// 0 to 100; none if it is not graded.
    pub(crate) grade: Option<f64>,
    /// Points given.
    pub(crate) points: f64,
    /// Points that could be had. They are open as long as it is not graded.
    pub(crate) out_of: f64,
}

/// What is measured.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum Kind {
    /// How the time grows with the number of particles.
    Complexity,
    /// What more workers bring.
    Scaling,
    /// How long it takes beside the solution.
    Speed,
}

/// Whether times could be judged.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum Verdict {
    /// Yes.
    Graded,
    /// The program did not compute what it should, so its time is worth nothing.
    Wrong,
    /// The takes differ too much from each other.
    TooNoisy,
    /// Nobody timed it.
    NotTimed,
}

impl Measure {
    /// Whether it is graded; else its points are open.
    pub(crate) fn counts(&self) -> bool {
        matches!(self.verdict, Verdict::Graded | Verdict::Wrong)
    }
}

impl Kind {
    /// As it is called.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Complexity => "complexity",
            Self::Scaling => "scaling",
            Self::Speed => "speed",
        }
    }
}
