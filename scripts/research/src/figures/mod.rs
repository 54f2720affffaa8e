//! `cargo lab figures`: the book's charts, of the model and of the measurements in book/data. Drawings are edited
//! by hand and stand beside them.

mod charts;
mod measured;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use anyhow::{Context, Result};
use clap::Args;

use lab_kit::Kit;
use lab_kit::files::write_file;
use lab_measure::chart::{Chart, Form};

/// Draw the book's charts, of the model and of measurements
///
/// They go to book/src/figures. Nothing is measured: the numbers are those in book/data.
#[derive(Args)]
pub(crate) struct Options {
    /// Draw nothing; fail if a chart is not what would be drawn
    #[arg(long)]
    check: bool,
}

/// A chart's file in book/src/figures, and what draws it.
type Figure = (&'static str, fn() -> Result<Chart>);

/// Those of the model.
const CHARTS: [Figure; 3] = [
    ("force.svg", charts::force),
    ("potential.svg", charts::potential),
    ("energy.svg", charts::time_steps),
];

/// Every chart with its path in the kit, drawn twice: for pages, and for phones in a folder of their own.
fn all(kit: &Kit) -> Result<Vec<(PathBuf, String)>> {
    let folder = Path::new("book/src/figures");
    let mut charts = measured::all(kit)?;
    for (name, draw) in CHARTS {
        let chart = draw().with_context(|| format!("cannot draw {name}"))?;
        charts.push((name.into(), vec![vec![chart]]));
    }
    let mut figures = Vec::new();
    for (name, sheet) in charts {
        figures.push((folder.join(&name), Chart::sheet(&sheet, Form::Page)));
        figures.push((folder.join("phone").join(&name), Chart::sheet(&sheet, Form::Phone)));
    }
    Ok(figures)
}

/// Draws all, or compares all with what is there.
pub(crate) fn run(kit: &Kit, options: Options) -> Result<ExitCode> {
    let mut drifted = false;
    for (path, svg) in all(kit)? {
        let path = kit.path(path);
        if options.check {
            if std::fs::read_to_string(&path).ok().as_deref() != Some(&svg) {
                println!("{} is not what `cargo lab figures` draws", path.display());
                drifted = true;
            }
            continue;
        }
        write_file(&path, svg)?;
        println!("{}", path.display());
    }
    Ok(if drifted { ExitCode::FAILURE } else { ExitCode::SUCCESS })
}

#[cfg(test)]
mod tests {
    use lab_kit::Kit;
    use lab_kit::files::{files_below, read_text};

    use super::CHARTS;

    #[test]
    fn every_chart_of_the_model_can_be_drawn() {
        for (name, draw) in CHARTS {
            let svg = draw().unwrap().svg();
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
