//! What is written down about one submission.

mod by_hand;
mod times;

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, ensure};
use jiff::Timestamp;
use serde::{Deserialize, Serialize};

use crate::escape::line;
use lab_kit::Lab;
use lab_kit::answers::RegionId;
use lab_kit::files::{read_bytes, write_file};

pub(crate) use by_hand::{Attempt, Decision, Lateness};
pub(crate) use times::{Kind, Measure, Outcome, Run, Verdict, Whose};

/// The form of a record; a reader refuses what it does not know.
pub(crate) const FORMAT: u8 = 1;

/// One submission, graded. One JSON file each.
#[derive(Clone, Debug, Default, Deserialize, PartialEq, Serialize)]
#[serde(default)]
pub(crate) struct Record {
    /// [`FORMAT`].
    pub(crate) format: u8,
    /// Whose: the name of the archive or folder.
    pub(crate) name: String,
    /// The lab.
    pub(crate) lab: Lab,
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
    /// Given files that the student changed: the kit's were compiled.
    pub(crate) changed: Vec<String>,
    /// SHA-256 of what it was graded by: questions, snapshots, oracle, solution.
    pub(crate) grader: String,
    /// The inputs of the questions come from this number.
    pub(crate) seed: u64,
    /// What `rustc --version` says.
    pub(crate) toolchain: String,
    /// Processor and cores.
    pub(crate) machine: String,
    /// Whether foreign code was kept in a sandbox.
    pub(crate) sandboxed: bool,
    /// The tasks; when it has points, by their numbers.
    pub(crate) tasks: Vec<Task>,
    /// Whether times were asked for.
    pub(crate) timed: bool,
    /// What was timed, as it was: measures are judged from this, and can be anew.
    pub(crate) runs: Vec<Run>,
    /// What the times are worth.
    pub(crate) measures: Vec<Measure>,
    /// When it was handed in, by its file.
    pub(crate) handed_in: Option<Timestamp>,
    /// How late that was; none if it was in time.
    pub(crate) late: Option<Lateness>,
    /// What a person decided.
    pub(crate) by_hand: Vec<Decision>,
    /// Whether it counts, of several that its student handed in.
    pub(crate) attempt: Attempt,
    /// Whose it is, by the roster.
    pub(crate) student: Option<String>,
    /// What graders see instead of names.
    pub(crate) pseudonym: Option<String>,
    /// Points of all tasks and of all measures.
    pub(crate) points: f64,
    /// Points that could be had, those among them that are still open.
    pub(crate) out_of: f64,
}

/// How far a submission came.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum Status {
    /// It could not be read.
    Unreadable,
    /// It holds no source of this lab.
    Empty,
    /// It says what no source may say.
    Refused,
    /// It does not compile.
    NotBuilt,
    /// The grader could not deal with it: it is tried again the next time.
    Failed,
    /// Its tasks were asked.
    #[default]
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

/// A task's marks. They come from the answers to its questions and nothing else.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub(crate) struct Task {
    /// Such as `1.3`.
    pub(crate) id: String,
    /// Whether all answers were right.
    pub(crate) passed: bool,
    /// The share of them that were.
    #[serde(default)]
    pub(crate) share: f64,
    /// The first thing that was wrong; empty if nothing was.
    pub(crate) message: String,
    /// Points given.
    pub(crate) points: f64,
    /// Points that could be had.
    pub(crate) out_of: f64,
}

impl Task {
    /// One that nobody has asked. What it is worth, the rubric says later.
    pub(crate) fn unasked(id: &str) -> Self {
        let (id, message) = (id.to_owned(), String::new());
        Self { id, passed: false, share: 0.0, message, points: 0.0, out_of: 0.0 }
    }
}

/// A task by its number.
pub(crate) fn number(id: &str) -> Option<lab_kit::answers::Task> {
    id.parse::<RegionId>().ok().map(|id| id.task)
}

/// The record in a file.
pub(crate) fn read(path: &Path) -> Result<Record> {
    let record: Record = serde_json::from_slice(&read_bytes(path)?)
        .with_context(|| format!("{} is no record", path.display()))?;
    ensure!(record.format == FORMAT, "{} is a record of another form", path.display());
    // It is written under its name, which could lead anywhere.
    let own = path.file_name().is_some_and(|name| *name == *format!("{}.json", record.name));
    ensure!(
        own,
        "{} is the record of '{}': name it after that",
        path.display(),
        line(&record.name)
    );
    Ok(record)
}

/// The records in a folder, by name.
pub(crate) fn read_all(folder: &Path) -> Result<Vec<Record>> {
    let mut records =
        files(folder)?.iter().map(|path| read(path)).collect::<Result<Vec<Record>>>()?;
    sort(&mut records);
    Ok(records)
}

