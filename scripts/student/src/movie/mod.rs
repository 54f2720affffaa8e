//! `cargo lab movie`: a run as a web page that plays.

mod frames;

use std::path::PathBuf;
use std::process::{Command, ExitCode, Stdio};

use anyhow::{Context, Result, ensure};
use clap::Args;
use common::soft::CUTOFF;
use oracle::mpiexec::Launcher;
use serde_json::json;

use lab_kit::files::write_text;
use lab_kit::program::{Binaries, Program};
use lab_kit::{Kit, Lab};

/// More numbers than this make a page that a browser struggles with.
const MOST: u64 = 4_000_000;

/// Show a run as a web page that plays
///
/// Runs a variant of soft discs and writes one page without anything else to load: particles
/// coloured by speed, with the cutoff and the bins to switch on, pause, step and a slider.
#[derive(Args)]
pub(crate) struct Options {
    /// The lab, such as 2
    lab: Lab,
    /// Show the solution instead of your own work
    #[arg(long)]
    solution: bool,
    /// The variant [default: the first]
    #[arg(long, value_name = "NAME")]
    variant: Option<String>,
    /// Number of particles
    #[arg(short, default_value_t = 500, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    n: u32,
    /// Number of time steps; every second one is shown
    #[arg(long, default_value_t = 400, value_name = "STEPS", value_parser = clap::value_parser!(u32).range(1..))]
    steps: u32,
    /// The page
    #[arg(short, default_value = "movie.html", value_name = "FILE")]
    output: PathBuf,
}

/// Runs the variant and writes the page.
pub(crate) fn run(kit: &Kit, options: Options) -> Result<ExitCode> {
    let mut program = Program::new(options.lab, options.solution)?;
    program.variant.clone_from(&options.variant);
    ensure!(!program.is_hard(), "lab {} is of hard discs: only soft ones are shown", options.lab);
    let frames = u64::from(options.steps.div_ceil(2));
    ensure!(
        frames * u64::from(options.n) <= MOST,
        "{frames} frames of {} particles are too many for a page: at most {MOST} in all",
        options.n
    );
    let binaries = Binaries::build(kit, [&program])?;
    let binary = binaries.of(&program)?;
    let folder = tempfile::tempdir()?;
    let file = folder.path().join("frames.txt");
    let mut command = match program.has_ranks() {
        true => Launcher::find()?.start(2, binary),
        false => Command::new(binary),
    };
    command.args(["-s", "1", "--full", "--every", "2", "-n", &options.n.to_string()]);
    command.args(["--steps", &options.steps.to_string(), "-o"]).arg(&file);
    if let Some(variant) = &options.variant {
        command.args(["--variant", variant]);
    }
    let status = command.stdout(Stdio::null()).status().context("the lab did not start")?;
    if !status.success() {
        return Ok(ExitCode::FAILURE);
    }
    let text = std::fs::read_to_string(&file).context("the lab wrote no positions")?;
    let movie = frames::read(&text)?;
    let title = format!("{program}, {} particles", options.n);
    let data = json!({
        "title": title, "size": movie.size, "cutoff": CUTOFF, "grid": frames::GRID,
        "fastest": movie.fastest, "frames": movie.frames,
    });
    // A name in the data must not end the script that it stands in.
    let page =
        include_str!("page.html").replace("\"MOVIE\"", &data.to_string().replace('<', "\\u003c"));
    write_text(&options.output, &page)?;
    println!("Open {} in a browser.", options.output.display());
    Ok(ExitCode::SUCCESS)
}
