//! The program around a lab of hard discs: its command line, its clock and its output.

use std::fs;
use std::io::{self, BufWriter, Read, Write};
use std::path::PathBuf;
use std::process::ExitCode;
use std::time::{Duration, Instant};

use clap::Parser;
use serde_json::json;

use super::{Disc, Mode, Problem, RandomScene, Simulation, read_problem, write_end, write_step};
use crate::program::{self, Choice, Complaint};
use crate::soft::general;
use crate::{Config, Variant, write_whole};

/// Number of discs that are read and written at a time.
const CHUNK: usize = 1 << 16;

/// Simulate hard discs: read N, L, r, S, print or perf, and optionally N lines 'i x y vx vy'
#[derive(Parser)]
#[command(arg_required_else_help = false)]
struct Options {
    /// The input file [default: standard input]
    input: Option<PathBuf>,
    /// Seed of the random discs, if the input lists no discs
    #[arg(short, default_value_t = 1, value_name = "SEED")]
    seed: u32,
    /// Least and greatest velocity component of random discs [default: L/(8r) and L/4]
    #[arg(long, value_name = "LEAST,GREATEST", value_parser = two_numbers)]
    speeds: Option<(f64, f64)>,
    /// Place random discs in a square of this side in the middle [default: the whole square]
    #[arg(long, value_name = "SIDE")]
    blob: Option<f64>,
    #[command(flatten)]
    choice: Choice,
}

/// Runs the program of a lab, from its command line to its exit code.
pub fn drive(variants: &[Variant<dyn Simulation>]) -> ExitCode {
    drive_on_rank(variants, true, |input| input.unwrap_or_default())
}

/// Runs the program of a lab as one of several processes with the same command line.
///
/// Every process calls it; only the `root` reads, prints and writes. `share` distributes the root's
/// input: the root calls it with the bytes, the other ranks call it with `None`, and it returns the
/// bytes to all.
pub fn drive_on_rank(
    variants: &[Variant<dyn Simulation>],
    root: bool,
    share: impl FnOnce(Option<Vec<u8>>) -> Vec<u8>,
) -> ExitCode {
    program::run(root, |options| run_lab(variants, options, root, share))
}

fn run_lab(
    variants: &[Variant<dyn Simulation>],
    options: &Options,
    root: bool,
    share: impl FnOnce(Option<Vec<u8>>) -> Vec<u8>,
) -> Result<(), Complaint> {
    if options.choice.list_variants {
        return if root { program::list(variants, options.choice.json) } else { Ok(()) };
    }
    let variant = options.choice.variant(variants)?;
    let config = options.choice.config(variant)?;
    let mut simulation = (variant.build)(&config).map_err(|e| e.to_string())?;

    let name =
        options.input.as_ref().map_or("standard input".into(), |path| path.display().to_string());
    let complaint = |e: &dyn std::fmt::Display| format!("{name}: {e}");
    // If the root cannot read the input, the other ranks receive an empty one, so that all ranks
    // fail.
    let (own, unreadable) = match root.then(|| bytes(options)).transpose() {
        Ok(own) => (own, None),
        Err(error) => (Some(Vec::new()), Some(complaint(&error))),
    };
    let input = share(own);
    if let Some(unreadable) = unreadable {
        return Err(unreadable);
    }
    let mut problem = read_problem(&input[..]).map_err(|e| complaint(&e))?;
    drop(input);
    let scene = problem
        .scene(options.seed, |random| adjusted(random, options))
        .map_err(|e| complaint(&e))?;
    simulation.load(&scene);
    drop(scene);

    let simulation = &mut *simulation;
    let seconds = match options.choice.output.as_deref().filter(|_| root) {
        Some(path) => write_whole(path, |out| simulate(simulation, &problem, root, Some(out)))
            .map(Some)
            .map_err(|e| format!("cannot write {}: {e}", path.display())),
        None if !root || options.choice.json => {
            // Reading is collective under MPI, so all ranks make the same decision to read.
            let mut nowhere = io::sink();
            let out: Option<&mut dyn Write> =
                (!options.choice.json || options.choice.output.is_some()).then_some(&mut nowhere);
            simulate(simulation, &problem, root, out).map(Some).map_err(|e| e.to_string())
        }
        None => {
            let mut out = BufWriter::new(io::stdout().lock());
            let seconds = simulate(simulation, &problem, root, Some(&mut out));
            program::none_if_closed(seconds.and_then(|s| out.flush().map(|()| s)))
        }
    }?;
    let counters = simulation.counters();
    let events = simulation.events();
    match seconds {
        Some(seconds) if root => {
            options.choice.write_events(variant.name, events)?;
            report(variant, &config, counters, &problem, options, seconds)
        }
        _ => Ok(()),
    }
}

