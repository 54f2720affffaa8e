//! `cargo lab scaling`: the speed-up with more workers.

mod counters;
mod curve;
mod speedups;
mod strong_weak;

use anyhow::{Result, ensure};
use clap::Args;
use lab_kit::machine::{cores, doubled_up_to};
use lab_kit::program::Program;
use lab_kit::table::{Table, three_digits};
use lab_kit::{Kit, Workers};

use crate::chart::Sheet;
use crate::clock::{TOO_SHORT, warning};
use crate::columns::Columns;
use crate::experiment::Timings;
use crate::fit::{Effort, Fit};
use crate::numbers::Files;
use crate::scene::Scene;
use crate::subject::Subject;
use counters::Breakdown;
use curve::{Curve, Point, for_marks};
use speedups::Results;
use strong_weak::Plan;

/// Measure the speedup by more threads or ranks, and grade it
///
/// Strong scaling keeps the scene and adds workers; in weak scaling the scene grows with the number
/// of workers. The grade compares with the kit's best serial program, and uses numbers of workers
/// up to the number of cores. Each variant is also compared with the same variant on one worker.
#[derive(Args)]
#[command(mut_arg("seconds", |seconds| seconds.default_value("90")))]
pub struct Options {
    #[command(flatten)]
    subject: Subject,
    /// Number of particles of the strong scaling [default: 100000; 10000 hard discs]
    #[arg(short, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    n: Option<u32>,
    /// Number of particles per worker of the weak scaling [default: n divided by the cores; none
    /// for hard discs, whose square grows with them]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    per_worker: Option<u32>,
    /// Numbers of workers, separated by commas [default: 1, 2, 4, … up to the cores]
    #[arg(long, value_name = "WORKERS", value_delimiter = ',', value_parser = clap::value_parser!(u16).range(1..))]
    workers: Vec<u16>,
    #[command(flatten)]
    effort: Effort,
    /// Also draw this counter, summed over the workers of the strong scaling, such as 'moving'
    #[arg(long, value_name = "NAME")]
    counter: Option<String>,
    /// Show the parts of a step in the strong scaling: counters of seconds, summed over the
    /// workers, such as 'forces,moving,waiting', or 'compute,communicate,wait' of ranks
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    breakdown: Vec<String>,
    #[command(flatten)]
    pub(super) files: Files,
}

impl Options {
    pub(super) fn draw(&self, results: Results) -> Result<Sheet> {
        let n = results.n();
        let mut sheet = vec![results.charts()];
        if let Some(name) = &self.counter {
            sheet.push(vec![counters::chart(&results.curves, n, name)?]);
        }
        if !self.breakdown.is_empty() {
            sheet.push(vec![Breakdown::new(&results.curves, &self.breakdown)?.chart(n)]);
        }
        Ok(sheet)
    }

    fn plan(&self, serial: Option<Program>, programs: Vec<Program>) -> Plan {
        let mut workers: Vec<usize> = self.workers.iter().map(|&p| p.into()).collect();
        if workers.is_empty() {
            workers = doubled_up_to(cores());
        }
        workers.push(1);
        workers.sort_unstable();
        workers.dedup();
        let hard = programs[0].is_hard();
        let n = self.n.map_or(if hard { 10_000 } else { 100_000 }, |n| n as usize);
        let shared = (!hard).then(|| (n / cores()).max(1));
        let each = self.per_worker.map(|n| n as usize).or(shared);
        Plan {
            serial: serial.unwrap_or_else(|| programs[0].clone()),
            programs,
            workers,
            strong: Scene::usual(Some(n), hard),
            weak: each.map(|n| Scene::usual(Some(n), hard)),
            events: !self.breakdown.is_empty(),
        }
    }
}

