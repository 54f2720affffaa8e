//! `cargo lab sweep`: variants side by side while one thing varies.

mod axis;
mod show;

use std::process::ExitCode;

use anyhow::Result;
use clap::Args;

use crate::discs::Discs;
use crate::effort::Effort;
use crate::job::Job;
use crate::published::HARD_STEPS;
use crate::record::Files;
use crate::rounds::{Measured, measure};
use crate::steps;
use crate::subject::Subject;
use axis::{Axis, Over};
use lab_kit::Kit;

/// Measure variants while one thing varies: n, the square, the radius, neighbours, threads, a parameter
///
/// 'cargo lab sweep 7 --solution --variant outer-dynamic,planned -t 2 --over radius' takes the
/// values of the CS3210 report; '--over n=1000,10000' takes these. All runs take turns, round after
/// round. Shown are the shortest take and the median, how both compare with the first variant's at
/// the same value, the pairs looked at, and what the report printed.
/// A run has at most 50 steps, as in the report, unless --steps says otherwise.
#[derive(Args)]
pub struct Options {
    #[command(flatten)]
    subject: Subject,
    /// What varies: n, length, radius, neighbours, threads, ranks or a parameter's name; perhaps with
    /// its values
    #[arg(long, value_name = "WHAT[=VALUES]")]
    over: Over,
    /// Number of particles [default: 100000; 10000 hard discs]
    #[arg(short, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    n: Option<u32>,
    #[command(flatten)]
    discs: Discs,
    /// Threads, or ranks
    #[arg(short, default_value_t = 1, value_name = "WORKERS", value_parser = clap::value_parser!(u16).range(1..))]
    t: u16,
    #[command(flatten)]
    effort: Effort,
    #[command(flatten)]
    files: Files,
}

/// One variant at one value.
struct Cell {
    value: f64,
    /// The variant, as tables call it.
    name: String,
    measured: Measured,
}

/// What was measured, value by value, in each the variants in their order.
struct Sweep {
    axis: Axis,
    cells: Vec<Cell>,
}

/// Measures, prints, writes.
pub fn run(kit: &Kit, options: Options) -> Result<ExitCode> {
    let (runner, programs) = options.subject.build(kit, &[], false)?;
    let values = options.over.values(&programs[0])?;
    let n = options.n.map(|n| n as usize);
    let scene = options.discs.scene(n, programs[0].is_hard())?;
    let axis = options.over.axis.clone();

    let mut jobs = Vec::new();
    for &value in &values {
        for program in &programs {
            let program = program.clone();
            let workers = options.t.into();
            let job = Job { program, scene, steps: 1, workers, statistics: false };
            jobs.push(axis.set(&job, value));
        }
    }
    let Effort { steps, rounds, .. } = options.effort;
    let share = options.effort.share(jobs.len());
    for job in &mut jobs {
        job.steps = match steps {
            Some(steps) => steps,
            None => steps::that_take(&runner, job, share)?.min(HARD_STEPS as u64),
        };
    }
    let rounds = measure(&runner, &jobs, rounds.into())?;

    let cells = rounds.measured.iter().enumerate().map(|(at, measured)| {
        let variant = programs[at % programs.len()].variant.clone();
        let name = variant.unwrap_or_else(|| measured.job.program.package());
        Cell { value: values[at / programs.len()], name, measured: measured.clone() }
    });
    let sweep = Sweep { axis, cells: cells.collect() };
    println!("{}", show::table(&sweep));
    println!("{}", rounds.bounds_in_words());
    let results = show::results(&sweep, &rounds);
    options.files.write(results, &[show::chart(&sweep)])?;
    Ok(ExitCode::SUCCESS)
}

impl Cell {
    /// Milliseconds of a step.
    fn ms(&self, seconds: f64) -> f64 {
        seconds * 1e3 / self.measured.job.steps as f64
    }

    /// Pairs looked at in a step, if the variant counts them.
    fn pair_tests(&self) -> Option<f64> {
        let total = self.measured.counters.get("pair tests")?;
        Some(total / self.measured.job.steps as f64)
    }
}

impl Sweep {
    /// The first variant's cell at the same value.
    fn first_at(&self, value: f64) -> &Cell {
        self.cells.iter().find(|cell| cell.value == value).expect("every value has a cell")
    }

    /// The variants, in their order.
    fn names(&self) -> Vec<&str> {
        let first = self.cells[0].value;
        let same = self.cells.iter().take_while(|cell| cell.value == first);
        same.map(|cell| cell.name.as_str()).collect()
    }
}
