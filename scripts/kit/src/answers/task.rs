//! Numbers of tasks and names of their regions.

use std::fmt;
use std::str::FromStr;

use serde::{Serialize, Serializer};

use crate::lab::Lab;

/// A task, such as 3.2, which is the second of lab 3.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Task {
    /// Lab of the task.
    pub lab: Lab,
    /// Number of the task in the lab, from 1.
    pub number: u8,
}

/// A region of a solution: a task, and a letter if the task has several functions (`1.5b`).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct RegionId {
    /// Task of the region.
    pub task: Task,
    letter: Option<char>,
}

impl Task {
    /// Returns the task of a test: `task_3_2::fresh_halo` belongs to 3.2.
    pub fn of_test(test: &str) -> Option<Self> {
        let module = test.split("::").find_map(|module| module.strip_prefix("task_"))?;
        let mut parts = module.split('_');
        let lab = parts.next()?.parse().ok()?;
        Some(Self { lab, number: parts.next()?.parse().ok()? })
    }

    /// Returns the anchor of the task in its chapter, such as `task-3-2`.
    pub fn anchor(self) -> String {
        format!("task-{}-{}", self.lab, self.number)
    }
}

impl fmt::Display for Task {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}.{}", self.lab, self.number)
    }
}

impl Serialize for Task {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl FromStr for Task {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text.parse() {
            Ok(RegionId { task, letter: None }) => Ok(task),
            Ok(part) => Err(format!("{part} is a part of task {0}: write {0}", part.task)),
            Err(_) => Err(format!("'{text}' is not the number of a task, such as 3.2")),
        }
    }
}

impl fmt::Display for RegionId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.task)?;
        self.letter.map_or(Ok(()), |letter| write!(f, "{letter}"))
    }
}

impl FromStr for RegionId {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        Self::read(text)
            .ok_or_else(|| format!("'{text}' is not the number of a task, such as 3.2 or 3.2b"))
    }
}

impl RegionId {
    fn read(text: &str) -> Option<Self> {
        let (lab, rest) = text.split_once('.')?;
        let number = rest.strip_suffix(|c: char| c.is_ascii_lowercase()).unwrap_or(rest);
        let letter = rest[number.len()..].chars().next();
        // Without this check, `lab1.2` and `1.+2` would be tasks too.
        if ![lab, number].concat().bytes().all(|b| b.is_ascii_digit()) {
            return None;
        }
        let task = Task { lab: lab.parse().ok()?, number: number.parse().ok()? };
        Some(Self { task, letter })
    }
}

#[cfg(test)]
mod tests {
    use super::{RegionId, Task};

    #[test]
    fn ids_are_read_and_written_alike() {
        for id in ["1.1", "10.12", "1.5b"] {
            assert_eq!(id.parse::<RegionId>().map(|id| id.to_string()), Ok(id.to_owned()));
        }
        for id in ["", "1", "1.", ".1", "0.1", "1.b", "1.2B", "1.2bc", "1.+2", "1.2 ", "1.999"] {
            assert!(id.parse::<RegionId>().is_err(), "{id}");
        }
        assert!("1.5b".parse::<Task>().is_err(), "a task has no letter");
    }

    #[test]
    fn tests_name_their_task() {
        for (test, task) in [
            ("task_3_2::fresh_halo", Some("3.2")),
            ("halo::task_10_11::x", Some("10.11")),
            ("the_variants_have_names", None),
            ("task_force", None),
        ] {
            assert_eq!(Task::of_test(test), task.map(|task| task.parse().unwrap()), "{test}");
        }
    }
}
