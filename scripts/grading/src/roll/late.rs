//! Deadline, hand-in times, and what a day costs.

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, ensure};
use jiff::civil::DateTime;
use jiff::tz::TimeZone;
use jiff::{Timestamp, Zoned};
use serde::de::Error;
use serde::{Deserialize, Deserializer};

use super::roster::table;
use crate::record::Lateness;
use lab_kit::Lab;

const DAY: f64 = 86_400.0;

/// The `[late]` table of `class.toml`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Late {
    /// As in `2026-11-20 23:59`: here, where no zone is given.
    #[serde(deserialize_with = "moment")]
    deadline: Timestamp,
    /// Minutes after the deadline that cost nothing.
    #[serde(default)]
    grace: f64,
    /// Per cent of the points for each day that has begun.
    penalty: f64,
    /// What comes after this number of days has no points; no end if not given.
    #[serde(default = "no_end")]
    days: u32,
    /// A CSV of students and times; the files' own times if not given.
    times: Option<PathBuf>,
    /// What it says.
    #[serde(skip)]
    listed: Vec<(String, Timestamp)>,
}

fn moment<'de, D: Deserializer<'de>>(text: D) -> Result<Timestamp, D::Error> {
    time(&String::deserialize(text)?).map_err(D::Error::custom)
}

fn no_end() -> u32 {
    u32::MAX
}

impl Late {
    /// Reads the times that it names, and sees whether the rest can be.
    pub(super) fn read(&mut self, folder: &Path) -> Result<()> {
        let Self { grace, penalty, .. } = self;
        ensure!(*grace >= 0.0, "late: grace: {grace} minutes cannot be");
        ensure!((0.0..=100.0).contains(penalty), "late: penalty: {penalty} % cannot be");
        if let Some(path) = &self.times {
            self.listed = listed(&folder.join(path))?;
        }
        Ok(())
    }

    /// Who handed in when, where a file says so.
    pub(super) fn listed(&self) -> impl Iterator<Item = (&str, Timestamp)> {
        self.listed.iter().map(|(who, time)| (who.as_str(), *time))
    }

    /// What a time costs; nothing if it is in time. `days` are what a person made of it.
    pub(super) fn lateness(&self, time: Option<Timestamp>, days: Option<u32>) -> Option<Lateness> {
        let after = time.map_or(0.0, |time| time.duration_since(self.deadline).as_secs_f64());
        let begun = if after > 60.0 * self.grace { (after / DAY).ceil() } else { 0.0 };
        let days = days.unwrap_or(begun as u32);
        let lost = if days > self.days { 1.0 } else { 0.01 * self.penalty * f64::from(days) };
        (days > 0).then(|| Lateness { days, lost: lost.min(1.0) })
    }
}

/// Two columns: whose, and when.
fn listed(path: &Path) -> Result<Vec<(String, Timestamp)>> {
    let (header, rows) = table(path)?;
    ensure!(
        header.len() == 2,
        "{}, line 1: it has {} columns, not two: student, time",
        path.display(),
        header.len()
    );
    let row = |(line, row): &(u64, csv::StringRecord)| {
        let location = || format!("{}, line {line}, column {}", path.display(), &header[1]);
        Ok((row[0].to_owned(), time(&row[1]).with_context(location)?))
    };
    rows.iter().map(row).collect()
}

fn time(text: &str) -> Result<Timestamp> {
    let text = text.trim();
    let zoned = text.parse::<Zoned>().map(|zoned| zoned.timestamp());
    let exact = zoned.or_else(|_| text.parse::<Timestamp>());
    let here = || text.parse::<DateTime>()?.to_zoned(TimeZone::system());
    exact
        .or_else(|_| here().map(|zoned| zoned.timestamp()))
        .ok()
        // A day alone would be its first moment.
        .filter(|_| text.contains(':'))
        .with_context(|| format!("'{text}' is no time such as 2026-11-20 23:59"))
}

/// When a submission to a lab was handed in, by the times of its files: the latest of a folder's. None
/// if it cannot be said.
pub(crate) fn file_time(path: &Path, lab: Lab) -> Option<Timestamp> {
    let metadata = fs::symlink_metadata(path).ok()?;
    if !metadata.is_dir() {
        return metadata.modified().ok()?.try_into().ok();
    }
    let source = path.join(format!("labs/lab{lab}/src"));
    let folder = if source.is_dir() { &source } else { path };
    let entries = fs::read_dir(folder).ok()?.filter_map(Result::ok);
    let files = entries.filter_map(|entry| entry.metadata().ok()).filter(|entry| entry.is_file());
    files.filter_map(|file| file.modified().ok()?.try_into().ok()).max()
}
