//! Which submission is whose.

use std::collections::BTreeMap;

use super::roster::{Roster, Student, key};
use crate::escape::line;
use crate::record::Record;

/// Who handed in what.
#[derive(Debug, Default, PartialEq, Eq)]
pub(crate) struct Attendance {
    /// By row of the roster, the submission of a student who has one.
    pub(crate) present: BTreeMap<usize, usize>,
    /// Students without a submission.
    pub(crate) absent: Vec<String>,
    /// Students with more than one, which get no mark: their names, and the submissions.
    pub(crate) twice: Vec<(String, Vec<usize>)>,
    /// Submissions of nobody in the roster.
    pub(crate) strangers: Vec<usize>,
}

impl Attendance {
    /// What an instructor has to see to: a sentence, and whom it is about.
    pub(crate) fn words(&self, records: &[Record]) -> Vec<(&'static str, Vec<String>)> {
        let name = |at: &usize| records[*at].name.clone();
        let twice = self.twice.iter().map(|(student, own)| {
            format!("{student} ({})", own.iter().map(name).collect::<Vec<_>>().join(", "))
        });
        let all = [
            ("Handed in nothing", self.absent.clone()),
            ("Handed in more than once, and has no mark until one is left", twice.collect()),
            ("In the roster under no such name", self.strangers.iter().map(name).collect()),
        ];
        all.into_iter().filter(|(_, who)| !who.is_empty()).collect()
    }

    /// The same, on stdout.
    pub(crate) fn say(&self, records: &[Record]) {
        for (what, who) in self.words(records) {
            println!("{what}: {}", line(&who.join("; ")));
        }
    }
}

/// Submissions and the students of a roster.
pub(super) struct Join<'a> {
    students: &'a [Student],
    /// The index of the student, by submission.
    whose: Vec<Option<usize>>,
}

impl<'a> Join<'a> {
    /// Joins by name, number or e-mail address. What `names` says of a submission goes first.
    pub(super) fn new(
        roster: Option<&'a Roster>,
        names: &BTreeMap<String, String>,
        records: &[Record],
    ) -> Self {
        let students = roster.map_or(&[][..], |roster| &roster.students);
        let whose = records.iter().map(|record| match names.get(&record.name) {
            Some(student) => the_one(students, student),
            // Platforms put names, numbers and what was uploaded between underscores.
            None => [record.name.as_str()]
                .into_iter()
                .chain(record.name.split('_'))
                .find_map(|part| the_one(students, part)),
        });
        Self { students, whose: whose.collect() }
    }

    /// The submission that is called so, or whose student or pseudonym is.
    pub(super) fn find(&self, who: &str, records: &[Record]) -> Option<usize> {
        let called =
            |record: &Record| record.name == who || record.pseudonym.as_deref() == Some(who);
        records.iter().position(called).or_else(|| {
            let student = the_one(self.students, who)?;
            self.whose.iter().position(|whose| *whose == Some(student))
        })
    }

    /// Who handed in a submission, as the roster says it.
    pub(super) fn student(&self, submission: usize) -> Option<&str> {
        Some(&self.students[self.whose[submission]?].name)
    }

    pub(super) fn attendance(&self) -> Attendance {
        let mut all = Attendance::default();
        for (number, student) in self.students.iter().enumerate() {
            let own = (0..self.whose.len()).filter(|at| self.whose[*at] == Some(number));
            match own.collect::<Vec<_>>()[..] {
                [] => all.absent.push(student.name.clone()),
                [only] => drop(all.present.insert(student.row, only)),
                ref own => all.twice.push((student.name.clone(), own.to_vec())),
            }
        }
        if !self.students.is_empty() {
            let strange = (0..self.whose.len()).filter(|at| self.whose[*at].is_none());
            all.strangers.extend(strange);
        }
        all
    }
}

/// The one student of that name; none if nobody has it, or more than one.
fn the_one(students: &[Student], name: &str) -> Option<usize> {
    let name = key(name);
    let mut named = (0..students.len()).filter(|at| students[*at].keys.contains(&name));
    named.next().filter(|_| named.next().is_none())
}
