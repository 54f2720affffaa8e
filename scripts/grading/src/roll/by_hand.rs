//! What a person decided about a submission, whatever the grader found.

use anyhow::{Context, Result, ensure};
use serde::Deserialize;

use crate::record::Decision;
use lab_kit::rubric::Rubric;

/// An `[[override]]` of `class.toml`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Override {
    /// A submission, or a student of the roster.
    pub(super) student: String,
    /// A task or a measure; the whole submission if not given.
    task: Option<String>,
    /// Points; without them it is a comment.
    points: Option<f64>,
    /// So many days late, whatever the clock says.
    pub(super) days: Option<u32>,
    /// What the student reads.
    reason: String,
}

impl Override {
    /// Whether it can be: of a task that there is, with points that it has.
    pub(super) fn check(&self, rubric: &Rubric) -> Result<()> {
        ensure!(!self.reason.trim().is_empty(), "it has no reason");
        ensure!(self.days.is_none() || self.task.is_none(), "days are of a submission, not a task");
        let most = match &self.task {
            None => f64::INFINITY,
            Some(task) => worth(rubric, task)
                .with_context(|| format!("there is no task or measure {task}"))?,
        };
        if let Some(points) = self.points {
            let can_be = points.is_finite() && (0.0..=most).contains(&points);
            ensure!(can_be, "{points} points cannot be given where there are {most}");
        }
        Ok(())
    }

    pub(super) fn decision(&self) -> Decision {
        let Self { task, points, reason, .. } = self;
        Decision { task: task.clone(), points: *points, reason: reason.clone() }
    }
}

/// What a task or a measure is worth, if there is one of that name.
fn worth(rubric: &Rubric, task: &str) -> Option<f64> {
    let timed = match task {
        "complexity" => &rubric.complexity,
        "scaling" => &rubric.scaling,
        "speed" => &rubric.speed,
        _ => return rubric.tasks.get(task).copied(),
    };
    Some(timed.as_ref()?.points)
}
