//! Files of a measurement: numbers as JSON, a figure as SVG.
//!
//! A figure is drawn from the numbers in the JSON file, so it can be drawn again without measuring.

use std::path::{Path, PathBuf};

use anyhow::{Context, Result};
use clap::Args;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use serde_json::Value;

use super::chart::{Form, Sheet, svg};
use lab_kit::files::{read_bytes, write_file};
use lab_kit::machine::{date, machine};

/// The file of the numbers, as an option.
#[derive(Args)]
pub struct Json {
    /// Write all numbers to this file as JSON
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
}

/// The files of the numbers and of the figure, as options.
#[derive(Args)]
pub(crate) struct Files {
    #[command(flatten)]
    json: Json,
    /// Draw the figure to this file
    #[arg(long, value_name = "FILE")]
    svg: Option<PathBuf>,
}

/// Contents of a file of numbers: the results, and the command that reproduces them.
#[derive(Deserialize, Serialize)]
pub struct DataFile<R = Value> {
    command: String,
    /// The machine and the date; empty if the results do not depend on them.
    #[serde(default)]
    machine: String,
    #[serde(default)]
    date: String,
    /// The results of the command.
    pub results: R,
}

impl Files {
    /// Writes the files that the user has named; `draw` makes the figure from the written numbers.
    pub(crate) fn write<R: DeserializeOwned>(
        &self,
        results: impl Serialize,
        draw: impl FnOnce(R) -> Result<Sheet>,
    ) -> Result<()> {
        let results = serde_json::to_value(results)?;
        self.json.write(&results)?;
        match self.again(&results, draw)? {
            Some((path, sheet)) => write_file(path, svg(&sheet, Form::Page)),
            None => Ok(()),
        }
    }

    /// Returns the figure of results that were written earlier, and the path of the figure's file.
    /// `None` if the user has named no figure.
    pub(crate) fn again<R: DeserializeOwned>(
        &self,
        results: &Value,
        draw: impl FnOnce(R) -> Result<Sheet>,
    ) -> Result<Option<(&Path, Sheet)>> {
        let Some(file) = self.svg.as_deref() else { return Ok(None) };
        Ok(Some((file, draw(R::deserialize(results)?)?)))
    }
}

impl DataFile {
    /// Reads a file that `--json` wrote.
    ///
    /// # Errors
    /// The file cannot be read, or its contents are not of this type.
    pub fn read(path: &Path) -> Result<Self> {
        serde_json::from_slice(&read_bytes(path)?)
            .with_context(|| format!("cannot read {}", path.display()))
    }

    /// Returns the words of the command line.
    pub fn words(&self) -> Vec<String> {
        let mut words = Vec::new();
        // The parts with odd indices are between quotes.
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
    /// Writes the numbers of a command of `cargo lab` to the user's file, if there is one.
    ///
    /// The command, the machine and the date precede the numbers.
    ///
    /// # Errors
    /// The file cannot be written.
    pub fn write(&self, results: impl Serialize) -> Result<()> {
        self.write_by("cargo lab", results)
    }

    /// Writes the numbers of any program; its command line begins with `program`.
    ///
    /// # Errors
    /// The file cannot be written.
    pub fn write_by(&self, program: &str, results: impl Serialize) -> Result<()> {
        let Some(path) = &self.json else { return Ok(()) };
        let command = command_of(program);
        let file = DataFile { command, machine: machine(), date: date(), results };
        write_file(path, serde_json::to_string_pretty(&file)? + "\n")
    }
}

/// Returns the command line that makes these results again.
fn command_of(program: &str) -> String {
    let mut command = program.to_owned();
    for word in std::env::args().skip(1) {
        let is_plain = word.chars().all(|c| c.is_ascii_alphanumeric() || "-_=.,:/".contains(c));
        command += &if is_plain { format!(" {word}") } else { format!(" '{word}'") };
    }
    command
}
