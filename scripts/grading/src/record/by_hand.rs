//! What a record keeps of a person's decisions, and of the clock's.

use anyhow::{Context, Result, ensure};
use serde::{Deserialize, Serialize};

use super::{Record, Status};
use lab_kit::Facts;

/// What a person decided, whatever the grader found: an `[[override]]` of `class.toml`. In a record it
/// does not say whose it is, and how late that is the record says itself.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Decision {
    /// A submission, or a student of the roster.
    #[serde(default, skip_serializing)]
    pub(crate) student: String,
    /// A task or a measure; the whole submission if there is none.
    pub(crate) task: Option<String>,
    /// Points, if it gives any; without them it is a comment.
    pub(crate) points: Option<f64>,
    /// Days late, whatever the clock says.
    #[serde(default, skip_serializing)]
    pub(crate) days: Option<u32>,
    /// Why: what the student reads.
    pub(crate) reason: String,
}

/// The most points of a submission. Labs are worth about a hundred: a larger number is a slip.
const MOST: f64 = 1000.0;

impl Decision {
    /// Whether it can be: of a task that there is, with points that it has.
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

/// What a task or a measure is worth, if there is one of that name.
fn worth(rubric: &Facts, task: &str) -> Option<f64> {
    let timed = match task {
        "complexity" => &rubric.complexity,
        "scaling" => &rubric.scaling,
        "speed" => &rubric.speed,
        _ => return Some(rubric.tasks.get(task)?.points),
    };
    Some(timed.as_ref()?.points)
}

/// How late a submission is.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub(crate) struct Lateness {
    /// Days that have begun.
    pub(crate) days: u32,
    /// The share of the points that is lost, 0 to 1.
    pub(crate) lost: f64,
}

/// Whether its student's mark is made of it.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum Attempt {
    /// Yes, if it has a mark.
    #[default]
    Counts,
    /// Another one of the student's counts.
    Another,
    /// The student has several, and nobody has said which counts.
    Undecided,
}

impl Lateness {
    /// `a day`, `3 days`.
    pub(crate) fn days(&self) -> String {
        if self.days == 1 { "a day".to_owned() } else { format!("{} days", self.days) }
    }
}

impl Record {
    /// What was decided about a task or a measure, or about the whole.
    pub(crate) fn decided<'a>(
        &'a self,
        task: Option<&'a str>,
    ) -> impl Iterator<Item = &'a Decision> {
        self.by_hand.iter().filter(move |decision| decision.task.as_deref() == task)
    }

    /// Whether there was anything to mark, or a person gave points all the same.
    pub(crate) fn has_mark(&self) -> bool {
        let nothing = matches!(self.status, Status::Unreadable | Status::Empty | Status::Failed);
        !nothing || self.decided(None).any(|decision| decision.points.is_some())
    }

    /// Whether it has a mark that is its student's.
    pub(crate) fn counts(&self) -> bool {
        self.has_mark() && self.attempt == Attempt::Counts
    }

    /// Whether points of a task or a measure were given by hand.
    pub(crate) fn is_by_hand(&self, task: &str) -> bool {
        self.decided(Some(task)).any(|decision| decision.points.is_some())
    }
}
