//! `cargo lab count`: what a processor does in a step, counted.

use std::collections::BTreeMap;
use std::process::ExitCode;

use anyhow::Result;
use clap::Args;
use lab_kit::Kit;
use lab_kit::table::Table;
use serde::{Deserialize, Serialize};

use crate::axis::{Axis, Over};
use crate::cachegrind::{By, Caches, Counts, Profile};
use crate::columns::Columns;
use crate::experiment::in_turns;
use crate::files::Json;
use crate::job::Job;
use crate::runner::Runner;
use crate::scene::OneScene;
use crate::subject::Programs;

/// Count instructions, cache misses and mispredicted branches of a step
///
/// 'cargo lab count 2 --solution' counts all variants of lab 2; a program is written as for 'race', and one without
/// a variant stands for all of its lab. Valgrind's cachegrind simulates a processor with two levels of caches and
/// a predictor of branches, some fifty times as slow as the machine: all pairs ask for '-n 1000'. Each program runs
/// twice, and what the shorter run counts is taken from what the longer one does: what is left is of the last
/// steps, without set-up. Load and the machine's own caches change nothing, and memory and code lie at the same
/// addresses: on one system all counts are the same in every run to 10^-4. On another one, and where the system
/// allows no such addresses, misses and mispredictions are the same to 10^-3.
///
/// It counts, and takes no time: it cannot see what a processor fetches ahead, how many misses it waits for at once,
/// or two cores that write to one line (false sharing). It knows no AVX-512: a program that would use it takes its
/// other way. Threads run one at a time, and the instructions of one that waits count too.
#[derive(Args)]
#[command(mut_arg("n", |n| n.help("Number of particles [default: 20000; 2000 hard discs]")))]
pub struct Options {
    #[command(flatten)]
    programs: Programs,
    /// What varies, with its values, such as n=1000,10000 or a parameter's: bin-size=1,2
    #[arg(long, value_name = "WHAT=VALUES")]
    over: Option<Over>,
    #[command(flatten)]
    scene: OneScene,
    /// Threads, or ranks, of a program that does not say
    #[arg(short, default_value_t = 1, value_name = "WORKERS", value_parser = clap::value_parser!(u16).range(1..))]
    t: u16,
    /// Time steps that are counted
    #[arg(long, default_value_t = 10, value_name = "STEPS", value_parser = clap::value_parser!(u64).range(1..))]
    steps: u64,
    /// Time steps before: soft discs need some fifty to leave the lattice that they start on
    /// [default: 50; hard discs 1]
    #[arg(long, value_name = "STEPS", value_parser = clap::value_parser!(u64).range(1..))]
    after: Option<u64>,
    #[command(flatten)]
    caches: Caches,
    /// Also show where in the source most instructions are
    #[arg(long)]
    by: Option<By>,
    #[command(flatten)]
    json: Json,
}

/// What a table of counts says of each.
const COLUMNS: [&str; 4] =
    ["instructions", "first-level misses", "last-level misses", "mispredicted branches"];

/// How many locations of a program are shown.
const LOCATIONS: usize = 12;

/// What a program does, per particle and step.
#[derive(Clone, Deserialize, Serialize)]
pub struct Row {
    #[serde(flatten)]
    pub(super) job: Job,
    #[serde(skip)]
    at: Option<f64>,
    per_particle_and_step: BTreeMap<String, f64>,
}

/// All numbers.
#[derive(Deserialize, Serialize)]
pub struct Results {
    pub(super) caches: Caches,
    pub(super) after: u64,
    pub(super) programs: Vec<Row>,
}

impl Row {
    pub(super) fn counts(&self) -> Counts {
        COLUMNS.map(|name| self.per_particle_and_step.get(name).copied().unwrap_or(0.0))
    }
}

/// Counts, prints, writes.
pub fn run(kit: &Kit, mut options: Options) -> Result<ExitCode> {
    let (named, hard) = options.programs.of_one_kind()?;
    let mut runner = Runner::build(kit, &named)?;
    let mut programs = Vec::new();
    for program in &named {
        programs.extend(runner.binaries.variants(program)?.into_iter().map(|(program, _)| program));
    }
    options.scene.n.get_or_insert(if hard { 2000 } else { 20_000 });
    let scene = options.scene.scene(hard)?;
    let (after, steps) = (options.after.unwrap_or(if hard { 1 } else { 50 }), options.steps);
    let job =
        |program| Job { workers: options.t.into(), steps, ..Job::new(program, scene.clone()) };
    let jobs: Vec<Job> = match &options.over {
        Some(over) => {
            over.axis.jobs(&over.values(&programs[0])?, &programs, &job(programs[0].clone()))
        }
        None => programs.into_iter().map(job).collect(),
    };
    runner.under(options.caches.tool(runner.folder())?);
    let by = options.by.unwrap_or(By::Function);
    let name = |job: &Job| format!("{} n={}", job.program, job.scene.n());
    let profiles = in_turns(&jobs, 1, name, |job| profile(&runner, job, after, by))?;
    let profiles: Vec<(Job, Profile)> =
        jobs.into_iter().zip(profiles.into_iter().flatten()).collect();
    let row = |(job, profile): &(Job, Profile)| Row {
        at: options.over.as_ref().map(|over| over.axis.of(job)),
        per_particle_and_step: COLUMNS
            .map(Into::into)
            .into_iter()
            .zip(per(job, profile.total()))
            .collect(),
        job: job.clone(),
    };
    let rows: Vec<Row> = profiles.iter().map(row).collect();
    let head = options.over.as_ref().map_or(String::new(), |over| over.axis.to_string());
    println!("{}", table(&head, &rows));
    let varies = options.over.as_ref().is_some_and(|over| over.axis == Axis::N);
    let n = if varies { String::new() } else { format!("; n = {}", scene.n()) };
    println!("Per particle and step, of {steps} steps after {after}{n}");
    if options.by.is_some() {
        profiles.iter().for_each(|(job, profile)| println!("\n{}", locations(job, profile)));
    }
    options.json.write(Results { caches: options.caches, after, programs: rows })?;
    Ok(ExitCode::SUCCESS)
}

/// What the last steps of a run count.
pub(super) fn profile(runner: &Runner, job: &Job, after: u64, by: By) -> Result<Profile> {
    let count = |steps| {
        runner.run(&Job { steps, ..job.clone() })?;
        Profile::take(runner.folder(), by)
    };
    let shorter = count(after)?;
    Ok(count(after + job.steps)?.beyond(&shorter))
}

/// The same for each particle and step.
pub(super) fn per(job: &Job, counts: Counts) -> Counts {
    counts.map(|count| count / (job.scene.n() as f64 * job.steps as f64))
}

fn table(head: &str, rows: &[Row]) -> Table {
    let counted = |row: &Row, at: usize| Some(row.counts()[at]);
    Columns::of("program", |row: &Row| row.job.program.to_string())
        .number(head, |row| row.at)
        .numbers(COLUMNS, counted)
        .table(rows)
}

/// The locations with most instructions.
fn locations(job: &Job, profile: &Profile) -> Table {
    let locations = profile.first(LOCATIONS);
    Columns::of(job.program.to_string(), |(location, _): &(&str, Counts)| (*location).into())
        .numbers(COLUMNS, |(_, counts), at| Some(per(job, *counts)[at]))
        .table(&locations)
}
