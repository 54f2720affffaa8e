//! `cargo lab movie`: writes a run as a web page that plays it.

mod frames;
mod page;

use std::fs;
use std::path::PathBuf;
use std::process::{ExitCode, Stdio};

use anyhow::{Context, Result, bail, ensure};
use clap::Args;
use common::soft::{CUTOFF, DT};

use lab_kit::binaries::{Binaries, Known};
use lab_kit::files::write_file;
use lab_kit::program::Program;
use lab_kit::{Discs, Kit, Lab, system};

/// Steps between frames of soft discs, if the page has space for them; for hard discs it is one.
const EVERY: u32 = 2;
/// Default number of steps, for soft and for hard discs. Soft discs move little in a step, hard
/// discs by their diameter.
const STEPS: [u32; 2] = [300, 100];
/// Radius of hard discs.
const RADIUS: f64 = 1.0;
/// Least and greatest velocity component of hard discs.
const SPEEDS: &str = "0.3,2";
/// Area of the square for each hard disc, which is large enough for the disc to move about.
const ROOM: f64 = 36.0;
/// Number of owners that are shown for a run without ranks, unless the user sets the threads.
const OWNERS: u16 = 4;

/// Show a run as a web page that plays
///
/// Runs a variant and writes one page of less than 1 MB, which loads no other file. The page shows
/// discs coloured by speed, with time, energy and pairs. You can switch on bins, pair tests, pairs
/// in contact, owners, ghosts, a list and free flights, and play, pause, step and change the speed.
/// If there is no room for all frames, the page shows fewer and says so.
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
    /// Number of time steps; every second one of soft discs is shown [default: 300 of soft discs, 100 of hard]
    #[arg(long, value_name = "STEPS", value_parser = clap::value_parser!(u32).range(1..))]
    steps: Option<u32>,
    /// Number of ranks, for labs with messages [default: 2]
    #[arg(short, long, value_name = "RANKS", value_parser = clap::value_parser!(u16).range(1..))]
    ranks: Option<u16>,
    /// Number of threads [default: one per core]
    #[arg(short, long, value_name = "THREADS", value_parser = clap::value_parser!(u16).range(1..))]
    threads: Option<u16>,
    /// Adjust a parameter of the variant
    #[arg(long, value_name = "NAME=VALUE")]
    param: Vec<String>,
    /// The page
    #[arg(short, default_value = "movie.html", value_name = "FILE")]
    output: PathBuf,
}

/// Runs the variant and writes the page.
pub(crate) fn run(kit: &Kit, options: Options) -> Result<ExitCode> {
    let lab = options.lab;
    system::expect(kit, lab)?;
    let program = Program::new(lab, options.solution)?;
    let has_ranks = program.has_ranks();
    ensure!(has_ranks || options.ranks.is_none(), "lab {lab} has no ranks: leave --ranks out");
    let binaries = Binaries::build(kit, std::slice::from_ref(&program))?;
    let ranks = options.ranks.unwrap_or(2);
    let (program, variant) = choose(&program, &binaries, options.variant.as_deref())?;

    let discs = program.discs;
    let is_hard = discs == Discs::Hard;
    let steps = options.steps.unwrap_or(STEPS[usize::from(is_hard)]);
    let n = options.n as usize;
    let usual = if is_hard { 1 } else { EVERY };
    let every = spacing(n, steps, usual)
        .with_context(|| format!("{n} discs are too many for a page of less than 1 MB"))?;

    let folder = tempfile::tempdir()?;
    let file = folder.path().join("frames.txt");
    let side = (ROOM * f64::from(options.n)).sqrt();
    let mut command = binaries.start(&program, ranks.into())?;
    if is_hard {
        let input = folder.path().join("scene.txt");
        let scene = format!("{n} {side} {RADIUS} {steps} print\n");
        fs::write(&input, scene).context("cannot write the scene")?;
        command.arg(&input).args(["-s", "1", "--speeds", SPEEDS]);
    } else {
        command.args(["-s", "1", "--full", "--every", &every.to_string()]);
        command.args(["-n", &n.to_string(), "--steps", &steps.to_string()]);
    }
    command.args(["--variant", &variant]).arg("-o").arg(&file);
    command.args(options.param.iter().flat_map(|param| ["--param", param]));
    command.args(options.threads.iter().flat_map(|threads| ["-t".into(), threads.to_string()]));
    let status = command.stdin(Stdio::null()).stdout(Stdio::null()).status();
    if !status.context("the lab did not start")?.success() {
        return Ok(ExitCode::FAILURE);
    }
    let text = fs::read_to_string(&file).context("the lab wrote no positions")?;
    let movie = if is_hard { frames::hard(&text, side, every)? } else { frames::soft(&text)? };

    let run = page::Run {
        title: options.title(kit, &variant, has_ranks.then_some(ranks)),
        discs,
        radius: if is_hard { RADIUS } else { CUTOFF / 2.0 },
        dt: if is_hard { 1.0 } else { DT },
        // The first frame of soft discs shows them after their first step.
        first: u32::from(!is_hard),
        between: every,
        workers: if has_ranks { ranks } else { options.threads.unwrap_or(OWNERS) },
        shown: kit.facts(lab)?.movie,
    };
    write_file(&options.output, &page::write(kit, &run, &movie)?)?;
    if every > usual {
        println!(
            "To stay below 1 MB the page shows one in {every} of {steps} steps: fewer discs (-n) or steps (--steps) leave room for more."
        );
    }
    println!("Open {} in a browser.", options.output.display());
    Ok(ExitCode::SUCCESS)
}

impl Options {
    /// Returns the title of the page: lab, variant, ranks, and `the solution` if it is shown.
    fn title(&self, kit: &Kit, variant: &str, ranks: Option<u16>) -> String {
        let lab = self.lab;
        let whose = if self.solution { ", the solution" } else { "" };
        let on_ranks = ranks.map(|ranks| format!(" on {ranks} ranks")).unwrap_or_default();
        format!("Lab {lab}, {}: {variant}{on_ranks}{whose}", kit.title(lab))
    }
}

/// Returns the number of steps between two frames, at least `usual`.
///
/// Returns `None` if the page has no space for two frames.
fn spacing(n: usize, steps: u32, usual: u32) -> Option<u32> {
    let frames = page::room(n).checked_sub(1).filter(|more| *more > 0)?;
    Some((steps as usize).div_ceil(frames).max(usual as usize) as u32)
}

/// Finds the lab's program that has a variant, and the variant. Without a name it is the first
/// program's first variant.
fn choose(
    program: &Program,
    binaries: &Binaries,
    variant: Option<&str>,
) -> Result<(Program, String)> {
    let mut names = Vec::new();
    for program in [program.clone()].into_iter().chain(program.others()?) {
        for (program, Known { name, .. }) in binaries.variants(&program)? {
            if variant.is_none_or(|wanted| wanted == name) {
                return Ok((program, name));
            }
            names.push(name);
        }
    }
    let wanted = variant.unwrap_or_default();
    let package = program.package();
    bail!("there is no variant '{wanted}' in {package}; there are: {}", names.join(", "))
}

#[cfg(test)]
mod tests {
    use super::spacing;

    #[test]
    fn frames_are_left_out_only_where_there_is_no_room() {
        assert_eq!(spacing(500, 300, 2), Some(2));
        assert_eq!(spacing(500, 100, 1), Some(1));
        assert_eq!(spacing(500, 1000, 2), Some(7));
        assert_eq!(spacing(100_000, 10, 2), None);
    }
}
