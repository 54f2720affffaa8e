//! `cargo lab figures`: the book's pictures that are computed: of the model, from the model, and of measurements,
//! from the numbers in book/data. Drawings of ideas are edited by hand and stand beside them.

mod canvas;
mod contact;
mod curves;
mod energy;
mod free;
mod hard_step;
mod idea;
mod levels;
mod measured;
mod scenes;
mod swept;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use anyhow::{Context, Result};
use clap::Args;

use lab_kit::Kit;
use lab_kit::files::write_file;
use lab_measure::chart::{Chart, Form};

/// Draw the book's pictures, of the model and of measurements
///
/// They go to book/src/figures. Nothing is measured: the numbers are those in book/data.
#[derive(Args)]
pub(crate) struct Options {
    /// Draw nothing; fail if a picture is not what would be drawn
    #[arg(long)]
    check: bool,
}

/// A picture's file in book/src/figures, and what draws it.
type Figure<T> = (&'static str, fn() -> Result<T>);

const FIGURES: [Figure<String>; 10] = [
    ("idea.svg", idea::idea),
    ("scene.svg", scenes::official),
    ("crowd.svg", scenes::crowd),
    ("hard-step.svg", hard_step::one_step),
    ("hard-steps.svg", hard_step::nine_steps),
    ("levels.svg", levels::levels),
    ("list.svg", idea::listed),
    ("free.svg", free::window),
    ("contact.svg", contact::three),
    ("swept.svg", swept::boxes),
];

/// The same of charts.
const CHARTS: [Figure<Chart>; 3] = [
    ("force.svg", curves::force),
    ("potential.svg", curves::potential),
    ("energy.svg", energy::time_steps),
];

/// Every figure with its path in the kit. Charts are drawn twice: for pages, and for phones in a folder of their own.
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
    for (name, draw) in FIGURES {
        let svg = draw().with_context(|| format!("cannot draw {name}"))?;
        figures.push((folder.join(name), svg));
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

    use super::{CHARTS, FIGURES};

    fn expect_title(svg: &str, name: &str) {
        assert!(svg.starts_with("<svg") && svg.contains("<title>"), "{name}");
    }

    #[test]
    fn every_picture_can_be_drawn_and_says_what_it_is() {
        let charts = CHARTS.map(|(name, draw)| (name, draw().unwrap().svg()));
        let others = FIGURES.map(|(name, draw)| (name, draw().unwrap()));
        for (name, svg) in charts.into_iter().chain(others) {
            expect_title(&svg, name);
            assert!(!svg.contains("NaN") && !svg.contains("inf"), "{name}");
        }
    }

    #[test]
    fn every_picture_of_the_book_says_what_it_is() {
        let folder = Kit::find().unwrap().path("book/src/figures");
        for picture in files_below(&folder).unwrap() {
            expect_title(&read_text(&picture).unwrap(), &picture.display().to_string());
        }
    }
}
