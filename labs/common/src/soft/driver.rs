//! The program around a lab of soft discs: its command line, its clock and its output.

use std::fs::File;
use std::io::{self, BufReader, Write};
use std::path::PathBuf;
use std::process::ExitCode;
use std::time::{Duration, Instant};

use clap::{Parser, ValueEnum};
use serde_json::json;

use super::{
    Averages, FrameFormat, FrameWriter, Particle, Simulation, Statistics, general, official_size,
    read_scene,
};
use crate::program::{self, Choice, Complaint};
use crate::{Config, Variant, write_whole};

/// Number of particles that are read and written at a time.
const CHUNK: usize = 1 << 20;

/// Simulate soft discs
#[derive(Parser)]
#[command(arg_required_else_help = false)]
struct Options {
    /// Number of particles
    #[arg(short, default_value_t = 1000, value_name = "N", allow_negative_numbers = true)]
    n: u64,
    /// Seed of the scene, 1 or more
    #[arg(short, default_value_t = 1, value_name = "SEED", allow_negative_numbers = true)]
    seed: u32,
    /// Generator of the scene
    #[arg(long, value_enum, default_value_t = Generator::Official, value_name = "NAME")]
    generator: Generator,
    #[command(flatten)]
    choice: Choice,
    /// Number of time steps
    #[arg(long, default_value_t = 1000, value_name = "STEPS", allow_negative_numbers = true)]
    steps: u64,
    /// Start from a scene file instead: a line 'n size', then a line 'x y vx vy' for each particle
    #[arg(long, value_name = "FILE", conflicts_with_all = ["n", "seed", "generator"])]
    scene: Option<PathBuf>,
    /// Write every K-th step
    #[arg(long, default_value_t = 10, value_name = "K", value_parser = clap::value_parser!(u64).range(1..))]
    every: u64,
    /// Write only the state after the last step
    #[arg(long, conflicts_with = "every")]
    last: bool,
    /// Write 'x y vx vy' with all digits instead of 'x y' with six
    #[arg(long)]
    full: bool,
    /// Collect statistics of the pairs and print their averages
    #[arg(long)]
    statistics: bool,
    /// Print what the program decided from the scene, and what it skipped
    #[arg(long)]
    explain: bool,
}

/// The generator of a scene that is not read from a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Generator {
    /// The generator of the original program, which must make all particles to know any of them
    Official,
    /// The same positions and the same distribution of speeds; each particle is computed from its
    /// number alone
    Counter,
}

/// The scene that an engine has loaded.
struct Loaded {
    n: usize,
    size: f64,
    /// Time for loading, without the time for reading a scene file.
    time: Duration,
}

/// The measurements of a run.
struct Run {
    loading: Duration,
    stepping: Duration,
    /// Time for reading the particles, without the time for writing them.
    reading: Duration,
    statistics: Vec<Statistics>,
}

/// Runs the program of a lab, from its command line to its exit code.
pub fn drive(variants: &[Variant<dyn Simulation>]) -> ExitCode {
    drive_on_rank(variants, true)
}

/// Runs the program of a lab as one of several processes with the same command line.
///
/// Every process calls it; only the `root` prints and writes. If all processes have the same error,
/// the root reports it; another process prints its error only if the job has not ended a second
/// later.
pub fn drive_on_rank(variants: &[Variant<dyn Simulation>], root: bool) -> ExitCode {
    program::run(root, |options| run_lab(variants, options, root))
}

fn run_lab(
    variants: &[Variant<dyn Simulation>],
    options: &Options,
    root: bool,
) -> Result<(), Complaint> {
    if options.choice.list_variants {
        return if root { program::list(variants, options.choice.json) } else { Ok(()) };
    }
    let variant = options.choice.variant(variants)?;
    let mut config = options.choice.config(variant)?;
    config.statistics = options.statistics;
    let mut simulation = (variant.build)(&config).map_err(|e| e.to_string())?;
    let Loaded { n, size, time } = load(&mut *simulation, options)?;

    let mut run = match options.choice.output.as_deref().filter(|_| root) {
        Some(path) => write_whole(path, |out| {
            let format = if options.full { FrameFormat::Full } else { FrameFormat::Official };
            let mut frames = FrameWriter::new(out, format, n, size)?;
            simulate(&mut *simulation, n, options, root, Some(&mut frames))
        })
        .map_err(|e| format!("cannot write {}: {e}", path.display()))?,
        None => simulate(&mut *simulation, n, options, root, None).map_err(|e| e.to_string())?,
    };
    run.loading = time;
    // Ranks may have to add up their counters, so all ranks call this.
    let counters = simulation.counters();
    let events = simulation.events();
    if !root {
        return Ok(());
    }
    options.choice.write_events(variant.name, events)?;
    if options.explain && !options.choice.json {
        let plan = simulation.plan();
        program::say(&plan.unwrap_or_else(|| "this program decides nothing\n".into()))?;
    }
    program::say(&report(variant, &config, counters, n, options, &run))
}

