//! `cargo lab complexity`: the growth of the time with the number of particles.

mod growth;
mod line;

use anyhow::{Result, ensure};
use clap::Args;
use lab_kit::Kit;
use serde::{Deserialize, Serialize};

use crate::chart::Sheet;
use crate::experiment::{Bound, Timing};
use crate::fit::{Effort, Fit, MOST_STEPS};
use crate::job::Job;
use crate::numbers::Files;
use crate::over::Varied;
use crate::scene_options::DiscOptions;
use crate::subject::Subject;
use line::Line;

/// Measure how the time grows with the number of particles, and grade it
///
/// Times a variant on scenes that double in size, and fits a line through the points on logarithmic
/// axes. The slope of the line is the exponent of n. The command also counts the pairs that the
/// program tests, which do not depend on noise. A slope of the time below 1.3 earns the full grade.
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
    discs: DiscOptions,
    #[command(flatten)]
    effort: Effort,
    #[command(flatten)]
    pub(super) files: Files,
}

#[derive(Deserialize, Serialize)]
pub(super) struct Results {
    lines: Vec<Line>,
    streaming_bound: Vec<Bound>,
}

impl Options {
    pub(super) fn draw(&self, Results { lines, .. }: Results) -> Result<Sheet> {
        Ok(vec![vec![growth::chart(&lines)]])
    }
}

pub(super) fn run(kit: &Kit, options: Options) -> Result<()> {
    let hard = options.subject.package()?.is_hard();
    let from = options.from;
    let to = options.to.unwrap_or(if hard { 16_000 } else { 128_000 });
    let doubled = std::iter::successors(Some(from), |n| n.checked_mul(2));
    let sizes: Vec<f64> = doubled.take_while(|n| *n <= to).map(f64::from).collect();
    ensure!(sizes.len() > 1, "--to {to} must be at least twice --from {from}");

    let (runner, programs) = options.subject.build(kit, &[], false)?;
    let mut jobs = Vec::new();
    let scene = options.discs.scene(None, hard)?;
    for program in programs {
        for &workers in &options.t {
            let like = Job { workers: workers.into(), ..Job::new(program.clone(), scene.clone()) };
            jobs.extend(Varied::N.jobs(&sizes, std::slice::from_ref(&program), &like));
        }
    }
    let fit = Fit::Each { most: MOST_STEPS, affordable: true };
    let timings = options.effort.run(&runner, jobs, fit)?;
    eprint!("{}", timings.left_out_in_words());
    let mut lines = Vec::new();
    for of_line in timings.timings.chunk_by(is_same_line) {
        let line = Line::new(&runner, of_line)?;
        println!("{}\n\n{}", line.name(), line.table(&timings));
        println!("{}\n", line.verdict());
        lines.push(line);
    }
    let results = Results { lines, streaming_bound: timings.bounds };
    options.files.write(results, |shown| options.draw(shown))
}

fn is_same_line(a: &Timing, b: &Timing) -> bool {
    a.job.program == b.job.program && a.job.workers == b.job.workers
}