/// Whether records of a lab can be written into a folder.
///
/// # Errors
/// It holds those of another lab.
pub(crate) fn expect_lab(folder: &Path, lab: Lab) -> Result<()> {
    if !folder.is_dir() {
        return Ok(());
    }
    // Those of another form are graded anew.
    for record in files(folder)?.iter().filter_map(|path| read(path).ok()) {
        let (folder, other) = (folder.display(), record.lab);
        ensure!(other == lab, "{folder} holds records of lab {other}: name another folder");
    }
    Ok(())
}

fn files(folder: &Path) -> Result<Vec<PathBuf>> {
    let unread = || format!("cannot read {}", folder.display());
    let entries = fs::read_dir(folder).with_context(unread)?;
    let mut files = entries
        .map(|entry| Ok(entry.with_context(unread)?.path()))
        .collect::<Result<Vec<PathBuf>>>()?;
    files.retain(|path| path.extension().is_some_and(|extension| extension == "json"));
    Ok(files)
}

/// Puts records in the order of their names.
pub(crate) fn sort(records: &mut [Record]) {
    records.sort_by_cached_key(|record| (record.name.to_lowercase(), record.name.clone()));
}

impl Record {
    /// Writes it into a folder, under its name.
    pub(crate) fn write(&self, folder: &Path) -> Result<()> {
        let text = serde_json::to_string_pretty(self)?;
        write_file(&folder.join(format!("{}.json", self.name)), &text)
    }

    /// As a page shows it: under its pseudonym, or else under its student's name.
    pub(crate) fn shown(&self) -> Self {
        let mut shown = self.clone();
        if let Some(pseudonym) = &self.pseudonym {
            shown.message = self.message.replace(&self.name, pseudonym);
        }
        let name = self.pseudonym.as_ref().or(self.student.as_ref());
        shown.name = name.unwrap_or(&self.name).clone();
        shown
    }

    /// Points that could be had in tasks, and in measures that are `among`.
    pub(crate) fn worth(&self, among: impl Fn(&Measure) -> bool) -> f64 {
        let measures = self.measures.iter().filter(|measure| among(measure));
        let measures: f64 = measures.map(|measure| measure.out_of).sum();
        self.tasks.iter().map(|task| task.out_of).sum::<f64>() + measures
    }

    /// Points that hang on times which could not be judged. Where there is no program, none do.
    pub(crate) fn open_points(&self) -> f64 {
        if self.status != Status::Graded {
            return 0.0;
        }
        let open = self.measures.iter().filter(|measure| !measure.counts());
        open.map(|measure| measure.out_of).fold(0.0, |sum, points| sum + points)
    }
}

/// The points that all of a class are marked out of, those among them that are open.
pub(crate) fn scale(records: &[Record]) -> f64 {
    let asked = |record: &Record| record.worth(|measure| measure.verdict != Verdict::NotTimed);
    let most = records.iter().map(asked).fold(0.0, f64::max);
    if most > 0.0 { most } else { 1.0 }
}

/// Points as people write them: 15, 7.5, 12.36.
pub(crate) fn points(points: f64) -> String {
    let text = format!("{points:.2}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

#[cfg(test)]
impl Record {
    /// Ada's, who has one of two tasks of lab 1.
    pub(crate) fn sample() -> Self {
        serde_json::from_str(include_str!("../../tests/record.json")).unwrap()
    }

    /// The same, with 25 points for speed that she does not have.
    pub(crate) fn sample_of_speed(verdict: Verdict) -> Self {
        let mut record = Self::sample();
        record.measures.push(Measure {
            kind: Kind::Speed,
            variant: "sorted".into(),
            verdict,
            message: String::new(),
            grade: None,
            points: 0.0,
            out_of: 25.0,
        });
        record
    }
}

#[cfg(test)]
mod tests {
    use super::{Record, expect_lab, read_all};

    #[test]
    fn a_folder_holds_the_records_of_one_lab() {
        let folder = tempfile::tempdir().unwrap();
        let (folder, [one, two]) = (folder.path(), ["1", "2"].map(|lab| lab.parse().unwrap()));
        expect_lab(&folder.join("none"), two).unwrap();
        Record::sample().write(folder).unwrap();
        expect_lab(folder, one).unwrap();
        let error = expect_lab(folder, two).unwrap_err().to_string();
        assert!(error.ends_with("holds records of lab 1: name another folder"), "{error}");
    }

    #[test]
    fn a_record_is_written_where_it_was_read() {
        let folder = tempfile::tempdir().unwrap();
        let folder = folder.path();
        Record::sample().write(folder).unwrap();
        let text = std::fs::read_to_string(folder.join("ada.json")).unwrap();
        let elsewhere = text.replace("\"name\": \"ada\"", "\"name\": \"../ada\"");
        assert_ne!(text, elsewhere);
        std::fs::write(folder.join("ada.json"), elsewhere).unwrap();
        let error = read_all(folder).unwrap_err().to_string();
        assert!(
            error.ends_with("ada.json is the record of '../ada': name it after that"),
            "{error}"
        );
    }
}