/// Loads the scene that the user chose.
fn load(simulation: &mut dyn Simulation, options: &Options) -> Result<Loaded, Complaint> {
    let start = Instant::now();
    let Some(path) = &options.scene else {
        match options.generator {
            Generator::Official => simulation.load_official(options.n, options.seed),
            Generator::Counter => simulation.load_counter(options.n, options.seed),
        }
        .map_err(|e| e.to_string())?;
        let n = options.n as usize;
        return Ok(Loaded { n, size: official_size(n), time: start.elapsed() });
    };
    let scene = File::open(path)
        .map_err(Into::into)
        .and_then(|file| read_scene(BufReader::new(file)))
        .map_err(|e| format!("{}: {e}", path.display()))?;
    let start = Instant::now();
    simulation.load(&scene);
    Ok(Loaded { n: scene.len(), size: scene.size(), time: start.elapsed() })
}

fn simulate(
    simulation: &mut dyn Simulation,
    n: usize,
    options: &Options,
    root: bool,
    mut frames: Option<&mut FrameWriter<&mut dyn Write>>,
) -> io::Result<Run> {
    let [loading, stepping, reading] = [Duration::ZERO; 3];
    let mut run = Run { loading, stepping, reading, statistics: Vec::new() };
    let bar = program::progress(root, options.steps);
    let mut chunk = Vec::new();
    let mut done = 0;
    while done < options.steps {
        let batch = batch(done, options);
        let start = Instant::now();
        simulation.run(batch);
        run.stepping += start.elapsed();
        done += batch;
        run.statistics.extend(simulation.statistics());
        // Under MPI, reading the particles is collective: every rank calls `read`, although only
        // the root has an output file.
        if options.choice.output.is_some() && is_written(done, options) {
            chunk.resize(n.min(CHUNK), Particle::default());
            for first in (0..n).step_by(CHUNK) {
                let chunk = &mut chunk[..CHUNK.min(n - first)];
                let start = Instant::now();
                simulation.read(first, chunk);
                run.reading += start.elapsed();
                if let Some(frames) = &mut frames {
                    frames.particles(chunk)?;
                }
            }
            if let Some(frames) = &mut frames {
                frames.end_frame()?;
            }
        }
        bar.inc(batch);
    }
    bar.finish_and_clear();
    Ok(run)
}

/// Whether the state is written when `done` steps are done. Steps are numbered from 0.
fn is_written(done: u64, options: &Options) -> bool {
    if options.last { done == options.steps } else { (done - 1).is_multiple_of(options.every) }
}

/// Returns the number of steps to take in a row after `done` steps.
///
/// The run stops for output after steps 0, `every`, 2 `every`, …, unless only the last state is
/// written. With statistics it stops after each step. In all other cases it stops from time to
/// time, to move the progress bar.
fn batch(done: u64, options: &Options) -> u64 {
    const BAR: u64 = 50;
    let look = match () {
        () if options.statistics => 1,
        () if options.choice.output.is_some() && !options.last => {
            done.next_multiple_of(options.every) - done + 1
        }
        () => BAR,
    };
    look.min(BAR).min(options.steps - done)
}

/// Prints the results of the run, for a person or as a line of JSON.
fn report(
    variant: &Variant<dyn Simulation>,
    config: &Config,
    counters: Vec<(&'static str, f64)>,
    n: usize,
    options: &Options,
    run: &Run,
) -> String {
    let seconds = run.stepping.as_secs_f64();
    let averages = Averages::of(n, &run.statistics);
    if options.choice.json {
        let averages = averages.map(|a| {
            json!({ "absmin": a.absmin, "absavg": a.absavg,
                    "neighbours": a.neighbours, "pair_tests": a.pair_tests })
        });
        let line = json!({
            "variant": variant.name, "n": n, "steps": options.steps,
            "threads": config.threads, "seconds": seconds,
            "loading": run.loading.as_secs_f64(), "reading": run.reading.as_secs_f64(),
            "resident": program::resident(),
            "statistics": averages,
            "counters": program::counters_as_json(counters),
        });
        return format!("{line}\n");
    }
    let mut text = format!("Simulation Time = {} seconds for {n} particles.\n", general(seconds));
    if let Some(a) = averages {
        text += &format!(
            "absmin = {:.6}, absavg = {:.6}, in units of the cutoff\n\
             neighbours = {:.6}, pair tests = {:.3}, per particle and step\n",
            a.absmin, a.absavg, a.neighbours, a.pair_tests
        );
    }
    for (name, value) in counters {
        text += &format!("{name} = {}\n", general(value));
    }
    text
}

#[cfg(test)]
mod tests {
    use clap::Parser;

    use super::Options;

    #[test]
    fn a_negative_number_is_called_an_invalid_value() {
        for option in ["-n", "-s", "--steps"] {
            let error = Options::try_parse_from(["lab", option, "-5"]).err().unwrap().to_string();
            assert!(error.starts_with("error: invalid value '-5' for '"), "{error}");
        }
    }
}
