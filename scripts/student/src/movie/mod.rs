//! `cargo lab movie`: a run as a web page that plays.

mod frames;

use std::fs;
use std::path::PathBuf;
use std::process::{Command, ExitCode, Stdio};

use anyhow::{Context, Result, ensure};
use clap::Args;
use common::soft::{CUTOFF, DT};
use oracle::mpiexec::Launcher;
use serde_json::json;

use lab_kit::files::write_text;
use lab_kit::program::{Binaries, Program};
use lab_kit::{Kit, Lab};

/// More discs in all frames than this make a page that a browser struggles with.
const MOST: u64 = 1_000_000;
/// Soft discs are shown at every second step.
const EVERY: u32 = 2;
/// Hard discs have this radius, these speeds and so much room each that they move about.
const RADIUS: f64 = 1.0;
const SPEEDS: &str = "0.3,2";
const ROOM: f64 = 36.0;

/// Show a run as a web page that plays
///
/// Runs a variant and writes one page without anything else to load: discs coloured by speed, with
/// bins, a list, owners and free flights to switch on; play, pause, step and a slider.
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
    /// Number of discs
    #[arg(short, default_value_t = 500, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    n: u32,
    /// Number of time steps; every second one of soft discs is shown
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
    let is_hard = program.is_hard();
    let every = if is_hard { 1 } else { EVERY };
    let frames = u64::from(options.steps.div_ceil(every));
    ensure!(
        frames * u64::from(options.n) <= MOST,
        "{frames} frames of {} discs are too many for a page: at most {MOST} in all",
        options.n
    );
    let binaries = Binaries::build(kit, [&program])?;
    let binary = binaries.of(&program)?;
    let folder = tempfile::tempdir()?;
    let [file, input] = ["frames.txt", "scene.txt"].map(|name| folder.path().join(name));
    let mut command = match program.has_ranks() {
        true => Launcher::find()?.start(2, binary),
        false => Command::new(binary),
    };
    let side = (ROOM * f64::from(options.n)).sqrt();
    if is_hard {
        let scene = format!("{} {side} {RADIUS} {} print\n", options.n, options.steps);
        fs::write(&input, scene).context("cannot write the scene")?;
        command.arg(&input).args(["-s", "1", "--speeds", SPEEDS]);
    } else {
        command.args(["-s", "1", "--full", "--every", &EVERY.to_string()]);
        command.args(["-n", &options.n.to_string(), "--steps", &options.steps.to_string()]);
    }
    command.arg("-o").arg(&file);
    if let Some(variant) = &options.variant {
        command.args(["--variant", variant]);
    }
    let status = command.stdout(Stdio::null()).status().context("the lab did not start")?;
    if !status.success() {
        return Ok(ExitCode::FAILURE);
    }
    let text = fs::read_to_string(&file).context("the lab wrote no positions")?;
    let movie = if is_hard { frames::hard(&text, side)? } else { frames::soft(&text)? };
    let data = json!({
        "title": format!("{program}, {} discs", options.n),
        "kind": if is_hard { "hard" } else { "soft" },
        "size": movie.size, "radius": if is_hard { RADIUS } else { CUTOFF / 2.0 },
        "dt": if is_hard { 1.0 } else { DT }, "between": every,
        // The first frame of soft discs is that after their first step.
        "first": if is_hard { 0 } else { 1 },
        "grid": frames::GRID, "fastest": movie.fastest, "frames": movie.frames,
        "energy": movie.energy, "touching": movie.touching,
    });
    // The book's boxes are played by the same scripts.
    let script = |name| {
        let path = kit.path("book/src/live").join(name);
        fs::read_to_string(&path).with_context(|| format!("cannot read {}", path.display()))
    };
    let scripts = ["random.js", "soft.js", "searches.js", "player.js"].map(script);
    let player = scripts.into_iter().collect::<Result<String>>()?;
    // A name in the data must not end the script that it stands in.
    let page = include_str!("page.html")
        .replace("PLAYER", &player)
        .replace("\"MOVIE\"", &data.to_string().replace('<', "\\u003c"));
    write_text(&options.output, &page)?;
    println!("Open {} in a browser.", options.output.display());
    Ok(ExitCode::SUCCESS)
}
