//! What a record keeps of a person's decisions, and of the clock's.

use serde::{Deserialize, Serialize};

use super::Record;

/// What a person decided, whatever the grader found.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub(crate) struct Decision {
    /// A task or a measure; the whole submission if there is none.
    pub(crate) task: Option<String>,
    /// Points, if it gives any.
    pub(crate) points: Option<f64>,
    /// Why.
    pub(crate) reason: String,
}

/// How late a submission is.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub(crate) struct Lateness {
    /// Days that have begun.
    pub(crate) days: u32,
    /// The share of the points that is lost, 0 to 1.
    pub(crate) lost: f64,
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

    /// Whether points of a task or a measure were given by hand.
    pub(crate) fn is_by_hand(&self, task: &str) -> bool {
        self.decided(Some(task)).any(|decision| decision.points.is_some())
    }
}
