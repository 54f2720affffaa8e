//! `cargo lab scaling`: what more workers bring.

mod counters;
mod curve;
mod show;

use std::process::ExitCode;

use anyhow::{Result, ensure};
use clap::Args;

use crate::chart::Sheet;
use crate::experiment::{Record, Records};
use crate::files::Files;
use crate::fit::{Effort, Fit};
use crate::job::Job;
use crate::scene::Scene;
use crate::subject::Subject;
use counters::Breakdown;
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
    pub(super) files: Files,
}

impl Options {
    pub(super) fn draw(&self, results: Results) -> Result<Sheet> {
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
    strong: Scene,
    /// The scene of the weak scaling, for one worker. Hard discs have one if it is asked for: where all pairs are
    /// looked at, p times the discs are p² times the work.
    weak: Option<Scene>,
    /// Whether ranks record what they do.
    events: bool,
}

/// Measures, prints, writes.
pub fn run(kit: &Kit, options: Options) -> Result<ExitCode> {
    let package = options.subject.package()?;
    ensure!(
        package.workers != Workers::Device,
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
    let records = options.effort.run(&runner, plan.jobs(), Fit::Alike)?;
    let curves = plan.curves(&records);
    show::print(&plan, &curves, &records);
    if !options.breakdown.is_empty() {
        let breakdown = Breakdown::new(&curves, &options.breakdown)?;
        let table = breakdown.table();
        println!("\nWhere the time of a step goes: ms, mean of the workers\n\n{table}");
    }
    let is_serial = |record: &&Record| record.job.program == plan.serial;
    let serial = records.records.iter().filter(is_serial).cloned().collect();
    options.files.write(Results { serial, curves, streaming_bound: records.bounds }, |shown| {
        options.draw(shown)
    })?;
    Ok(ExitCode::SUCCESS)
}

/// The best serial program for the problem of this lab, if the kit has it.
fn serial_program(kit: &Kit, package: &Program) -> Result<Option<Program>> {
    for lab in kit.solutions() {
        let facts = kit.facts(lab)?;
        if let (Some(variant), true) = (facts.baseline, facts.discs == package.discs) {
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
        let scene = |n: usize| Scene::usual(Some(n), hard);
        let n = options.n.map_or(if hard { 10_000 } else { 100_000 }, |n| n as usize);
        let shared = (!hard).then(|| (n / cores()).max(1));
        let weak = options.per_worker.map(|n| n as usize).or(shared).map(scene);
        let serial = serial.unwrap_or_else(|| programs[0].clone());
        let events = !options.breakdown.is_empty();
        Self { serial, programs, workers, strong: scene(n), weak, events }
    }

    /// A run of the strong scaling, or of the weak one if there is one.
    fn job(&self, program: &Program, weak: bool, workers: usize) -> Option<Job> {
        let scene = match weak {
            true => self.weak.clone()?.times(workers),
            false => self.strong.clone(),
        };
        let events = self.events && program.has_ranks();
        Some(Job { workers, events, ..Job::new(program.clone(), scene) })
    }

    /// Every run once: where the strong and the weak scene meet, they share it.
    fn jobs(&self) -> Vec<Job> {
        let each = self
            .programs
            .iter()
            .flat_map(|program| self.workers.iter().map(move |&p| (program, p)));
        let mut unique: Vec<Job> = Vec::new();
        for (program, p) in std::iter::once((&self.serial, 1)).chain(each) {
            for job in [false, true].into_iter().filter_map(|weak| self.job(program, weak, p)) {
                if !unique.contains(&job) {
                    unique.push(job);
                }
            }
        }
        unique
    }

    fn curves(&self, records: &Records) -> Vec<Curve> {
        let curve = |program: &Program| {
            let [strong, weak] = [false, true].map(|weak| {
                let of = |program, p| records.find(&self.job(program, weak, p)?);
                let all = self.workers.iter().filter_map(|&p| Some((p, of(program, p)?)));
                (of(&self.serial, 1), all.collect())
            });
            Curve::new(program.clone(), strong, weak)
        };
        self.programs.iter().map(curve).collect()
    }
}
