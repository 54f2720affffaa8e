//! The record of one graded submission.

mod by_hand;
mod stored;
mod times;

use std::collections::BTreeMap;

use jiff::Timestamp;
use serde::{Deserialize, Serialize};

use lab_kit::Lab;
use lab_kit::answers::RegionId;
use lab_measure::commands::contest::Entry;

pub(crate) use by_hand::{Attempt, Decision, Lateness};
pub(crate) use stored::{expect_lab, path, read, read_all, sort};
pub(crate) use times::{Kind, Measure, Outcome, Run, Verdict, Whose};

/// Number of the format of records. A record with a different number is refused.
pub(crate) const FORMAT: u8 = 1;

/// Record of one graded submission. Its JSON file has the fields of all parts in one object.
#[derive(Clone, Debug, Default, Deserialize, PartialEq, Serialize)]
#[serde(default)]
pub(crate) struct Record {
    /// Findings of the grading, which are final.
    #[serde(flatten)]
    pub(crate) found: Findings,
    /// Results of the tasks, with their points. They are sorted by task number when points are
    /// computed.
    pub(crate) tasks: Vec<Task>,
    /// Marks, which are computed from the other parts and can be recomputed.
    #[serde(flatten)]
    pub(crate) marked: Marked,
}

/// Findings about a submission: its files, the settings of its grading, and its times.
///
/// They are written only when the submission is judged and timed.
#[derive(Clone, Debug, Default, Deserialize, PartialEq, Serialize)]
#[serde(default)]
pub(crate) struct Findings {
    /// Format of the record, which is [`FORMAT`].
    pub(crate) format: u8,
    /// Name of the submission: the name of its archive or folder.
    pub(crate) name: String,
    /// Number of the lab.
    pub(crate) lab: Lab,
    /// Stage that grading reached.
    pub(crate) status: Status,
    /// Reason why grading stopped, such as a compiler error; empty if it did not stop.
    pub(crate) message: String,
    /// SHA-256 of all accepted sources and their paths.
    pub(crate) hash: String,
    /// SHA-256 of each accepted source, by its path below the lab's folder.
    pub(crate) files: BTreeMap<String, String>,
    /// Files that were not accepted, with the reasons.
    pub(crate) left_out: Vec<LeftOut>,
    /// Provided files that the student changed. The kit's versions were compiled instead.
    pub(crate) changed: Vec<String>,
    /// SHA-256 of the grader's files: questions, snapshots, oracle, solution.
    pub(crate) grader: String,
    /// Seed of the questions' inputs.
    pub(crate) seed: u64,
    /// Compiler, as `rustc --version` prints it.
    pub(crate) toolchain: String,
    /// Processor and number of cores of the machine.
    pub(crate) machine: String,
    /// Whether the submission ran in a sandbox.
    pub(crate) sandboxed: bool,
    /// Whether the submission was to be timed.
    pub(crate) timed: bool,
    /// Timed runs, exactly as they were measured. Measures are computed from the runs and can be
    /// recomputed.
    pub(crate) runs: Vec<Run>,
    /// Entry in the contest, as it was measured; `None` if the lab has no contest.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) contest: Option<Entry>,
}

/// Marks of a submission, and the decisions that they depend on.
///
/// The decisions depend on the class's roster, on the time of the hand-in, and on the staff.
#[derive(Clone, Debug, Default, Deserialize, PartialEq, Serialize)]
#[serde(default)]
pub(crate) struct Marked {
    /// Measures of the times, with their grades.
    pub(crate) measures: Vec<Measure>,
    /// Time of the hand-in: the modification time of the submitted file.
    pub(crate) handed_in: Option<Timestamp>,
    /// Lateness; `None` if the submission was in time.
    pub(crate) late: Option<Lateness>,
    /// Decisions by a person.
    pub(crate) by_hand: Vec<Decision>,
    /// Whether this submission determines its student's mark.
    pub(crate) attempt: Attempt,
    /// Name of the student in the roster; `None` if there is no roster.
    pub(crate) student: Option<String>,
    /// Pseudonym that graders see instead of names.
    pub(crate) pseudonym: Option<String>,
    /// Points of all tasks and all measures.
    pub(crate) points: f64,
    /// Largest possible number of points, including the points of measures without a grade.
    pub(crate) out_of: f64,
}

/// Stage that the grading of a submission reached.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum Status {
    /// The submission could not be read.
    Unreadable,
    /// The submission has no source of this lab.
    Empty,
    /// A source contains forbidden code.
    Refused,
    /// The submission does not compile.
    NotBuilt,
    /// The grader failed. The next grading run tries again.
    Failed,
    /// The tasks were judged.
    #[default]
    Graded,
}

