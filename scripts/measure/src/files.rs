//! What a measurement leaves behind: JSON and SVG files. A figure is drawn from what the JSON file says, so that
//! it can be drawn again without measuring.

use std::path::{Path, PathBuf};

use anyhow::{Context, Result};
use clap::Args;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use serde_json::Value;

use super::chart::{Chart, Form, Sheet};
use lab_kit::files::{read_bytes, write_file};
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
#[derive(Deserialize, Serialize)]
pub struct Report<R = Value> {
    command: String,
    machine: String,
    date: String,
    /// What the command found.
    pub results: R,
}

impl Files {
    /// Writes the files that were asked for; `draw` makes the figure of what is written.
    ///
    /// # Errors
    /// As [`Self::again`], or a file cannot be written.
    pub fn write<R: DeserializeOwned>(
        &self,
        results: impl Serialize,
        draw: impl FnOnce(R) -> Result<Sheet>,
    ) -> Result<()> {
        let results = serde_json::to_value(results)?;
        self.json.write(&results)?;
        let figure = self.again(&results, draw)?;
        figure.map_or(Ok(()), |(path, sheet)| write_file(path, Chart::sheet(&sheet, Form::Page)))
    }

    /// The figure of results that were written, and its file; none if no file was asked for.
    ///
    /// # Errors
    /// These are not the results of such a command, or not what its options ask for.
    pub fn again<R: DeserializeOwned>(
        &self,
        results: &Value,
        draw: impl FnOnce(R) -> Result<Sheet>,
    ) -> Result<Option<(&Path, Sheet)>> {
        let file = self.svg.as_deref();
        file.map(|file| Ok((file, draw(R::deserialize(results)?)?))).transpose()
    }
}

impl Report {
    /// Reads what `--json` wrote.
    ///
    /// # Errors
    /// The file cannot be read, or is something else.
    pub fn read(path: &Path) -> Result<Self> {
        let unread = || format!("cannot read {}", path.display());
        serde_json::from_slice(&read_bytes(path)?).with_context(unread)
    }

    /// The words of the command line.
    pub fn words(&self) -> Vec<String> {
        let mut words = Vec::new();
        // Every other part stands between quotes.
        for (at, part) in self.command.split('\'').enumerate() {
            match at % 2 {
                0 => words.extend(part.split_whitespace().map(Into::into)),
                _ => words.push(part.into()),
            }
        }
        words
    }
}

impl Json {
    /// Writes the numbers if they were asked for, with the command, machine and date before them.
    ///
    /// # Errors
    /// The file cannot be written.
    pub fn write(&self, results: impl Serialize) -> Result<()> {
        let Some(path) = &self.json else { return Ok(()) };
        let report = Report { command: command(), machine: machine(), date: date(), results };
        write_file(path, serde_json::to_string_pretty(&report)? + "\n")
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
