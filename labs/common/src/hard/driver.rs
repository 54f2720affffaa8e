//! The program around a lab of hard discs: its command line, its clock and its output.

use std::fs::File;
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
    #[arg(short, default_value_t = 1, value_name = "SEED", value_parser = clap::value_parser!(u32).range(1..), allow_negative_numbers = true)]
    seed: u32,
    /// Least and greatest velocity component of random discs [default: L/(8r) and L/4]
    #[arg(long, value_name = "LEAST,GREATEST", value_parser = speeds, allow_hyphen_values = true)]
    speeds: Option<(f64, f64)>,
    /// Place random discs in a square of this side in the middle [default: the whole square]
    #[arg(long, value_name = "SIDE", value_parser = side, allow_negative_numbers = true)]
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
/// input: the root calls it with the bytes, the other ranks call it with `None`, and all ranks get
/// the bytes.
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
    // If the root cannot read the input, the other ranks receive an empty input, so that all ranks
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
        Some(path) => text(File::open(path)?),
        None => text(io::stdin().lock()),
    }
}

/// Returns all bytes of an input.
///
/// An input with a zero byte is not text. The function refuses it, because a device such as
/// `/dev/zero` never ends.
fn text(mut input: impl Read) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    loop {
        let before = bytes.len();
        if input.by_ref().take(CHUNK as u64).read_to_end(&mut bytes)? == 0 {
            return Ok(bytes);
        }
        if bytes[before..].contains(&0) {
            return Err(io::Error::new(io::ErrorKind::InvalidData, "it is not a text"));
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

fn speeds(text: &str) -> Result<(f64, f64), String> {
    let numbers = text.split_once(',');
    numbers
        .and_then(|(least, greatest)| Some((number(least)?, number(greatest)?)))
        .filter(|(least, greatest)| (0.0..=*greatest).contains(least))
        .ok_or_else(|| "expected two numbers, LEAST,GREATEST, with 0 <= LEAST <= GREATEST".into())
}

fn side(text: &str) -> Result<f64, String> {
    let side = number(text).filter(|side| *side >= 0.0);
    side.ok_or_else(|| "expected a finite number, 0 or more".into())
}

fn number(text: &str) -> Option<f64> {
    text.trim().parse().ok().filter(|value: &f64| value.is_finite())
}

#[cfg(test)]
mod tests {
    use std::io::repeat;

    use clap::Parser;

    use super::{Options, text};

    #[test]
    fn numbers_that_make_no_scene_are_refused() {
        for good in [&["--blob=0"][..], &["--speeds", "3,3"], &["-s", "1"]] {
            assert!(Options::try_parse_from([&["lab"], good].concat()).is_ok(), "{good:?}");
        }
        for bad in [
            &["--blob=NaN"][..],
            &["--blob", "-1"],
            &["--blob=inf"],
            &["--speeds", "3,1"],
            &["--speeds", "-1,1"],
            &["--speeds=NaN,1"],
            &["-s", "0"],
            &["-s", "-5"],
        ] {
            let error =
                Options::try_parse_from([&["lab"], bad].concat()).err().unwrap().to_string();
            assert!(error.starts_with("error: invalid value "), "{bad:?}: {error}");
        }
    }

    #[test]
    fn an_input_without_end_is_refused() {
        assert_eq!(text(&b"2 10"[..]).unwrap(), b"2 10");
        assert_eq!(text(repeat(0)).unwrap_err().to_string(), "it is not a text");
    }
}
