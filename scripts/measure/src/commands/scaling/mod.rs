//! `cargo lab scaling`: what more workers bring.

mod breakdown;
mod counters;
mod curve;
mod show;

use std::process::ExitCode;

use anyhow::{Result, ensure};
use clap::Args;

use crate::chart::Sheet;
use crate::experiment::{Record, Records};
use crate::files::{Figure, Files};
use crate::fit::{Effort, Fit};
use crate::job::Job;
use crate::scene::Scene;
use crate::subject::Subject;
use breakdown::Breakdown;
use curve::Curve;
use lab_kit::machine::{cores, doubled_up_to};
use lab_kit::program::Program;
use lab_kit::{Kit, Workers};
use show::Results;

/// Measure what more threads, or ranks, bring, and grade it
///
/// Strong scaling keeps the scene and adds workers; weak scaling lets the scene grow with them.
/// The grade compares with the kit's best serial program, and counts only as
/// many workers as this machine has cores. Each variant is compared with its own one worker too.
#[derive(Args)]
#[command(mut_arg("seconds", |seconds| seconds.default_value("90")))]
pub struct Options {
    #[command(flatten)]
    subject: Subject,
    /// Number of particles of the strong scaling [default: 100000; 10000 hard discs]
    #[arg(short, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    n: Option<u32>,
    /// Particles per worker of the weak scaling [default: n shared among the cores; none for hard discs, whose
    /// square grows with them]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    per_worker: Option<u32>,
    /// Numbers of workers, separated by commas [default: 1, 2, 4, … up to the cores]
    #[arg(long, value_name = "WORKERS", value_delimiter = ',', value_parser = clap::value_parser!(u16).range(1..))]
    workers: Vec<u16>,
    #[command(flatten)]
    effort: Effort,
    /// Draw this counter too, summed over the workers of the strong scaling, such as 'moving'
    #[arg(long, value_name = "NAME")]
    counter: Option<String>,
    /// Show where the time of a step goes in the strong scaling: counters of seconds, summed over the
    /// workers, such as 'forces,moving,waiting', or 'compute,communicate,wait' of ranks
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    breakdown: Vec<String>,
    #[command(flatten)]
    files: Files,
}

impl Figure for Options {
    type Shown = Results;

    fn files(&self) -> &Files {
        &self.files
    }

    fn draw(&self, results: Results) -> Result<Sheet> {
        let (n, curves) = (results.n(), &results.curves);
        let mut sheet = vec![results.charts()];
        if let Some(name) = &self.counter {
            sheet.push(vec![counters::chart(curves, n, name)?]);
        }
        if !self.breakdown.is_empty() {
            sheet.push(vec![Breakdown::new(curves, &self.breakdown)?.chart(n)]);
        }
        Ok(sheet)
    }
}

/// The scenes and workers of a measurement.
struct Plan {
    /// What t₁ is taken from.
    serial: Program,
    programs: Vec<Program>,
    workers: Vec<usize>,
    /// Particles of the strong scaling.
    n: usize,
    /// Particles of the weak scaling, for one worker. Hard discs have one if it is asked for: where all pairs are
    /// looked at, p times the discs are p² times the work.
    per_worker: Option<usize>,
    /// Whether ranks record what they do.
    events: bool,
}

