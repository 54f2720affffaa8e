//! What a measurement leaves behind: JSON and SVG files.

use std::path::{Path, PathBuf};

use anyhow::Result;
use clap::Args;
use serde_json::{Value, json};

use super::chart::Chart;
use lab_kit::files::write_text;
use lab_kit::machine::{date, machine};

/// Where the results go besides the terminal.
#[derive(Args)]
pub struct Files {
    /// Write all numbers to this file as JSON
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Draw the figure into this file
    #[arg(long, value_name = "FILE")]
    svg: Option<PathBuf>,
}

impl Files {
    /// Writes the files that were asked for, the charts one below the other.
    pub fn write(&self, results: Value, charts: &[Chart]) -> Result<()> {
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
pub fn write_json(path: &Path, results: Value) -> Result<()> {
    let record = json!({
        "command": command(), "machine": machine(), "date": date(), "results": results,
    });
    write_text(path, &format!("{record:#}\n"))
}

/// The command line that makes these results again.
fn command() -> String {
    let words = std::env::args().skip(1).map(|word| {
        let plain = |c: char| c.is_ascii_alphanumeric() || "-_=.,:/".contains(c);
        if word.chars().all(plain) { word } else { format!("'{word}'") }
    });
    format!("cargo lab {}", words.collect::<Vec<_>>().join(" "))
}
