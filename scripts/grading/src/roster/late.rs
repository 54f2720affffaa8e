//! Deadline, hand-in times, and penalties for late days.

use std::fs;
use std::path::{Path, PathBuf};
use std::str::FromStr;

use anyhow::{Context, Error, Result, ensure};
use jiff::civil::DateTime;
use jiff::tz::TimeZone;
use jiff::{Timestamp, ToSpan, Unit, ZonedDateTime};
use serde::de::Error as _;
use serde::{Deserialize, Deserializer};

use super::students::table;
use crate::record::Lateness;
use lab_kit::Lab;

/// The `[late]` table of `class.toml`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Late {
    /// Deadline, such as `2026-11-20 23:59`.
    deadline: Moment,
    /// The course's time zone, such as `Europe/Berlin`; this machine's time zone if the entry is
    /// missing.
    zone: Option<String>,
    /// Minutes after the deadline without a penalty.
    #[serde(default)]
    grace: f64,
    /// Penalty for each day that has begun, in per cent of the points.
    penalty: f64,
    /// Number of days after which a submission gets no points; unlimited if the entry is missing.
    days: Option<u32>,
    /// Path of a CSV file with students and hand-in times. Without it, the modification times of
    /// the submitted files count.
    times: Option<PathBuf>,
    /// Students and times from the file of times.
    #[serde(skip)]
    listed: Vec<(String, Timestamp)>,
    /// Deadline in the course's time zone.
    #[serde(skip)]
    due: Option<ZonedDateTime>,
}

impl Late {
    /// Reads the file of times, and checks the other settings.
    pub(super) fn read(&mut self, folder: &Path) -> Result<()> {
        let Self { grace, penalty, .. } = self;
        ensure!(*grace >= 0.0, "late: grace: {grace} minutes cannot be");
        ensure!((0.0..=100.0).contains(penalty), "late: penalty: {penalty} % cannot be");
        let zone = match &self.zone {
            None => TimeZone::system(),
            Some(name) => TimeZone::get(name).ok().with_context(|| {
                format!("late: zone: there is no time zone '{name}'; one is Europe/Berlin")
            })?,
        };
        self.due = Some(self.deadline.at(&zone)?);
        if let Some(path) = &self.times {
            self.listed = listed(&folder.join(path), &zone)?;
        }
        Ok(())
    }

    /// Returns the rows of the file of times: a student or submission, and a time.
    pub(super) fn listed(&self) -> impl Iterator<Item = (&str, Timestamp)> {
        self.listed.iter().map(|(who, time)| (who.as_str(), *time))
    }

    /// Formats the deadline with its time zone.
    pub(super) fn words(&self) -> Option<String> {
        let due = self.due.as_ref()?;
        let zone = due.time_zone().iana_name().unwrap_or("this machine's time zone");
        Some(format!("{} ({zone})", due.strftime("%Y-%m-%d %H:%M, UTC%:z")))
    }

    /// Computes the lateness of a submission from its hand-in time; `None` if it is in time. If
    /// `days` is given, it is the number of days late.
    pub(super) fn lateness(&self, time: Option<Timestamp>, days: Option<u32>) -> Option<Lateness> {
        let begun = time.zip(self.due.as_ref()).map_or(0, |(time, due)| self.begun(time, due));
        let days = days.unwrap_or(begun);
        let is_over = self.days.is_some_and(|most| days > most);
        let lost = if is_over { 1.0 } else { 0.01 * self.penalty * f64::from(days) };
        (days > 0).then(|| Lateness { days, lost: lost.min(1.0) })
    }

    /// Counts the days that have begun since the deadline.
    ///
    /// Days are days of the calendar: a day with a clock change has 23 or 25 hours. Seconds do not
    /// count, so a deadline of 23:59 lasts until midnight.
    fn begun(&self, time: Timestamp, due: &ZonedDateTime) -> u32 {
        let time = to_the_minute(&time.to_zoned_datetime(due.time_zone().clone()));
        let due = to_the_minute(due);
        if time.duration_since(&due).as_secs_f64() <= 60.0 * self.grace {
            return 0;
        }
        let full_days = due.until((Unit::Day, &time)).map_or(0, |span| span.get_days());
        let begins = due.checked_add(full_days.days()).is_ok_and(|begins| begins < time);
        u32::try_from(full_days).unwrap_or(0) + u32::from(begins)
    }
}

fn to_the_minute(time: &ZonedDateTime) -> ZonedDateTime {
    time.with().second(0).subsec_nanosecond(0).build().unwrap_or_else(|_| time.clone())
}

/// Reads a table of two columns: student and time.
fn listed(path: &Path, zone: &TimeZone) -> Result<Vec<(String, Timestamp)>> {
    let (header, rows) = table(path)?;
    ensure!(
        header.len() == 2,
        "{}, line 1: it has {} columns, not two: student, time",
        path.display(),
        header.len()
    );
    let mut times = Vec::new();
    for (line, row) in rows {
        let time = row[1].parse::<Moment>().map_err(Error::msg).and_then(|time| time.at(zone));
        let time = time
            .with_context(|| format!("{}, line {line}, column {}", path.display(), &header[1]))?;
        times.push((row[0].to_owned(), time.timestamp()));
    }
    Ok(times)
}

/// A time as a person writes it.
#[derive(Debug)]
enum Moment {
    /// A time with its zone or its offset from UTC.
    Exact(Timestamp),
    /// A time in the course's zone.
    Clock(DateTime),
}

impl Moment {
    fn at(&self, zone: &TimeZone) -> Result<ZonedDateTime> {
        Ok(match self {
            Self::Exact(time) => time.to_zoned_datetime(zone.clone()),
            Self::Clock(time) => time.to_zoned_datetime(zone.clone())?,
        })
    }
}

impl FromStr for Moment {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let text = text.trim();
        let zoned = text.parse::<ZonedDateTime>().map(|zoned| zoned.timestamp());
        let exact = zoned.or_else(|_| text.parse::<Timestamp>()).map(Self::Exact);
        exact
            .or_else(|_| text.parse::<DateTime>().map(Self::Clock))
            .ok()
            // A date without a time would mean the beginning of that day.
            .filter(|_| text.contains(':'))
            .ok_or_else(|| format!("'{text}' is no time such as 2026-11-20 23:59"))
    }
}

impl<'de> Deserialize<'de> for Moment {
    fn deserialize<D: Deserializer<'de>>(text: D) -> Result<Self, D::Error> {
        String::deserialize(text)?.parse().map_err(D::Error::custom)
    }
}

/// Returns the modification time of an archive, or the latest time of the files in a folder. `None`
/// if there is no time.
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
