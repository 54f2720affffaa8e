//! Figures of measurements, from the numbers that the measuring commands wrote.

use std::path::Path;

use anyhow::{Context, Result};
use clap::Parser;
use lab_kit::Kit;
use lab_kit::files::files_below;
use lab_measure::chart::Sheet;
use lab_measure::commands::Command;
use lab_measure::numbers::DataFile;

/// A command line in a file of numbers.
#[derive(Parser)]
struct Line {
    #[command(subcommand)]
    command: Command,
}

/// Draws a figure for every file in book/data whose command draws one. Returns the figures with
/// their names.
///
/// # Errors
/// A file was not written by a command of the kit.
pub(super) fn all(kit: &Kit) -> Result<Vec<(String, Sheet)>> {
    let mut files = files_below(&kit.path("book/data"))?;
    files.retain(|path| path.extension().is_some_and(|extension| extension == "json"));
    let mut figures = Vec::new();
    for path in files {
        let file = DataFile::read(&path)?;
        // A command without a figure may have changed since. Its numbers are still valid.
        if file.words().iter().any(|word| word == "--svg") {
            let figure = redraw(&file);
            figures.extend(figure.with_context(|| format!("cannot draw {}", path.display()))?);
        }
    }
    Ok(figures)
}

fn redraw(file: &DataFile) -> Result<Option<(String, Sheet)>> {
    let Line { command } = Line::try_parse_from(&file.words()[1..])?;
    let Some((path, sheet)) = command.redraw(&file.results)? else { return Ok(None) };
    let name = Path::new(path).file_name().context("a figure has a name")?;
    Ok(Some((name.to_string_lossy().into_owned(), sheet)))
}
