//! `cargo lab race`: programs side by side.

use std::path::PathBuf;
use std::process::ExitCode;

use anyhow::Result;
use clap::Args;
use serde_json::{Value, json};

use crate::discs::Discs;
use crate::job::{Job, Runner};
use crate::record::write_json;
use crate::rounds::{Rounds, measure};
use crate::steps;
use lab_kit::Kit;
use lab_kit::program::{Binaries, Program};
use lab_kit::table::{Table, three_digits};

/// Race programs against each other on one scene
///
/// A program is `lab2`, `lab2:sorted`, or with its parameters `lab3:fork-join,t=2,padding=1`, where
/// t is threads and r ranks. `solution2:sorted` is the solution's. They take turns, round after
/// round; shown are the shortest take, the median, and how both compare with the first program's.
#[derive(Args)]
pub struct Options {
    /// The programs, the one to compare with first
    #[arg(required = true, value_name = "PROGRAM")]
    programs: Vec<Program>,
    /// Race the solutions instead of your own work
    #[arg(long)]
    solution: bool,
    /// Number of particles [default: 100000; 10000 hard discs]
    #[arg(short, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    n: Option<u32>,
    #[command(flatten)]
    discs: Discs,
    /// Threads, or ranks, of a program that does not say
    #[arg(short, default_value_t = 1, value_name = "WORKERS", value_parser = clap::value_parser!(u16).range(1..))]
    t: u16,
    /// Time steps [default: as many as the time allows, at most 1000]
    #[arg(long, value_name = "STEPS", value_parser = clap::value_parser!(u64).range(1..))]
    steps: Option<u64>,
    /// How often each program runs
    #[arg(long, default_value_t = 5, value_name = "ROUNDS", value_parser = clap::value_parser!(u16).range(1..))]
    rounds: u16,
    /// Seconds that all rounds together may take, if --steps does not decide
    #[arg(long, default_value_t = 30.0, value_name = "SECONDS")]
    seconds: f64,
    /// Write all numbers to this file as JSON
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
}

/// Times the programs and prints the table.
pub fn run(kit: &Kit, options: Options) -> Result<ExitCode> {
    let mut programs = options.programs.clone();
    for program in &mut programs {
        program.solution |= options.solution;
    }
    anyhow::ensure!(
        programs.iter().all(|p| p.is_hard() == programs[0].is_hard()),
        "soft and hard discs cannot race: they are different problems"
    );
    let runner = Runner::new(Binaries::build(kit, &programs)?, &programs)?;
    let n = options.n.map(|n| n as usize);
    let scene = options.discs.scene(n, programs[0].is_hard())?;
    let mut jobs: Vec<Job> = programs
        .into_iter()
        .map(|program| Job {
            program,
            scene,
            steps: 1,
            workers: options.t.into(),
            statistics: false,
        })
        .collect();

    // All run the same steps: as many as suit the slowest.
    let share = options.seconds / (jobs.len() as f64 * f64::from(options.rounds));
    let steps = match options.steps {
        Some(steps) => steps,
        None => {
            let each = jobs.iter().map(|job| steps::that_take(&runner, job, share));
            each.collect::<Result<Vec<_>>>()?.into_iter().min().unwrap_or(1)
        }
    };
    jobs.iter_mut().for_each(|job| job.steps = steps);
    let rounds = measure(&runner, &jobs, options.rounds.into())?;
    println!("{}", table(&rounds));
    println!("{}", rounds.bounds_in_words());
    if let Some(path) = &options.json {
        write_json(path, results(&rounds))?;
    }
    Ok(ExitCode::SUCCESS)
}

fn table(rounds: &Rounds) -> String {
    let first = &rounds.measured[0];
    let mut table = Table::new([
        "nanoseconds per particle and step",
        "workers",
        "min",
        "median",
        "spread",
        "ratio of min",
        "of median",
        "",
    ]);
    for measured in &rounds.measured {
        let times = &measured.times;
        let ratio = times.over(&first.times);
        let is_first = std::ptr::eq(measured, first);
        table.row([
            measured.job.program.to_string(),
            measured.job.all_workers().to_string(),
            three_digits(measured.nanoseconds(times.min())),
            three_digits(measured.nanoseconds(times.median())),
            format!("{:.0} %", 100.0 * times.spread()),
            format!("{:.3}", ratio.of_minima),
            format!("{:.3}", ratio.of_medians),
            if ratio.decided || is_first { "" } else { "spread too wide to decide" }.to_owned(),
        ]);
    }
    let (job, takes) = (&first.job, first.times.takes());
    format!("{table}\nn = {}, {} steps, {takes} rounds", job.scene.n(), job.steps)
}

fn results(rounds: &Rounds) -> Value {
    let first = &rounds.measured[0].times;
    let rows = rounds.measured.iter().map(|measured| {
        let mut row = measured.as_json();
        row["ratio"] = json!(measured.times.over(first));
        row
    });
    json!({ "programs": rows.collect::<Vec<_>>(), "streaming_bound": rounds.bounds })
}
