//! `cargo lab complexity`: how the time grows with the number of particles.

mod show;

use std::process::ExitCode;

use anyhow::{Result, ensure};
use clap::Args;

use crate::discs::Discs;
use crate::effort::Effort;
use crate::job::{Job, Runner, Scene};
use crate::record::Files;
use crate::rounds::{Measured, Rounds, measure};
use crate::rubric::slope;
use crate::steps;
use crate::subject::Subject;
use lab_kit::Kit;
use lab_kit::program::Program;

/// Measure how the time grows with the number of particles, and grade it
///
/// Times a variant on scenes that double in size and fits a line through the points on
/// logarithmic axes: its slope is the exponent of n. The pairs that the program looks at are
/// counted as well, which no noise disturbs. A slope below 1.3 by time earns the full grade.
#[derive(Args)]
pub struct Options {
    #[command(flatten)]
    subject: Subject,
    /// Least number of particles
    #[arg(long, default_value_t = 1000, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    from: u32,
    /// Greatest number of particles [default: 128000; 16000 hard discs]
    #[arg(long, value_name = "N")]
    to: Option<u32>,
    /// Numbers of threads, or ranks, separated by commas
    #[arg(short, default_value = "1", value_name = "WORKERS", value_delimiter = ',', value_parser = clap::value_parser!(u16).range(1..))]
    t: Vec<u16>,
    #[command(flatten)]
    discs: Discs,
    #[command(flatten)]
    effort: Effort,
    /// Only look whether it works: small scenes, a few seconds
    #[arg(long, conflicts_with_all = ["to", "steps", "rounds", "seconds"])]
    quick: bool,
    #[command(flatten)]
    files: Files,
}

/// One program's times over all sizes.
struct Line {
    program: Program,
    workers: usize,
    points: Vec<Measured>,
    /// Pairs looked at in one step, for each point; none where the program does not count them.
    pair_tests: Vec<Option<f64>>,
}

/// Measures, prints, writes.
pub fn run(kit: &Kit, mut options: Options) -> Result<ExitCode> {
    if options.quick {
        options.to = Some(8 * options.from);
        (options.effort.rounds, options.effort.seconds) = (2, 2.0);
    }
    let hard = options.subject.package()?.is_hard();
    let to = options.to.unwrap_or(if hard { 16_000 } else { 128_000 });
    ensure!(options.from < to, "--from {} must be less than --to {to}", options.from);
    let sizes: Vec<usize> = std::iter::successors(Some(options.from as usize), |n| Some(2 * n))
        .take_while(|n| *n <= to as usize)
        .collect();
    ensure!(sizes.len() > 1, "--to {to} must be at least twice --from {}", options.from);

    let (runner, programs) = options.subject.build(kit, &[], false)?;
    let mut jobs = Vec::new();
    let scenes = sizes.iter().map(|&n| options.discs.scene(Some(n), hard));
    let scenes: Vec<Scene> = scenes.collect::<Result<_>>()?;
    let Effort { steps, rounds, .. } = options.effort;
    let share = options.effort.share(programs.len() * options.t.len() * sizes.len());
    for program in &programs {
        for &workers in &options.t {
            let job = |&scene: &Scene| Job {
                program: program.clone(),
                scene,
                steps: 1,
                workers: workers.into(),
                statistics: false,
            };
            match steps {
                Some(steps) => jobs.extend(scenes.iter().map(|scene| Job { steps, ..job(scene) })),
                None => jobs.extend(affordable(&runner, scenes.iter().map(job), share)?),
            }
        }
    }
    let rounds = measure(&runner, &jobs, rounds.into())?;
    let lines = lines(&runner, &rounds)?;
    show::print(&lines, &rounds);
    options.files.write(show::results(&lines, &rounds), &[show::chart(&lines)])?;
    Ok(ExitCode::SUCCESS)
}

/// Fits the steps of jobs on growing scenes to `share` seconds a run. Stops where a single step
/// would take far longer, as all pairs of a large scene do.
fn affordable(runner: &Runner, jobs: impl Iterator<Item = Job>, share: f64) -> Result<Vec<Job>> {
    let mut fitted: Vec<Job> = Vec::new();
    for job in jobs {
        let n = job.scene.n() as f64;
        // At worst, twice the particles take four times as long.
        let forecast = fitted
            .last()
            .map_or(0.0, |last| share / last.steps as f64 * (n / last.scene.n() as f64).powi(2));
        if fitted.len() > 1 && forecast > 2.0 * share {
            eprintln!(
                "{} from n = {n} on is left out: a step would take seconds (see --seconds)",
                job.program
            );
            break;
        }
        let steps = steps::that_take(runner, &job, share)?;
        fitted.push(Job { steps, ..job });
    }
    Ok(fitted)
}

/// Sorts what was measured by program, and counts the pairs in short runs of their own.
fn lines(runner: &Runner, rounds: &Rounds) -> Result<Vec<Line>> {
    let mut lines: Vec<Line> = Vec::new();
    for measured in &rounds.measured {
        let Job { program, workers, .. } = &measured.job;
        let found = lines.iter().position(|l| l.program == *program && l.workers == *workers);
        let at = found.unwrap_or_else(|| {
            let (program, workers) = (program.clone(), *workers);
            lines.push(Line { program, workers, points: Vec::new(), pair_tests: Vec::new() });
            lines.len() - 1
        });
        lines[at].pair_tests.push(pair_tests(runner, &measured.job)?);
        lines[at].points.push(measured.clone());
    }
    Ok(lines)
}

/// Pairs looked at in a step: the average of some, as the start, a lattice, is no typical scene.
fn pair_tests(runner: &Runner, job: &Job) -> Result<Option<f64>> {
    let few = job.steps.min(100);
    let outcome =
        runner.run(&Job { steps: few, statistics: !job.program.is_hard(), ..job.clone() })?;
    let counted = outcome.counters.get("pair tests").map(|total| total / few as f64);
    let observed = outcome.statistics.map(|s| s.pair_tests * job.scene.n() as f64);
    Ok(observed.or(counted))
}

impl Line {
    /// (n, seconds of a step), by shortest takes or by medians.
    fn seconds(&self, of: impl Fn(&Measured) -> f64) -> Vec<(f64, f64)> {
        let step = |m: &Measured| (m.job.scene.n() as f64, of(m) / m.job.steps as f64);
        self.points.iter().map(step).collect()
    }

    /// The exponent of n by the shortest takes.
    fn slope(&self) -> f64 {
        slope(&self.seconds(|m| m.times.min()))
    }

    /// The exponent of n by the medians.
    fn slope_of_medians(&self) -> f64 {
        slope(&self.seconds(|m| m.times.median()))
    }

    /// (n, pairs looked at in a step), where they are counted.
    fn pairs(&self) -> Vec<(f64, f64)> {
        let point =
            |(m, pairs): (&Measured, &Option<f64>)| Some((m.job.scene.n() as f64, (*pairs)?));
        self.points.iter().zip(&self.pair_tests).filter_map(point).collect()
    }

    /// What the tables and the chart call it.
    fn name(&self) -> String {
        match self.workers {
            1 => self.program.to_string(),
            p if self.program.has_ranks() => format!("{}, {p} ranks", self.program),
            p => format!("{}, {p} threads", self.program),
        }
    }
}
