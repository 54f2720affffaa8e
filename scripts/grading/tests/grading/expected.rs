//! Expected results of submissions.

use std::collections::BTreeSet;

use serde_json::Value;

/// Expected result of a submission.
pub(crate) enum Expected {
    /// The submission loses exactly these tasks. The record names the files that were left out, and
    /// the provided files that were changed.
    Graded { lost: Vec<String>, left_out: &'static [&'static str], times: Times },
    /// Grading stops before there are marks.
    Ends { status: &'static str, message: String },
}

/// Expected grades of the times, if times were taken.
#[derive(Clone, Copy)]
pub(crate) enum Times {
    /// Any grades are accepted.
    Any,
    /// The times give no points.
    Nothing,
    /// The grade for speed is below this number, out of 100.
    Slow(f64),
}

/// Status of a submission that could not be read.
pub(crate) const UNREADABLE: &str = "unreadable";
/// Status of a submission with forbidden code.
pub(crate) const REFUSED: &str = "refused";
/// Status of a submission that does not compile.
pub(crate) const NOT_BUILT: &str = "not-built";
/// Status of a submission without any source of the lab.
pub(crate) const EMPTY: &str = "empty";

impl Expected {
    /// Expects all tasks to be right.
    pub(crate) fn full() -> Self {
        Self::loses(&[], Times::Any)
    }

    /// Expects these tasks to be wrong.
    pub(crate) fn loses(tasks: &[&str], times: Times) -> Self {
        let lost = tasks.iter().copied().map(String::from).collect();
        Self::Graded { lost, left_out: &[], times }
    }

    /// Expects no marks, for a reason that contains `message`.
    pub(crate) fn ends(status: &'static str, message: impl Into<String>) -> Self {
        Self::Ends { status, message: message.into() }
    }

    /// Describes how a record differs from the expected result; `None` if the record agrees with
    /// it.
    pub(crate) fn differs(&self, record: &Value) -> Option<&'static str> {
        match self {
            Self::Graded { .. } if record["status"] != "graded" => Some("not graded"),
            Self::Graded { lost, .. } if !alike(lost_tasks(record), lost) => Some("other marks"),
            Self::Graded { left_out, .. }
                if !left_out
                    .iter()
                    .all(|it| holds(&record["left_out"], it) || holds(&record["changed"], it)) =>
            {
                Some("a reason is missing")
            }
            Self::Graded { times, .. } => {
                let measures = record["measures"].as_array().into_iter().flatten();
                let mut measures = measures.filter(|measure| measure["grade"].is_number());
                measures.any(|measure| !times.allow(measure)).then_some("points for such times")
            }
            Self::Ends { status, .. } if record["status"] != *status => Some("another end"),
            Self::Ends { message, .. } if !holds(&record["message"], message) => {
                Some("another message")
            }
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

/// Whether a field of a record contains a text.
fn holds(field: &Value, text: &str) -> bool {
    field.to_string().contains(text)
}

/// Whether the tasks are equal, in any order.
fn alike<'a>(lost: impl Iterator<Item = &'a str>, expected: &'a [String]) -> bool {
    let expected: BTreeSet<&str> = expected.iter().map(String::as_str).collect();
    lost.collect::<BTreeSet<&str>>() == expected
}

/// Returns the tasks that a record lists as lost.
pub(crate) fn lost_tasks(record: &Value) -> impl Iterator<Item = &str> {
    let all = record["tasks"].as_array().into_iter().flatten();
    all.filter(|task| task["passed"] == false).filter_map(|task| task["id"].as_str())
}
