//! Students with and without submissions, and the matters that an instructor must attend to.

use std::collections::BTreeMap;

use serde::Deserialize;

use crate::record::Record;
use lab_kit::escape::line;

/// Rule that determines which submission counts if a student has several submissions.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum Attempts {
    /// The latest submission counts.
    Latest,
    /// The submission with the most points counts.
    Best,
}

/// Students with and without submissions, and submissions without a student.
#[derive(Debug, Default, PartialEq, Eq)]
pub(crate) struct Attendance {
    /// Index of the submission that counts, by the student's row in the roster.
    pub(crate) present: BTreeMap<usize, usize>,
    /// Names of students without a submission.
    pub(crate) absent: Vec<String>,
    /// Students with several submissions: name, the submission that counts, and all submissions.
    pub(crate) twice: Vec<(String, Option<usize>, Vec<usize>)>,
    /// Rule that determines which submission counts; `None` if no submission counts without a
    /// decision.
    pub(crate) attempts: Option<Attempts>,
    /// Submissions whose student is not in the roster.
    pub(crate) strangers: Vec<usize>,
    /// Submissions that contain nothing to mark, and whose students have no other submission that
    /// counts.
    pub(crate) unmarked: Vec<usize>,
}

impl Attendance {
    /// Returns the matters that an instructor must attend to.
    ///
    /// Each is a sentence, with the students or submissions concerned.
    pub(crate) fn words(&self, records: &[Record]) -> Vec<(&'static str, Vec<String>)> {
        let twice = self.twice.iter().map(|(student, counts, own)| {
            let others = own.iter().copied().filter(|at| Some(*at) != *counts);
            let others = names(records, others).join(", ");
            match counts {
                Some(at) => format!("{student} ({}, not {others})", records[*at].found.name),
                None => format!("{student} ({others})"),
            }
        });
        let all = [
            ("Handed in nothing", self.absent.clone()),
            (
                match self.attempts {
                    None => "Handed in more than once, and has no mark until one is left",
                    Some(Attempts::Latest) => {
                        "Handed in more than once: the latest that has a mark counts"
                    }
                    Some(Attempts::Best) => "Handed in more than once: the best counts",
                },
                twice.collect(),
            ),
            (
                "Could not be read, graded or found, and has no mark until it can",
                names(records, self.unmarked.iter().copied()),
            ),
            (
                "Belongs to no one student of the roster",
                names(records, self.strangers.iter().copied()),
            ),
        ];
        all.into_iter().filter(|(_, who)| !who.is_empty()).collect()
    }

    /// Prints the matters for the instructor to stdout.
    pub(crate) fn say(&self, records: &[Record]) {
        for (what, who) in self.words(records) {
            println!("{what}: {}", line(&who.join("; ")));
        }
    }
}

/// Returns the names of these submissions.
fn names(records: &[Record], submissions: impl Iterator<Item = usize>) -> Vec<String> {
    submissions.map(|at| records[at].found.name.clone()).collect()
}
