//! What a measurement leaves behind: JSON and SVG files.

use std::path::PathBuf;

use anyhow::Result;
use clap::Args;
use serde::Serialize;

use super::chart::Chart;
use lab_kit::files::write_text;
use lab_kit::machine::{date, machine};

/// Where the numbers go besides the terminal.
#[derive(Args)]
pub struct Json {
    /// Write all numbers to this file as JSON
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
}

/// Where numbers and figure go besides the terminal.
#[derive(Args)]
pub struct Files {
    #[command(flatten)]
    json: Json,
    /// Draw the figure into this file
    #[arg(long, value_name = "FILE")]
    svg: Option<PathBuf>,
}

/// Results, and how to make them again.
#[derive(Serialize)]
struct Report<R> {
    command: String,
    machine: String,
    date: String,
    results: R,
}

impl Json {
    /// Writes the numbers if they were asked for, with the command, machine and date before them.
    ///
    /// # Errors
    /// The file cannot be written.
    pub fn write(&self, results: impl Serialize) -> Result<()> {
        let Some(path) = &self.json else { return Ok(()) };
        let report = Report { command: command(), machine: machine(), date: date(), results };
        write_text(path, &(serde_json::to_string_pretty(&report)? + "\n"))
    }
}

impl Files {
    /// Writes the files that were asked for, the charts one below the other.
    ///
    /// # Errors
    /// A file cannot be written.
    pub fn write(&self, results: impl Serialize, charts: &[Chart]) -> Result<()> {
        self.json.write(results)?;
        self.svg.as_ref().map_or(Ok(()), |path| write_text(path, &Chart::column(charts)))
    }
}

/// The command line that makes these results again.
fn command() -> String {
    let words = std::env::args().skip(1).map(|word| {
        let plain = |c: char| c.is_ascii_alphanumeric() || "-_=.,:/".contains(c);
        if word.chars().all(plain) { word } else { format!("'{word}'") }
    });
    format!("cargo lab {}", words.collect::<Vec<_>>().join(" "))
}
