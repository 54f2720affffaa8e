//! Assigns submissions to the students of a roster.

use std::collections::BTreeMap;

use serde::Deserialize;

use super::attendance::{Attempts, Attendance};
use super::export::{Export, HandIn};
use super::students::{Roster, Student, key};
use crate::record::{Attempt, Record};
use crate::submission::names::{CLASS, bare, composed};
use lab_kit::escape::line;

/// Owners of a submission, as an instructor writes them.
#[derive(Debug, Deserialize)]
#[serde(untagged)]
pub(super) enum Members {
    /// One student.
    One(String),
    /// A group.
    Several(Vec<String>),
}

impl Members {
    fn names(&self) -> &[String] {
        match self {
            Self::One(student) => std::slice::from_ref(student),
            Self::Several(students) => students,
        }
    }
}

/// Submissions joined with the students of a roster.
pub(super) struct Join<'a> {
    students: &'a [Student],
    /// Indices of the students, by submission.
    whose: Vec<Vec<usize>>,
}

impl<'a> Join<'a> {
    /// Joins submissions and students by name, number or e-mail address. Entries of `names` take
    /// precedence over Gradescope's export.
    pub(super) fn new(
        roster: Option<&'a Roster>,
        names: &BTreeMap<String, Members>,
        export: &Export,
        records: &[Record],
    ) -> Self {
        let students = roster.map_or(&[][..], |roster| &roster.students);
        let whose = records.iter().map(|Record { found, .. }| {
            if let Some(members) = names.get(&composed(&found.name)) {
                members.names().iter().filter_map(|student| the_one(students, student)).collect()
            } else if let Some(HandIn { members, .. }) = export.of(&found.name) {
                let keys = members.iter().map(|member| &member.keys);
                keys.filter_map(|keys| keys.iter().find_map(|key| the_one(students, key))).collect()
            } else {
                by_parts(students, &found.name).into_iter().collect()
            }
        });
        Self { students, whose: whose.collect() }
    }

    /// Lists entries of `names` whose submission or student does not exist.
    pub(super) fn wrong(
        &self,
        names: &BTreeMap<String, Members>,
        records: &[Record],
    ) -> Vec<String> {
        let called: Vec<String> =
            records.iter().map(|record| composed(&record.found.name)).collect();
        let submissions = names.keys().filter(|name| !called.contains(name));
        let submissions = submissions.map(|name| format!("no submission is called '{name}'"));
        let students = names.values().flat_map(Members::names);
        let unknown = students.filter(|student| the_one(self.students, student).is_none());
        let unknown =
            unknown.map(|student| format!("'{student}' is not one student of the roster"));
        submissions.chain(unknown).collect()
    }

    /// Finds the submission that has the name, the student or the pseudonym `who`.
    fn find(&self, who: &str, records: &[Record]) -> Option<usize> {
        let name = composed(who);
        let called = records.iter().position(|record| {
            composed(&record.found.name) == name || record.marked.pseudonym.as_deref() == Some(who)
        });
        called.or_else(|| {
            let student = the_one(self.students, who)?;
            self.whose.iter().position(|whose| whose.contains(&student))
        })
    }

    /// Finds the submission as [`Join::find`] does; `None`, with a warning that names the entry
    /// `what` of `class.toml`, if there is none.
    pub(super) fn find_or_warn(&self, who: &str, records: &[Record], what: &str) -> Option<usize> {
        let found = self.find(who, records);
        if found.is_none() {
            eprintln!("{CLASS}: {what}: no submission belongs to '{}'", line(who));
        }
        found
    }

    /// Returns the names of a submission's students; `None` if no student of the roster handed it
    /// in.
    pub(super) fn student(&self, submission: usize) -> Option<String> {
        let names = self.whose[submission].iter().map(|at| self.students[*at].name.as_str());
        Some(names.collect::<Vec<_>>().join(" and ")).filter(|names| !names.is_empty())
    }

