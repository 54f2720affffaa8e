//! What a measurement leaves behind: JSON and SVG files, and where and when it was taken.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::{SystemTime, UNIX_EPOCH};

use anyhow::{Context, Result};
use clap::Args;
use serde_json::{Value, json};

use super::chart::Chart;
use super::rounds::cores;

/// Where the results go besides the terminal.
#[derive(Args)]
pub(crate) struct Files {
    /// Write all numbers to this file as JSON
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Draw the figure into this file
    #[arg(long, value_name = "FILE")]
    svg: Option<PathBuf>,
}

impl Files {
    /// Writes the files that were asked for, the charts one below the other.
    pub(crate) fn write(&self, results: Value, charts: &[Chart]) -> Result<()> {
        if let Some(path) = &self.json {
            write_json(path, results)?;
        }
        if let Some(path) = &self.svg {
            write_text(path, &Chart::column(charts))?;
        }
        Ok(())
    }
}

/// Writes results with the command, machine and date before them.
pub(crate) fn write_json(path: &Path, results: Value) -> Result<()> {
    let record = json!({
        "command": command(), "machine": machine(), "date": date(), "results": results,
    });
    write_text(path, &format!("{record:#}\n"))
}

/// Writes a text file whole or not at all, and its folder if there is none.
pub(crate) fn write_text(path: &Path, text: &str) -> Result<()> {
    let write = || {
        if let Some(folder) = path.parent() {
            fs::create_dir_all(folder)?;
        }
        common::write_whole(path, |out| out.write_all(text.as_bytes()))
    };
    write().with_context(|| format!("cannot write {}", path.display()))
}

/// The command line that makes these results again.
fn command() -> String {
    let words = std::env::args().skip(1).map(|word| {
        let plain = |c: char| c.is_ascii_alphanumeric() || "-_=.,:/".contains(c);
        if word.chars().all(plain) { word } else { format!("'{word}'") }
    });
    format!("cargo lab {}", words.collect::<Vec<_>>().join(" "))
}

/// Processor and number of cores.
pub(crate) fn machine() -> String {
    let cpuinfo = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let model = cpuinfo.lines().find_map(|line| line.strip_prefix("model name")?.split_once(':'));
    let model = model.map_or(std::env::consts::ARCH, |(_, name)| name.trim());
    format!("{model}, {} cores", cores())
}

/// Today's date in UTC, as 2026-11-21.
pub(crate) fn date() -> String {
    let seconds = SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |since| since.as_secs());
    civil(seconds / 86_400)
}

/// The date of a day counted from 1970-01-01, by leap years of the Gregorian calendar.
fn civil(mut days: u64) -> String {
    let leap = |year: u64| {
        year.is_multiple_of(4) && (!year.is_multiple_of(100) || year.is_multiple_of(400))
    };
    let mut year = 1970;
    while days >= 365 + u64::from(leap(year)) {
        days -= 365 + u64::from(leap(year));
        year += 1;
    }
    let february = 28 + u64::from(leap(year));
    let mut month = 1;
    for length in [31, february, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31] {
        if days < length {
            break;
        }
        days -= length;
        month += 1;
    }
    format!("{year}-{month:02}-{:02}", days + 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn days_become_dates() {
        for (day, text) in [
            (0, "1970-01-01"),
            (58, "1970-02-28"),
            (59, "1970-03-01"),
            (789, "1972-02-29"),
            (11_016, "2000-02-29"),
            (20_778, "2026-11-21"),
            (20_818, "2026-12-31"),
        ] {
            assert_eq!(civil(day), text);
        }
    }

    #[test]
    fn a_folder_is_made_for_a_file() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("figures/a.svg");
        write_text(&path, "text").unwrap();
        assert_eq!(fs::read_to_string(&path).unwrap(), "text");
        let error = write_text(&path.join("below/a/file"), "text").unwrap_err();
        assert!(error.to_string().starts_with("cannot write"), "{error}");
    }
}