/// Measures, prints, writes.
pub fn run(kit: &Kit, options: Options) -> Result<ExitCode> {
    let package = options.subject.package()?;
    ensure!(
        package.workers() != Workers::Device,
        "a device has no workers to vary, but 'cargo lab sweep {} --over workgroup --param timing=1'",
        package.lab
    );
    let serial = serial_program(kit, &package)?;
    let others: Vec<Program> = serial.iter().cloned().collect();
    let (runner, programs) = options.subject.build(kit, &others, true)?;
    ensure!(
        programs.iter().all(|p| p.threads.is_none() && p.ranks.is_none()),
        "the number of workers is what scaling varies: use --workers"
    );
    let plan = Plan::new(&options, serial, programs);
    let one_each: Vec<Job> = plan
        .programs
        .iter()
        .chain([&plan.serial])
        .map(|program| plan.job(program, plan.strong(program), 1))
        .collect();
    let records = options.effort.run(&runner, plan.jobs(), Fit::Alike(&one_each))?;
    let curves = plan.curves(&records);
    show::print(&plan, &curves, &records);
    if !options.breakdown.is_empty() {
        let breakdown = Breakdown::new(&curves, &options.breakdown)?;
        println!(
            "\nWhere the time of a step goes: ms, mean of the workers\n\n{}",
            breakdown.table()
        );
    }
    let is_serial = |record: &&Record| record.job.program == plan.serial;
    let serial = records.records.iter().filter(is_serial).cloned().collect();
    options.write(Results { serial, curves, streaming_bound: records.bounds })?;
    Ok(ExitCode::SUCCESS)
}

/// The best serial program for the problem of this lab, if the kit has it.
fn serial_program(kit: &Kit, package: &Program) -> Result<Option<Program>> {
    for lab in kit.solutions() {
        let facts = kit.facts(lab)?;
        if let (Some(variant), true) = (facts.baseline, facts.discs == package.discs()) {
            return Ok(Some(Program::new(lab, true)?.with_variant(&variant)));
        }
    }
    Ok(None)
}

impl Plan {
    fn new(options: &Options, serial: Option<Program>, programs: Vec<Program>) -> Self {
        let mut workers: Vec<usize> = options.workers.iter().map(|&p| p.into()).collect();
        if workers.is_empty() {
            workers = doubled_up_to(cores());
        }
        workers.push(1);
        workers.sort_unstable();
        workers.dedup();
        let hard = programs[0].is_hard();
        let usual = if hard { 10_000 } else { 100_000 };
        let n = options.n.map_or(usual, |n| n as usize);
        let shared = (!hard).then(|| (n / cores()).max(1));
        let per_worker = options.per_worker.map(|n| n as usize).or(shared);
        let serial = serial.unwrap_or_else(|| programs[0].clone());
        Self { serial, programs, workers, n, per_worker, events: !options.breakdown.is_empty() }
    }

    fn strong(&self, program: &Program) -> Scene {
        Scene::usual(Some(self.n), program.is_hard())
    }

    fn weak(&self, program: &Program, workers: usize) -> Option<Scene> {
        self.per_worker.map(|n| Scene::usual(Some(n), program.is_hard()).times(workers))
    }

    fn job(&self, program: &Program, scene: Scene, workers: usize) -> Job {
        let events = self.events && program.has_ranks();
        Job { workers, events, ..Job::new(program.clone(), scene) }
    }

    /// Every run once: where the strong and the weak scene meet, they share it.
    fn jobs(&self) -> Vec<Job> {
        let mut jobs = Vec::new();
        let mut add = |program: &Program, p| {
            let scenes = [Some(self.strong(program)), self.weak(program, p)];
            jobs.extend(scenes.into_iter().flatten().map(|scene| self.job(program, scene, p)));
        };
        add(&self.serial, 1);
        for program in &self.programs {
            self.workers.iter().for_each(|&p| add(program, p));
        }
        let mut unique: Vec<Job> = Vec::new();
        for job in jobs {
            if !unique.contains(&job) {
                unique.push(job);
            }
        }
        unique
    }

    fn curves<'r>(&self, records: &'r Records) -> Vec<Curve> {
        let of = |program: &Program, scene: Option<Scene>, p| {
            records.find(&self.job(program, scene?, p))
        };
        let strong = |program: &Program, p| of(program, Some(self.strong(program)), p);
        let weak = |program: &Program, p| of(program, self.weak(program, p), p);
        let curve = |program: &Program| {
            let points = |of: &dyn Fn(&Program, usize) -> Option<&'r Record>| {
                let all = self.workers.iter().filter_map(|&p| Some((p, of(program, p)?)));
                (of(&self.serial, 1), all.collect())
            };
            Curve::new(program.clone(), points(&strong), points(&weak))
        };
        self.programs.iter().map(curve).collect()
    }
}
