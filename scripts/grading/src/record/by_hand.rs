//! Decisions of the staff about a submission, and its lateness.

use anyhow::{Context, Result, ensure};
use serde::{Deserialize, Serialize};

use super::{Record, Status};
use lab_kit::Facts;

/// A person's decision, which overrides the grader: an `[[override]]` of `class.toml`.
///
/// In a record, a decision has neither `student` nor `days`, because the record has its own fields
/// for both.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Decision {
    /// A submission, or a student of the roster.
    #[serde(default, skip_serializing)]
    pub(crate) student: String,
    /// A task or a measure; `None` for the whole submission.
    pub(crate) task: Option<String>,
    /// Points that replace the grader's points; `None` if the decision is only a comment.
    pub(crate) points: Option<f64>,
    /// Number of days late, which replaces the number that the grader computes from the hand-in
    /// time.
    #[serde(default, skip_serializing)]
    pub(crate) days: Option<u32>,
    /// Reason that the student reads.
    pub(crate) reason: String,
}

/// Largest number of points that a person can give a submission. Labs are worth about a hundred, so
/// a larger number is a mistake.
const MOST: f64 = 1000.0;

impl Decision {
    /// Checks that the task exists and that it is worth at least the decided points.
    pub(crate) fn check(&self, rubric: &Facts) -> Result<()> {
        ensure!(!self.reason.trim().is_empty(), "it has no reason");
        ensure!(!self.student.is_empty(), "it names no student");
        ensure!(self.days.is_none() || self.task.is_none(), "days are of a submission, not a task");
        let most = match &self.task {
            None => MOST,
            Some(task) => worth(rubric, task)
                .with_context(|| format!("there is no task or measure {task}"))?,
        };
        if let Some(points) = self.points {
            let can_be = points.is_finite() && (0.0..=most).contains(&points);
            // 1e308 has 309 digits.
            let shown = if points < 1e9 { points.to_string() } else { format!("{points:e}") };
            ensure!(can_be, "{shown} points cannot be given where there are {most}");
        }
        Ok(())
    }
}

/// Returns the points that a task or a measure is worth; `None` if it does not exist.
fn worth(rubric: &Facts, task: &str) -> Option<f64> {
    let timed = match task {
        "complexity" => &rubric.complexity,
        "scaling" => &rubric.scaling,
        "speed" => &rubric.speed,
        _ => return Some(rubric.tasks.get(task)?.points),
    };
    Some(timed.as_ref()?.points)
}

/// Lateness of a submission.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub(crate) struct Lateness {
    /// Days late; a day that has begun counts.
    pub(crate) days: u32,
    /// Share of the points that is lost, 0 to 1.
    pub(crate) lost: f64,
}

/// Whether a submission determines its student's mark.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum Attempt {
    /// The submission counts if it has a mark.
    #[default]
    Counts,
    /// Another submission of the student counts.
    Another,
    /// The student has several submissions, and `class.toml` does not say which one counts.
    Undecided,
}

impl Lateness {
    /// Formats the days: `a day`, `3 days`.
    pub(crate) fn days(&self) -> String {
        if self.days == 1 { "a day".to_owned() } else { format!("{} days", self.days) }
    }
}

impl Record {
    /// Returns the decisions about a task or a measure; with `None`, about the whole submission.
    pub(crate) fn decided<'a>(
        &'a self,
        task: Option<&'a str>,
    ) -> impl Iterator<Item = &'a Decision> {
        self.marked.by_hand.iter().filter(move |decision| decision.task.as_deref() == task)
    }

    /// Whether the grader could mark the submission, or a person gave points for it.
    pub(crate) fn has_mark(&self) -> bool {
        let nothing =
            matches!(self.found.status, Status::Unreadable | Status::Empty | Status::Failed);
        !nothing || self.decided(None).any(|decision| decision.points.is_some())
    }

    /// Whether the submission has a mark that becomes the student's mark.
    pub(crate) fn counts(&self) -> bool {
        self.has_mark() && self.marked.attempt == Attempt::Counts
    }

    /// Whether a person gave the points of a task or a measure.
    pub(crate) fn is_by_hand(&self, task: &str) -> bool {
        self.decided(Some(task)).any(|decision| decision.points.is_some())
    }
}
