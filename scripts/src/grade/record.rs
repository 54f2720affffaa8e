//! What is written down about one submission.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

/// The form of a record; a reader refuses what it does not know.
pub(crate) const FORMAT: u8 = 1;

/// One submission, graded. One JSON file each.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub(crate) struct Record {
    /// [`FORMAT`].
    pub(crate) format: u8,
    /// Whose: the name of the archive or folder.
    pub(crate) name: String,
    /// The number of the lab.
    pub(crate) lab: u8,
    /// How far it came.
    pub(crate) status: Status,
    /// Why it came no further, as the compiler or the unpacking said it; empty if it did.
    pub(crate) message: String,
    /// SHA-256 of all sources taken, with their paths.
    pub(crate) hash: String,
    /// SHA-256 of each source taken, by its path below the lab's folder.
    pub(crate) files: BTreeMap<String, String>,
    /// What was not taken, and why.
    pub(crate) left_out: Vec<LeftOut>,
    /// SHA-256 of what it was graded by: probes, rubric, solution.
    pub(crate) grader: String,
    /// The probes' inputs come from this number.
    pub(crate) seed: u64,
    /// What `rustc --version` says.
    pub(crate) toolchain: String,
    /// Operating system, architecture and cores.
    pub(crate) machine: String,
    /// Whether foreign code was kept in a sandbox.
    pub(crate) sandboxed: bool,
    /// What the lab's own tests said; no marks come from them. None if nobody ran them.
    #[serde(default)]
    pub(crate) tests: Option<Tests>,
    /// The tasks, in order.
    pub(crate) tasks: Vec<Task>,
    /// Points of all tasks.
    pub(crate) points: f64,
    /// Points that could be had.
    pub(crate) out_of: f64,
}

/// How far a submission came.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum Status {
    /// It could not be read.
    Unreadable,
    /// It holds no source of this lab.
    Empty,
    /// It does not compile.
    NotBuilt,
    /// Its probes ran.
    Graded,
}

/// A file that was not taken.
#[derive(Clone, Debug, Deserialize, PartialEq, Eq, Serialize)]
pub(crate) struct LeftOut {
    /// Its path as far as it can be written.
    pub(crate) path: String,
    /// Why.
    pub(crate) reason: String,
}

/// The lab's own tests, run by the submission's own program: feedback, and no more than that.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub(crate) struct Tests {
    /// Whether the tests that the program has are those of the kit.
    pub(crate) complete: bool,
    /// Why nothing ran; empty if something did.
    pub(crate) message: String,
    /// Each test of the kit, in the order of its name.
    pub(crate) ran: Vec<Test>,
}

/// A test and what it said.
#[derive(Clone, Debug, Deserialize, PartialEq, Eq, Serialize)]
pub(crate) struct Test {
    /// Such as `task_1_3_two_at_one_place`.
    pub(crate) name: String,
    /// None if it did not run, since the time for tests was up.
    pub(crate) passed: Option<bool>,
    /// Why it failed, in its own words.
    pub(crate) message: String,
}

/// A task's marks. They come from its probe and nothing else.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub(crate) struct Task {
    /// Such as `1.3`.
    pub(crate) id: String,
    /// Whether all answers were the solution's.
    pub(crate) passed: bool,
    /// The first thing that was wrong; empty if nothing was.
    pub(crate) message: String,
    /// Points given.
    pub(crate) points: f64,
    /// Points that could be had.
    pub(crate) out_of: f64,
}

#[cfg(test)]
mod tests {
    use super::{Record, Status};

    #[test]
    fn a_record_can_be_read_again() {
        let sample = include_str!("../../tests/record.json");
        let record: Record = serde_json::from_str(sample).unwrap();
        assert_eq!((record.status, record.points), (Status::Graded, 60.0));
        let again = serde_json::to_string(&record).unwrap();
        assert_eq!(serde_json::from_str::<Record>(&again).unwrap(), record);
    }
}
