//! `cargo lab count`: the number of a processor's events in a step.

use std::collections::BTreeMap;

use anyhow::Result;
use clap::Args;
use lab_kit::Kit;
use lab_kit::program::Program;
use lab_kit::table::Table;
use serde::{Deserialize, Serialize};

use crate::cachegrind::{By, Caches, Counts, Profile};
use crate::columns::Columns;
use crate::experiment::one_by_one;
use crate::job::Job;
use crate::numbers::Json;
use crate::over::{Over, Varied};
use crate::runner::Runner;
use crate::scene_options::OneScene;
use crate::subject::Programs;

/// Count instructions, cache misses and mispredicted branches of a step
///
/// 'cargo lab count 2 --solution' counts all variants of lab 2. Programs are written as for 'race';
/// a program without a variant means all variants of its lab. Valgrind's cachegrind simulates a
/// processor with two levels of caches and a branch predictor. It is about fifty times slower than
/// the machine, so use '-n 1000' for all pairs. Each program runs twice, and the counts of the
/// shorter run are subtracted from those of the longer one. The result is the counts of the last
/// steps, without set-up. Load and the machine's real caches have no influence, and memory and code
/// have the same addresses in each run. On one system all counts repeat to 10^-4. On a different
/// system, or if the system cannot fix addresses, misses and mispredictions repeat to 10^-3.
///
/// The command counts and does not time. It cannot show prefetching, several misses at once, or two
/// cores that write to the same cache line (false sharing). It has no AVX-512: a program that would
/// use it takes its other path. Threads run one at a time, and the instructions of a waiting thread
/// count too.
#[derive(Args)]
#[command(mut_arg("n", |n| n.help("Number of particles [default: 20000; 2000 hard discs]")))]
pub struct Options {
    #[command(flatten)]
    programs: Programs,
    /// Quantity that varies, with its values, such as n=1000,10000 or a parameter: bin-size=1,2
    #[arg(long, value_name = "WHAT=VALUES")]
    over: Option<Over>,
    #[command(flatten)]
    scene: OneScene,
    /// Number of threads, or ranks, of a program that does not set it
    #[arg(short, default_value_t = 1, value_name = "WORKERS", value_parser = clap::value_parser!(u16).range(1..))]
    t: u16,
    /// Number of time steps that are counted
    #[arg(long, default_value_t = 10, value_name = "STEPS", value_parser = clap::value_parser!(u64).range(1..))]
    steps: u64,
    /// Number of time steps before that; soft discs need about fifty to leave the lattice at the
    /// start [default: 50; hard discs 1]
    #[arg(long, value_name = "STEPS", value_parser = clap::value_parser!(u64).range(1..))]
    after: Option<u64>,
    #[command(flatten)]
    caches: Caches,
    /// Also show the places in the source with the most instructions
    #[arg(long)]
    by: Option<By>,
    #[command(flatten)]
    json: Json,
}

/// Headings of the counts.
const COLUMNS: [&str; 4] =
    ["instructions", "first-level misses", "last-level misses", "mispredicted branches"];

/// Number of locations of a program that the table shows.
const LOCATIONS: usize = 12;

#[derive(Clone, Deserialize, Serialize)]
pub(super) struct Row {
    #[serde(flatten)]
    pub(super) job: Job,
    per_particle_and_step: BTreeMap<String, f64>,
}

#[derive(Deserialize, Serialize)]
pub(super) struct Results {
    pub(super) caches: Caches,
    pub(super) after: u64,
    pub(super) programs: Vec<Row>,
}

impl Row {
    fn new(job: &Job, profile: &Profile) -> Self {
        let counts = per(job, profile.total());
        let per_particle_and_step = COLUMNS.map(Into::into).into_iter().zip(counts).collect();
        Self { job: job.clone(), per_particle_and_step }
    }

    pub(super) fn counts(&self) -> Counts {
        COLUMNS.map(|name| self.per_particle_and_step.get(name).copied().unwrap_or(0.0))
    }
}

pub(super) fn run(kit: &Kit, mut options: Options) -> Result<()> {
    let named = options.programs.of_one_kind()?;
    let hard = named[0].is_hard();
    options.scene.n.get_or_insert(if hard { 2000 } else { 20_000 });
    let after = options.after.unwrap_or(if hard { 1 } else { 50 });
    let mut runner = Runner::build(kit, &named)?;
    let jobs = jobs(&options, &runner, &named)?;
    runner.under(options.caches.tool(runner.folder())?);
    let by = options.by.unwrap_or(By::Function);
    let profiles = one_by_one(&jobs, Job::name, |job| profile(&runner, job, after, by))?;
    let mut rows = Vec::new();
    for (job, profile) in jobs.iter().zip(&profiles) {
        rows.push(Row::new(job, profile));
    }
    println!("{}", table(options.over.as_ref(), &rows));
    print!("Per particle and step, of {} steps after {after}", options.steps);
    match &options.over {
        Some(over) if over.varied == Varied::N => println!(),
        _ => println!("; n = {}", jobs[0].scene.n()),
    }
    if options.by.is_some() {
        for (job, profile) in jobs.iter().zip(&profiles) {
            println!("\n{}", locations(job, profile));
        }
    }
    options.json.write(Results { caches: options.caches, after, programs: rows })
}

/// Makes a job for each named variant and each value of the varied quantity.
fn jobs(options: &Options, runner: &Runner, named: &[Program]) -> Result<Vec<Job>> {
    let programs: Vec<Program> = runner.variants(named)?.into_iter().map(|(one, _)| one).collect();
    let scene = options.scene.scene(named[0].is_hard())?;
    let like = Job::new(programs[0].clone(), scene);
    let like = Job { workers: options.t.into(), steps: options.steps, ..like };
    Ok(match &options.over {
        Some(over) => over.varied.jobs(&over.values(&programs[0])?, &programs, &like),
        None => programs.into_iter().map(|program| Job { program, ..like.clone() }).collect(),
    })
}

/// Counts the events of the job's steps, which follow after `after` earlier steps.
pub(super) fn profile(runner: &Runner, job: &Job, after: u64, by: By) -> Result<Profile> {
    runner.run(&Job { steps: after, ..job.clone() })?;
    let shorter = Profile::take(runner.folder(), by)?;
    runner.run(&Job { steps: after + job.steps, ..job.clone() })?;
    Ok(Profile::take(runner.folder(), by)?.beyond(&shorter))
}

/// Divides counts by the numbers of particles and steps of a job.
pub(super) fn per(job: &Job, counts: Counts) -> Counts {
    counts.map(|count| count / (job.scene.n() as f64 * job.steps as f64))
}

fn table(over: Option<&Over>, rows: &[Row]) -> Table {
    let head = over.map_or(String::new(), |over| over.varied.to_string());
    Columns::of("program", |row: &Row| row.job.program.to_string())
        .number(head, |row| Some(over?.varied.of(&row.job)))
        .numbers(COLUMNS, |row, at| Some(row.counts()[at]))
        .table(rows)
}

/// Makes a table of the locations with the most instructions.
fn locations(job: &Job, profile: &Profile) -> Table {
    let locations = profile.first(LOCATIONS);
    Columns::of(job.program.to_string(), |(location, _): &(&str, Counts)| (*location).into())
        .numbers(COLUMNS, |(_, counts), at| Some(per(job, *counts)[at]))
        .table(&locations)
}
