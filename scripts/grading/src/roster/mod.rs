//! `class.toml` in the folder of records: an instructor's information about a class.
//!
//! The file contains the students ([`students`]), the penalties for lateness ([`late`]), and a
//! person's decisions ([`Decision`]). [`join`] assigns submissions to students, [`attendance`]
//! lists who handed in, and [`marks`] writes the students with their marks. [`ClassFile::tell`]
//! writes this information into the records. Points are computed only from the records, so marks
//! can be recomputed without losing this information.

mod attendance;
pub(crate) mod export;
mod join;
pub(crate) mod late;
mod marks;
mod students;

use std::collections::BTreeMap;
use std::fs;
use std::io::ErrorKind;
use std::os::unix::fs::symlink;
use std::path::{Path, PathBuf};

use anyhow::{Context, Error, Result, ensure};
use hmac_sha256::HMAC;
use serde::Deserialize;

use crate::record::{Decision, Record, scale};
use crate::score::score;
use crate::submission::names::{CLASS, composed};
use attendance::Attempts;
pub(crate) use attendance::Attendance;
use export::Export;
use join::{Join, Members};
use lab_kit::Facts;
use lab_kit::escape::line;
use late::Late;
use students::Roster;

/// Number of digits of a pseudonym.
const DIGITS: usize = 6;

/// Information about a class; empty if there is no `class.toml`.
#[derive(Debug, Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub(crate) struct ClassFile {
    /// Path of the roster.
    roster: Option<PathBuf>,
    /// Contents of the roster.
    #[serde(skip)]
    students: Option<Roster>,
    column: Option<String>,
    pseudonyms: Option<String>,
    names: BTreeMap<String, Members>,
    /// Gradescope's export, for submissions that are not in `names`.
    #[serde(skip)]
    export: Export,
    attempts: Option<Attempts>,
    late: Option<Late>,
    /// Whether only the core tasks have points.
    core: bool,
    #[serde(rename = "override")]
    overrides: Vec<Decision>,
}

/// Makes a link in a folder of records to a file about the class beside the submissions.
///
/// # Errors
/// If the folder has a different file of that name.
pub(crate) fn link(beside: &Path, folder: &Path) -> Result<()> {
    let own = folder.join(beside.file_name().unwrap_or_default());
    let beside = beside.canonicalize()?;
    if own.canonicalize().is_ok_and(|own| own == beside) {
        return Ok(());
    }
    ensure!(!own.exists(), "there are {} and {}: keep one", beside.display(), own.display());
    fs::create_dir_all(folder).with_context(|| format!("cannot make {}", folder.display()))?;
    symlink(&beside, &own).with_context(|| format!("cannot write {}", own.display()))
}

impl ClassFile {
    /// Reads `class.toml` in a folder of records, and the files that it names.
    ///
    /// # Errors
    /// If a file cannot be read or has an invalid entry. The message names the file, line and
    /// column.
    pub(crate) fn read(folder: &Path, rubric: &Facts) -> Result<Self> {
        let export = Export::read(folder)?;
        Ok(Self { export, ..Self::read_own(folder, rubric)? })
    }

    fn read_own(folder: &Path, rubric: &Facts) -> Result<Self> {
        let path = folder.join(CLASS);
        let text = match fs::read_to_string(&path) {
            Err(error) if error.kind() == ErrorKind::NotFound => return Ok(Self::default()),
            text => text.with_context(|| format!("cannot read {}", path.display()))?,
        };
        // Editors on Windows begin a file with an invisible byte order mark.
        let text = text.trim_start_matches('\u{feff}');
        // Paths in the file are relative to the real file, even if this is a link to it.
        let real = path.canonicalize().unwrap_or_else(|_| path.clone());
        let folder = real.parent().unwrap_or(folder);
        Self::parse(folder, text, rubric).with_context(|| path.display().to_string())
    }

    fn parse(folder: &Path, text: &str, rubric: &Facts) -> Result<Self> {
        let mut class: Self = basic_toml::from_str(text).map_err(|error| {
            // In a well-formed file, the location that the parser reports for a wrong entry is not
            // reliable.
            let is_toml = basic_toml::from_str::<serde_json::Value>(text).is_ok();
            let message = error.to_string();
            let end = message.rfind(" at line ").filter(|_| is_toml).unwrap_or(message.len());
            Error::msg(message[..end].to_owned())
        })?;
        let names = std::mem::take(&mut class.names).into_iter();
        class.names = names.map(|(name, members)| (composed(&name), members)).collect();
        for (number, decided) in (1..).zip(&class.overrides) {
            decided.check(rubric).with_context(|| format!("override {number}"))?;
        }
        let roster = class.roster.as_ref().map(|path| Roster::read(&folder.join(path)));
        class.students = roster.transpose()?;
        class.late.as_mut().map_or(Ok(()), |late| late.read(folder))?;
        Ok(class)
    }