    /// Finds out who handed in a submission, and which of several submissions counts.
    pub(super) fn attendance(&self, attempts: Option<Attempts>, records: &[Record]) -> Attendance {
        let mut all = Attendance { attempts, ..Attendance::default() };
        if self.students.is_empty() {
            return all;
        }
        let submissions = 0..self.whose.len();
        all.strangers = submissions.clone().filter(|at| self.whose[*at].is_empty()).collect();
        for (number, student) in self.students.iter().enumerate() {
            let own = submissions.clone().filter(|at| self.whose[*at].contains(&number));
            let own: Vec<usize> = own.collect();
            let mut marked = own.iter().copied().filter(|at| records[*at].has_mark());
            let counts = match (own.len(), attempts) {
                (0, _) => {
                    all.absent.push(self.called(student));
                    continue;
                }
                (1, _) => marked.next(),
                (_, None) => None,
                (_, Some(Attempts::Latest)) => {
                    marked.max_by_key(|at| records[*at].marked.handed_in)
                }
                (_, Some(Attempts::Best)) => marked
                    .max_by(|a, b| records[*a].marked.points.total_cmp(&records[*b].marked.points)),
            };
            all.present.extend(counts.map(|at| (student.row, at)));
            if own.len() > 1 {
                all.twice.push((self.called(student), counts, own));
            }
        }
        let unmarked = submissions.filter(|at| {
            !records[*at].has_mark() && self.attempt(*at, &all, records) != Attempt::Another
        });
        all.unmarked = unmarked.collect();
        all
    }

    /// Returns a student's name, with the address if several students have the same name.
    fn called(&self, student: &Student) -> String {
        let Student { name, address, .. } = student;
        let several = self.students.iter().filter(|other| other.name == *name).count() > 1;
        if several { format!("{name} ({address})") } else { name.clone() }
    }

    /// Returns whether a submission counts. It counts if it determines the mark of one of its
    /// students.
    pub(super) fn attempt(&self, at: usize, all: &Attendance, records: &[Record]) -> Attempt {
        let students = self.whose[at].iter().map(|student| self.students[*student].row);
        let counts: Vec<_> = students.map(|row| all.present.get(&row).copied()).collect();
        if counts.is_empty() || counts.contains(&Some(at)) {
            Attempt::Counts
        } else if counts.iter().all(Option::is_some) {
            Attempt::Another
        } else if records[at].has_mark() {
            Attempt::Undecided
        } else {
            Attempt::Counts
        }
    }
}

/// Finds the only student with that name; `None` if there is no such student, or more than one.
fn the_one(students: &[Student], name: &str) -> Option<usize> {
    only(&all_named(students, name))
}

fn only(students: &[usize]) -> Option<usize> {
    if let [student] = students { Some(*student) } else { None }
}

fn all_named(students: &[Student], name: &str) -> Vec<usize> {
    let name = key(name);
    (0..students.len()).filter(|at| students[*at].keys.contains(&name)).collect()
}

/// Finds the only student whom a submission's name denotes.
///
/// Platforms join names, numbers and the name of the uploaded file with underscores. If several
/// students share a name, later parts of the submission's name decide between them. A number that
/// belongs to a different student is ignored as a coincidence. A word that belongs to a different
/// student is a contradiction, so no student is found.
fn by_parts(students: &[Student], name: &str) -> Option<usize> {
    let mut meant: Vec<usize> = Vec::new();
    for part in [name, bare(name)].into_iter().chain(name.split('_').map(bare)) {
        let named = all_named(students, part);
        let both: Vec<usize> =
            named.iter().copied().filter(|student| meant.contains(student)).collect();
        let is_number = part.bytes().all(|byte| byte.is_ascii_digit());
        if meant.is_empty() {
            meant = named;
        } else if !both.is_empty() {
            meant = both;
        } else if !named.is_empty() && !is_number {
            return None;
        }
    }
    only(&meant)
}
