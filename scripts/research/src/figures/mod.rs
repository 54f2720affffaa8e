//! `cargo lab figures`: the book's pictures of the model, drawn from the model, and of measurements, drawn from
//! the numbers in book/data.

mod across;
mod bins;
mod border;
mod buffers;
mod canvas;
mod chain;
mod collision;
mod cone;
mod contact;
mod curves;
mod energy;
mod free;
mod ghosts;
mod hard_step;
mod idea;
mod jobs;
mod kicks;
mod lanes;
mod layouts;
mod levels;
mod lists;
mod measured;
mod messages;
mod regions;
mod rows;
mod scan;
mod scenes;
mod skin;
mod step;
mod swept;
mod threads;
mod triangle;

use std::path::Path;
use std::process::ExitCode;

use anyhow::{Context, Result};
use clap::Args;

use lab_kit::Kit;
use lab_kit::files::write_file;

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
type Figure = (&'static str, fn() -> Result<String>);

const FIGURES: [Figure; 40] = [
    ("idea.svg", idea::idea),
    ("force.svg", curves::force),
    ("potential.svg", curves::potential),
    ("energy.svg", energy::time_steps),
    ("scene.svg", scenes::official),
    ("crowd.svg", scenes::crowd),
    ("stencils.svg", bins::stencils),
    ("widths.svg", bins::widths),
    ("collision.svg", collision::contact),
    ("exchange.svg", collision::exchange),
    ("hard-step.svg", hard_step::one_step),
    ("hard-steps.svg", hard_step::nine_steps),
    ("levels.svg", levels::levels),
    ("jobs.svg", jobs::jobs),
    ("rows.svg", rows::rows),
    ("gather.svg", buffers::gather),
    ("scatter.svg", buffers::scatter),
    ("stale-ghost.svg", ghosts::stale),
    ("two-sends.svg", messages::two_sends),
    ("halo.svg", messages::halo),
    ("recut.svg", rows::recut),
    ("list.svg", idea::listed),
    ("free.svg", free::window),
    ("contact.svg", contact::three),
    ("ghost-width.svg", border::width),
    ("steps-of-a-list.svg", messages::steps_of_a_list),
    ("deep-ghosts.svg", cone::shrinks),
    ("two-loops.svg", step::two_loops),
    ("layouts.svg", layouts::layouts),
    ("barriers.svg", threads::step_with_buffers),
    ("cache-lines.svg", threads::cache_lines),
    ("regions.svg", regions::locks),
    ("schedules.svg", triangle::schedules),
    ("rounds.svg", chain::rounds),
    ("prefix-sum.svg", scan::rounds),
    ("skin.svg", skin::ageing),
    ("across.svg", across::cut),
    ("swept.svg", swept::boxes),
    ("short-list.svg", lists::short_in_long),
    ("kicks.svg", kicks::compositions),
];

/// Draws all, or compares all with what is there.
pub(crate) fn run(kit: &Kit, options: Options) -> Result<ExitCode> {
    let mut drifted = false;
    let mut figures = measured::all(kit)?;
    for (name, draw) in FIGURES {
        let svg = draw().with_context(|| format!("cannot draw {name}"))?;
        figures.push((Path::new("book/src/figures").join(name), svg));
    }
    for (path, svg) in figures {
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
    use super::FIGURES;

    #[test]
    fn every_picture_can_be_drawn_and_says_what_it_is() {
        for (name, draw) in FIGURES {
            let svg = draw().unwrap();
            assert!(svg.starts_with("<svg") && svg.contains("<title>"), "{name}");
            assert!(!svg.contains("NaN") && !svg.contains("inf"), "{name}");
        }
    }
}