fn bytes(options: &Options) -> io::Result<Vec<u8>> {
    match &options.input {
        Some(path) => fs::read(path),
        None => {
            let mut bytes = Vec::new();
            io::stdin().lock().read_to_end(&mut bytes)?;
            Ok(bytes)
        }
    }
}

fn adjusted(mut random: RandomScene, options: &Options) -> RandomScene {
    if let Some((least, greatest)) = options.speeds {
        random = random.with_speeds(least, greatest);
    }
    if let Some(side) = options.blob {
        random = random.with_blob(side);
    }
    random
}

/// The moment whose output is written.
enum Frame {
    Step(u64),
    End(u64),
}

/// Runs all steps and writes the output of the problem's mode. Returns the time that the steps
/// took.
fn simulate(
    simulation: &mut dyn Simulation,
    problem: &Problem,
    root: bool,
    mut out: Option<&mut dyn Write>,
) -> io::Result<Duration> {
    let n = problem.n as usize;
    let mut chunk = vec![Disc::default(); n.min(CHUNK)];
    let mut show = |simulation: &dyn Simulation, frame: Frame| -> io::Result<()> {
        let Some(out) = &mut out else { return Ok(()) };
        for first in (0..n).step_by(CHUNK) {
            let chunk = &mut chunk[..CHUNK.min(n - first)];
            simulation.read(first, chunk);
            match frame {
                Frame::Step(t) => write_step(*out, t, first, chunk)?,
                Frame::End(steps) => write_end(*out, steps, first, chunk)?,
            }
        }
        Ok(())
    };

    let bar = program::progress(root, problem.steps);
    let mut stepping = Duration::ZERO;
    show(simulation, Frame::Step(0))?;
    for t in 1..=problem.steps {
        let start = Instant::now();
        simulation.step();
        stepping += start.elapsed();
        if problem.mode == Mode::Print {
            show(simulation, Frame::Step(t))?;
        }
        bar.inc(1);
    }
    bar.finish_and_clear();
    show(simulation, Frame::End(problem.steps))?;
    Ok(stepping)
}

/// Prints the results of the run: as JSON instead of the discs, or as text beside the discs.
fn report(
    variant: &Variant<dyn Simulation>,
    config: &Config,
    counters: Vec<(&'static str, f64)>,
    problem: &Problem,
    options: &Options,
    stepping: Duration,
) -> Result<(), Complaint> {
    let seconds = stepping.as_secs_f64();
    if options.choice.json {
        let line = json!({
            "variant": variant.name, "n": problem.n, "side": problem.side,
            "radius": problem.radius, "steps": problem.steps, "threads": config.threads,
            "seconds": seconds, "counters": program::counters_as_json(counters),
        });
        return program::say(&format!("{line}\n"));
    }
    eprintln!("Simulation Time = {} seconds for {} discs.", general(seconds), problem.n);
    for (name, value) in counters {
        eprintln!("{name} = {}", general(value));
    }
    Ok(())
}

fn two_numbers(text: &str) -> Result<(f64, f64), String> {
    text.split_once(',')
        .and_then(|(least, greatest)| Some((number(least)?, number(greatest)?)))
        .ok_or_else(|| "expected two numbers, LEAST,GREATEST".into())
}

fn number(text: &str) -> Option<f64> {
    text.trim().parse().ok().filter(|value: &f64| value.is_finite())
}
