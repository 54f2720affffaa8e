//! What must come of a submission.

use std::collections::BTreeSet;

use serde_json::Value;

/// What must come of it.
pub(crate) enum Expected {
    /// It loses these tasks and no others; of what was not taken, and of the given files that were changed, it
    /// is said so.
    Graded { lost: Vec<String>, left_out: &'static [&'static str], times: Times },
    /// It does not come to marks.
    Ends { status: &'static str, message: String },
}

/// What its times must be worth, if they were taken.
#[derive(Clone, Copy)]
pub(crate) enum Times {
    /// Whatever they are.
    Any,
    /// No points.
    Nothing,
    /// Less than this grade for speed, of 100.
    Slow(f64),
}

/// It could not be read.
pub(crate) const UNREADABLE: &str = "unreadable";
/// It says what no source may say.
pub(crate) const REFUSED: &str = "refused";
/// It does not compile.
pub(crate) const NOT_BUILT: &str = "not-built";
/// It holds nothing of the lab.
pub(crate) const EMPTY: &str = "empty";

impl Expected {
    /// Right in every task.
    pub(crate) fn full() -> Self {
        Self::loses(&[], Times::Any)
    }

    /// Wrong in these tasks.
    pub(crate) fn loses(tasks: &[&str], times: Times) -> Self {
        let lost = tasks.iter().copied().map(String::from).collect();
        Self::Graded { lost, left_out: &[], times }
    }

    /// No marks, for a reason that contains `message`.
    pub(crate) fn ends(status: &'static str, message: impl Into<String>) -> Self {
        Self::Ends { status, message: message.into() }
    }

    /// How a record differs from it, if it does.
    pub(crate) fn differs(&self, record: &Value) -> Option<&'static str> {
        let holds = |field: &str, text: &str| record[field].to_string().contains(text);
        match self {
            Self::Graded { .. } if record["status"] != "graded" => Some("not graded"),
            Self::Graded { lost, .. } if !alike(lost_tasks(record), lost) => Some("other marks"),
            Self::Graded { left_out, .. }
                if !left_out.iter().all(|t| holds("left_out", t) || holds("changed", t)) =>
            {
                Some("a reason is missing")
            }
            Self::Graded { times, .. } => {
                let measures = record["measures"].as_array().into_iter().flatten();
                let mut measures = measures.filter(|measure| measure["grade"].is_number());
                measures.any(|measure| !times.allow(measure)).then_some("points for such times")
            }
            Self::Ends { status, .. } if record["status"] != *status => Some("another end"),
            Self::Ends { message, .. } if !holds("message", message) => Some("another message"),
            Self::Ends { .. } => (record["points"] != 0.0).then_some("marks"),
        }
    }
}

impl Times {
    fn allow(self, measure: &Value) -> bool {
        let grade = measure["grade"].as_f64().unwrap_or_default();
        match self {
            Self::Any => true,
            Self::Nothing => grade == 0.0,
            Self::Slow(most) => measure["kind"] != "speed" || grade < most,
        }
    }
}

/// Whether the tasks are the same, in any order.
fn alike<'a>(lost: impl Iterator<Item = &'a str>, expected: &'a [String]) -> bool {
    let expected: BTreeSet<&str> = expected.iter().map(String::as_str).collect();
    lost.collect::<BTreeSet<&str>>() == expected
}

/// The tasks that a record says are lost.
pub(crate) fn lost_tasks(record: &Value) -> impl Iterator<Item = &str> {
    let all = record["tasks"].as_array().into_iter().flatten();
    all.filter(|task| task["passed"] == false).filter_map(|task| task["id"].as_str())
}