    /// Writes into each record its student, lateness and decisions.
    ///
    /// Entries that match no submission are reported on stderr.
    fn tell(&self, records: &mut [Record]) {
        for record in &mut *records {
            record.marked.pseudonym = self.pseudonyms.as_ref().map(|key| {
                let mac = HMAC::mac(record.found.name.as_bytes(), key.as_bytes());
                mac.iter().map(|byte| format!("{byte:02x}")).collect::<String>()[..DIGITS].into()
            });
        }
        let join = Join::new(self.students.as_ref(), &self.names, &self.export, records);
        for complaint in join.wrong(&self.names, records) {
            eprintln!("{CLASS}: names: {}", line(&complaint));
        }
        let mut decided = vec![Vec::new(); records.len()];
        for (number, one) in (1..).zip(&self.overrides) {
            if let Some(at) =
                join.find_or_warn(&one.student, records, &format!("override {number}"))
            {
                decided[at].push(one);
            }
        }
        let mut times = vec![None; records.len()];
        for (who, time) in self.late.iter().flat_map(Late::listed) {
            if let Some(at) = join.find_or_warn(who, records, "times") {
                times[at] = Some(time);
            }
        }
        for (at, record) in records.iter_mut().enumerate() {
            let exported = self.export.of(&record.found.name);
            record.marked.student = join.student(at).or_else(|| Some(exported?.names()));
            times[at] = times[at].or_else(|| exported?.time);
            record.marked.by_hand = decided[at].iter().copied().cloned().collect();
            let excused = decided[at].iter().rev().find_map(|one| one.days);
            let time = times[at].or(record.marked.handed_in);
            record.marked.late = self.late.as_ref().and_then(|late| late.lateness(time, excused));
        }
    }

    /// Marks a class: writes its decisions into the records, and computes their points.
    ///
    /// # Errors
    /// If a task of the rubric is missing in a record.
    pub(crate) fn mark(&self, records: &mut [Record], rubric: &Facts) -> Result<Attendance> {
        let rubric = self.rubric(rubric);
        self.tell(records);
        for record in &mut *records {
            score(record, &rubric)?;
        }
        Ok(self.attendance(records))
    }

    /// Returns the lab's rubric, or the rubric of its core tasks if the class does only the core
    /// tasks.
    fn rubric(&self, rubric: &Facts) -> Facts {
        if self.core { rubric.clone().core() } else { rubric.clone() }
    }

    /// Finds out who handed in a submission, from records with points. Writes into each record
    /// whether its submission counts.
    fn attendance(&self, records: &mut [Record]) -> Attendance {
        let join = Join::new(self.students.as_ref(), &self.names, &self.export, records);
        let attendance = join.attendance(self.attempts, records);
        for at in 0..records.len() {
            records[at].marked.attempt = join.attempt(at, &attendance, records);
        }
        attendance
    }

    /// Returns the deadline with its time zone; `None` if there is no deadline.
    pub(crate) fn deadline(&self) -> Option<String> {
        self.late.as_ref().and_then(Late::words)
    }

    /// Whether there are penalties for lateness, but hand-in times come only from the submitted
    /// files.
    pub(crate) fn trusts_files(&self) -> bool {
        let untold = self.late.as_ref().is_some_and(|late| late.listed().next().is_none());
        untold && self.export.is_empty()
    }

    /// Returns the roster with a column of marks; `None` if there is no roster.
    ///
    /// # Errors
    /// If the possible points in the roster are not a number.
    pub(crate) fn marks(
        &self,
        records: &[Record],
        attendance: &Attendance,
    ) -> Result<Option<String>> {
        let (Some(roster), Some(first)) = (&self.students, records.first()) else {
            return Ok(None);
        };
        let own = format!("Lab {}", first.found.lab);
        let column = self.column.as_deref().unwrap_or(&own);
        let full = scale(records);
        let shares =
            attendance.present.iter().map(|(row, at)| (*row, records[*at].marked.points / full));
        Ok(Some(roster.with_marks(column, full, &shares.collect())?))
    }
}

#[cfg(test)]
mod class_tests;