pub(super) fn run(kit: &Kit, options: Options) -> Result<()> {
    let package = options.subject.package()?;
    ensure!(
        package.workers != Workers::Device,
        "a device has no workers to vary, but 'cargo lab sweep {} --over workgroup --param timing=1'",
        package.lab
    );
    let serial = serial_program(kit, &package)?;
    let (runner, programs) = options.subject.build(kit, serial.as_slice(), true)?;
    ensure!(
        programs.iter().all(|program| program.threads.is_none() && program.ranks.is_none()),
        "the number of workers is what scaling varies: use --workers"
    );
    let plan = options.plan(serial, programs);
    let timings = options.effort.run(&runner, plan.jobs(), Fit::Alike)?;
    let curves = plan.curves(&timings);
    print(&plan, &curves, &timings);
    if !options.breakdown.is_empty() {
        let breakdown = Breakdown::new(&curves, &options.breakdown)?;
        let table = breakdown.table();
        println!("\nWhere the time of a step goes: ms, mean of the workers\n\n{table}");
    }
    let mut serial = timings.timings;
    serial.retain(|timing| timing.job.program == plan.serial);
    let results = Results { serial, curves, streaming_bound: timings.bounds };
    options.files.write(results, |shown| options.draw(shown))
}

/// Finds the best serial program for the problem of this lab; `None` if the kit does not have one.
fn serial_program(kit: &Kit, package: &Program) -> Result<Option<Program>> {
    for lab in kit.solutions() {
        let facts = kit.facts(lab)?;
        if let (Some(variant), true) = (facts.baseline, facts.discs == package.discs) {
            return Ok(Some(Program::new(lab, true)?.with_variant(&variant)));
        }
    }
    Ok(None)
}

/// Prints a table for each variant, its grade, and the counters.
fn print(plan: &Plan, curves: &[Curve], timings: &Timings) {
    let serial = &plan.serial;
    let n = plan.strong.n();
    for curve in curves {
        println!("{}\n", curve.program);
        if let Some(steps) = curve.strong.first().map(|point| point.timing.job.steps) {
            println!("strong: n = {n}, {steps} steps, t1 from {serial}");
        }
        println!("{}", table(&curve.strong, true));
        if let Some(weak) = &plan.weak {
            println!("weak: n = {} per worker, t1 from {serial}", weak.n());
            println!("{}", table(&curve.weak, false));
        }
        println!("{}\n", verdict(curve));
    }
    if let Some(table) = counters::table(curves) {
        println!("What the shortest runs counted\n\n{table}");
    }
    if let Some(timing) = timings.timings.iter().find(|timing| timing.job.program == *serial) {
        let ms = three_digits(timing.ms().min);
        let n = timing.job.scene.n();
        println!("t1 = {ms} ms a step: {serial} on one worker, n = {n}");
    }
    println!("{}", timings.bounds_in_words());
    let streaming = timings.bound(n, false) / timings.bound(n, true);
    println!("Streaming on all cores is {streaming:.2} times as fast as on one at n = {n}.");
}

fn table(points: &[Point], strong: bool) -> Table {
    Columns::of("workers", |point: &Point| point.workers.to_string())
        .text("n", |point| point.timing.job.scene.n().to_string())
        .times("ms a step: ", |point| point.timing.ms())
        .text("efficiency", |point| format!("{:.2}", point.efficiency))
        .text("own", |point| format!("{:.2}", point.own_efficiency))
        .perhaps("speed-up", |point| {
            strong.then(|| format!("{:.2}", point.workers as f64 * point.efficiency))
        })
        .perhaps("own", |point| {
            strong.then(|| format!("{:.2}", point.workers as f64 * point.own_efficiency))
        })
        .text("graded", |point| if point.graded { "yes" } else { "no: cores" }.into())
        .table(points)
}

fn verdict(curve: &Curve) -> String {
    let Some(strong) = curve.average_strong_efficiency else {
        return "No number of workers fits on this machine: no grade.".into();
    };
    let grade = curve.grades.map_or_else(
        || TOO_SHORT.into(),
        |grade| format!("Grade: {:.2} of 100.{}", grade.min, warning(grade, grade.median)),
    );
    let weak = and_weak(curve.average_weak_efficiency);
    let mut text = format!("Average strong efficiency {strong:.2}{weak}. {grade}");
    if let Some(strong) = for_marks(&curve.strong) {
        let weak = and_weak(for_marks(&curve.weak));
        text += &format!("\nWithout one worker, as for marks: strong {strong:.2}{weak}.");
    }
    text
}

/// Returns a text with the weak-scaling efficiency; empty if there is none.
fn and_weak(efficiency: Option<f64>) -> String {
    efficiency.map_or_else(String::new, |weak| format!(", weak {weak:.2}"))
}