/// A file that was not accepted.
#[derive(Clone, Debug, Deserialize, PartialEq, Eq, Serialize)]
pub(crate) struct LeftOut {
    /// Path of the file, with replacements for bytes that are not UTF-8.
    pub(crate) path: String,
    /// Reason why the file was not accepted.
    pub(crate) reason: String,
}

/// Result of a task. It depends only on the answers to the task's questions.
#[derive(Clone, Debug, Default, Deserialize, PartialEq, Serialize)]
pub(crate) struct Task {
    /// Number of the task, such as `1.3`.
    pub(crate) id: String,
    /// Whether all answers were right.
    pub(crate) passed: bool,
    /// Share of the answers that were right, from 0 to 1.
    #[serde(default)]
    pub(crate) share: f64,
    /// First mistake; empty if there was none.
    pub(crate) message: String,
    /// Points of the submission in this task.
    pub(crate) points: f64,
    /// Points that the task is worth.
    pub(crate) out_of: f64,
}

/// Parses a task's number, for sorting; `None` if the text is not the number of a task.
pub(crate) fn number(id: &str) -> Option<lab_kit::answers::Task> {
    id.parse::<RegionId>().ok().map(|id| id.task)
}

impl Record {
    /// Returns the record as a page shows it: under its pseudonym, or else under its student's
    /// name.
    pub(crate) fn shown(&self) -> Self {
        let Self { found, marked, .. } = self;
        let mut shown = self.clone();
        if let Some(pseudonym) = &marked.pseudonym {
            shown.found.message = found.message.replace(&found.name, pseudonym);
        }
        let name = marked.pseudonym.as_ref().or(marked.student.as_ref());
        shown.found.name = name.unwrap_or(&found.name).clone();
        shown
    }

    /// Returns the points that the tasks are worth, plus the points of the measures that `among`
    /// accepts.
    pub(crate) fn worth(&self, among: impl Fn(&Measure) -> bool) -> f64 {
        let measures = self.marked.measures.iter().filter(|measure| among(measure));
        let measures: f64 = measures.map(|measure| measure.out_of).sum();
        self.tasks.iter().map(|task| task.out_of).sum::<f64>() + measures
    }

    /// Returns the points of measures that could not be judged; 0 if the submission has no program.
    pub(crate) fn open_points(&self) -> f64 {
        if self.found.status != Status::Graded {
            return 0.0;
        }
        let open = self.marked.measures.iter().filter(|measure| !measure.counts());
        open.map(|measure| measure.out_of).fold(0.0, |sum, points| sum + points)
    }
}

/// Returns the maximum number of points in a class. The points of timed measures without a grade
/// are included.
pub(crate) fn scale(records: &[Record]) -> f64 {
    let worth = records.iter().map(|it| it.worth(|one| one.verdict != Verdict::NotTimed));
    let most = worth.fold(0.0, f64::max);
    if most > 0.0 { most } else { 1.0 }
}

/// Formats points as people write them: 15, 7.5, 12.36.
pub(crate) fn points(points: f64) -> String {
    let text = format!("{points:.2}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

#[cfg(test)]
impl Record {
    /// Returns the record of Ada, who has solved one of two tasks of lab 1.
    pub(crate) fn sample() -> Self {
        serde_json::from_str(include_str!("../../tests/record.json")).unwrap()
    }

    /// Returns Ada's record under another name.
    pub(crate) fn sample_called(name: &str) -> Self {
        let mut record = Self::sample();
        record.found.name = name.to_owned();
        record
    }

    /// Returns Ada's record with a speed measure: she has 0 of its 25 points.
    pub(crate) fn sample_of_speed(verdict: Verdict) -> Self {
        let mut record = Self::sample();
        record.marked.measures.push(Measure {
            kind: Kind::Speed,
            variant: "sorted".into(),
            verdict,
            message: String::new(),
            grade: None,
            points: 0.0,
            out_of: 25.0,
        });
        record
    }
}

#[cfg(test)]
mod tests {
    use super::Record;

    #[test]
    fn the_fields_of_all_parts_are_side_by_side_in_the_file() {
        let record = Record::sample();
        let file = serde_json::to_value(&record).unwrap();
        for field in ["format", "name", "seed", "runs", "tasks", "measures", "by_hand", "points"] {
            assert!(file.get(field).is_some(), "{field}");
        }
        assert_eq!(file.as_object().unwrap().len(), 26);
        assert_eq!(serde_json::from_value::<Record>(file).unwrap(), record);
    }
}
