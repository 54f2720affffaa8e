//! Figures of measurements, from the numbers that the measuring commands wrote.

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result};
use clap::{Parser, Subcommand};
use lab_kit::Kit;
use lab_measure::chart::Sheet;
use lab_measure::commands;
use lab_measure::files::Report;
use serde_json::Value;

use crate::{forecast, greedy, model, precision, stress};

/// A command line that stands in a file of numbers.
#[derive(Parser)]
struct Line {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    #[command(flatten)]
    Measured(commands::Command),
    Precision(precision::Options),
    Stress(stress::Options),
    Model(model::Options),
    Forecast(forecast::Options),
    Greedy(greedy::Options),
}

/// Every file in book/data whose command draws a figure: the figure's name, and the figure.
///
/// # Errors
/// A file is no report of a command of the kit.
pub(super) fn all(kit: &Kit) -> Result<Vec<(String, Sheet)>> {
    let folder = kit.path("book/data");
    if !folder.is_dir() {
        // What students get has no numbers of ours.
        return Ok(Vec::new());
    }
    let mut files: Vec<PathBuf> = fs::read_dir(folder)
        .context("cannot read book/data")?
        .filter_map(|entry| Some(entry.ok()?.path()))
        .filter(|path| path.extension().is_some_and(|extension| extension == "json"))
        .collect();
    files.sort();
    let mut figures = Vec::new();
    for file in files {
        let report = Report::<Value>::read(&file)?;
        let words = report.words();
        // Only what draws; some commands have changed since, and their numbers stay true.
        if words.iter().any(|word| word == "--svg") {
            let figure = redraw(&words, &report.results);
            figures.extend(figure.with_context(|| format!("cannot draw {}", file.display()))?);
        }
    }
    Ok(figures)
}

fn redraw(words: &[String], results: &Value) -> Result<Option<(String, Sheet)>> {
    let Line { command } = Line::try_parse_from(&words[1..])?;
    let figure = match &command {
        Command::Measured(command) => command.redraw(results)?,
        Command::Precision(options) => options.files.again(results, |shown| options.draw(shown))?,
        Command::Stress(options) => options.files.again(results, |shown| options.draw(shown))?,
        Command::Model(options) => options.files.again(results, |shown| options.draw(shown))?,
        Command::Forecast(options) => options.files.again(results, |shown| options.draw(shown))?,
        Command::Greedy(options) => options.files.again(results, |shown| options.draw(shown))?,
    };
    let name = |file: &Path| Some(file.file_name()?.to_string_lossy().into_owned());
    Ok(figure.and_then(|(file, sheet)| Some((name(file)?, sheet))))
}
