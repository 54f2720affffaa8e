//! `cargo lab figures`: draws the book's charts of the model and of the numbers in book/data.
//!
//! Drawings are edited by hand and are in the same folder.

mod of_examples;
mod of_model;
mod of_numbers;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use anyhow::{Context, Result};
use clap::Args;
use lab_kit::Kit;
use lab_kit::files::write_file;
use lab_measure::chart::{Form, Sheet, svg};

/// Draw the book's charts, of the model and of measurements (for those who maintain the kit)
///
/// The charts are written to book/src/figures. Nothing is measured: the numbers are in book/data.
#[derive(Args)]
pub struct Options {
    /// Draw nothing, and fail if a chart differs from its file
    #[arg(long)]
    check: bool,
}

/// Draws all charts, or compares them with their files.
pub fn run(kit: &Kit, options: Options) -> Result<ExitCode> {
    let mut drifted = false;
    for (path, svg) in all(kit)? {
        let path = kit.path(path);
        if options.check {
            if std::fs::read_to_string(&path).ok().as_deref() != Some(&svg) {
                let path = path.display();
                println!("{path} differs from the figure that `cargo lab figures` draws");
                drifted = true;
            }
            continue;
        }
        write_file(&path, svg)?;
        println!("{}", path.display());
    }
    Ok(if drifted { ExitCode::FAILURE } else { ExitCode::SUCCESS })
}

/// Draws every chart twice: for pages, and for phones in another folder. Returns the charts with
/// their paths in the kit.
fn all(kit: &Kit) -> Result<Vec<(PathBuf, String)>> {
    let mut sheets: Vec<(String, Sheet)> = of_numbers::all(kit)?;
    for (name, draw) in of_examples::CHARTS {
        let numbers = kit.path("book/data").join(name).with_extension("json");
        let sheet = draw(&numbers).with_context(|| format!("cannot draw {name}.svg"))?;
        sheets.push((format!("{name}.svg"), sheet));
    }
    for (name, draw) in of_model::CHARTS {
        let chart = draw().with_context(|| format!("cannot draw {name}"))?;
        sheets.push((name.into(), vec![vec![chart]]));
    }
    let folder = Path::new("book/src/figures");
    let mut files = Vec::new();
    for (name, sheet) in sheets {
        files.push((folder.join(&name), svg(&sheet, Form::Page)));
        files.push((folder.join("phone").join(&name), svg(&sheet, Form::Phone)));
    }
    Ok(files)
}

#[cfg(test)]
mod tests {
    use lab_kit::Kit;
    use lab_kit::files::{files_below, read_text};
    use lab_measure::chart::{Form, svg};

    use super::of_model::CHARTS;

    #[test]
    fn every_chart_of_the_model_can_be_drawn() {
        for (name, draw) in CHARTS {
            let svg = svg(&[vec![draw().unwrap()]], Form::Page);
            assert!(!svg.contains("NaN") && !svg.contains("inf"), "{name}");
        }
    }

    #[test]
    fn every_picture_of_the_book_says_what_it_is() {
        let folder = Kit::find().unwrap().path("book/src/figures");
        for picture in files_below(&folder).unwrap() {
            let svg = read_text(&picture).unwrap();
            let is_one = svg.starts_with("<svg") && svg.contains("<title>");
            assert!(is_one, "{}", picture.display());
        }
    }
}
