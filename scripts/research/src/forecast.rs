//! `cargo lab forecast`: what more workers would bring than there are here.
//!
//! A step that takes t₁ on one worker takes t₁ ((1 + σ (p − 1)) / p + κ (p − 1)) + c (p − 1) on p: σ is the part that
//! is not shared out (Amdahl), κ what each further worker costs for each particle, and c what it costs in any
//! step (as in Gunther's universal scalability law).

use std::path::PathBuf;
use std::process::ExitCode;

use anyhow::{Context, Result, ensure};
use clap::Args;
use lab_kit::Kit;
use lab_kit::machine::doubled_up_to;
use lab_kit::program::Program;
use lab_kit::table::Table;
use lab_measure::chart::{Axis, Chart, Kind, Series, Sheet};
use lab_measure::columns::Columns;
use lab_measure::experiment::Record;
use lab_measure::files::{Files, Report};
use lab_measure::published::{SOFT_STEPS, growth, scaling};
use serde::{Deserialize, Serialize};

/// Foresee from one and two workers what many would bring: computed, not measured
///
/// Takes what 'cargo lab scaling --json' wrote. Two workers say how much of a step is not shared out; what each
/// further worker costs is taken from the course reports, which ran on up to 32 threads. The range is that
/// between a further worker that costs nothing and the dearest of the reports, and between shortest and median takes.
#[derive(Args)]
pub(crate) struct Options {
    /// Files that 'cargo lab scaling --json' wrote
    #[arg(required = true, value_name = "SCALING")]
    scaling: Vec<PathBuf>,
    /// Variants, separated by commas [default: all]
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    variant: Vec<String>,
    #[command(flatten)]
    pub(crate) files: Files,
}

/// The most workers that are foreseen.
const MOST: usize = 64;

/// Particles that CS267's tables of 4, 16 and 32 threads are taken at.
const SIZES: [f64; 4] = [500.0, 5000.0, 50_000.0, 500_000.0];

/// What more workers cost.
#[derive(Clone, Copy, Debug, Default, Deserialize, Serialize)]
struct Law {
    sigma: f64,
    kappa: f64,
    /// Seconds of a step.
    c: f64,
}

#[derive(Deserialize, Serialize)]
struct Fitted {
    report: String,
    n: f64,
    /// Seconds of a step on one worker, by the fit.
    one: f64,
    law: Law,
    /// Workers, and printed speed-up against that.
    speedups: Vec<(f64, f64)>,
}

#[derive(Deserialize, Serialize)]
struct Foreseen {
    name: String,
    /// Workers; speed-up, the least and the greatest.
    speedups: Vec<(f64, f64, f64, f64)>,
}

#[derive(Deserialize, Serialize)]
pub(crate) struct Results {
    kind: String,
    reports: Vec<Fitted>,
    programs: Vec<Foreseen>,
}

/// What a file of scaling says of a variant on a number of workers.
#[derive(Deserialize)]
struct Point {
    workers: usize,
    #[serde(flatten)]
    record: Record,
}

impl Options {
    pub(crate) fn draw(&self, Results { reports, programs, .. }: Results) -> Result<Sheet> {
        let all = doubled_up_to(MOST).into_iter().map(|p| p as f64);
        let ideal = all.clone().map(|p| (p, p)).collect();
        let line = |program: Foreseen| {
            let middle = program.speedups.iter().map(|at| (at.0, at.1)).collect();
            let band = program.speedups.iter().map(|at| (at.0, at.2, at.3)).collect();
            Series::new(Kind::Model, program.name, middle).with_band(band)
        };
        // Of the four sizes of a report the least and the greatest.
        let shown =
            reports.into_iter().filter(|report| report.n != SIZES[1] && report.n != SIZES[2]);
        let chart = Chart::new(
            "A model from one and two workers, not measured",
            Axis::log("workers").with_ticks(all),
            Axis::log("times as fast as one"),
        )
        .with_all(programs.into_iter().map(line))
        .with_all(shown.map(|report| Series::new(Kind::Published, report.report, report.speedups)))
        .with(Series::new(Kind::Guide, "ideal", ideal));
        Ok(vec![vec![chart]])
    }
}

/// Computes, prints, writes.
pub(crate) fn run(_: &Kit, options: &Options) -> Result<ExitCode> {
    let reports = reports();
    let mut programs = Vec::new();
    for file in &options.scaling {
        let results = Report::read(file)?.results;
        for curve in results["curves"].as_array().context("not of cargo lab scaling")? {
            let strong = Vec::<Point>::deserialize(&curve["strong"])?;
            let on = |p| strong.iter().find(|point| point.workers == p);
            let Some((one, two)) = on(1).zip(on(2)) else { continue };
            let Program { lab, variant, .. } = &one.record.job.program;
            let variant = variant.clone().unwrap_or_default();
            if options.variant.is_empty() || options.variant.contains(&variant) {
                let name = format!("lab {lab}: {variant}");
                programs.push(Foreseen::new(name, (&one.record, &two.record), &reports));
            }
        }
    }
    ensure!(!programs.is_empty(), "no such variant has run on one and on two workers");
    println!("A model: computed, not measured.\n\n{}\n{}", fits(&reports), table(&programs));
    let kind = "model: computed, not measured".into();
    options.files.write(Results { kind, reports, programs }, |shown| options.draw(shown))?;
    Ok(ExitCode::SUCCESS)
}

impl Law {
    /// How many times as fast `p` workers are as one, which takes `one` seconds for a step.
    fn speedup(self, one: f64, p: f64) -> f64 {
        let Self { sigma, kappa, c } = self;
        let others = p - 1.0;
        1.0 / ((1.0 + sigma * others) / p + (kappa + c / one) * others)
    }

    /// The law of such further workers by which two take `two` of one's time.
    fn of_two(further: Self, one: f64, two: f64) -> Self {
        let unshared = 2.0 * (two - further.kappa - further.c / one) - 1.0;
        Self { sigma: unshared.clamp(0.0, 1.0), ..further }
    }
}

impl Fitted {
    /// The law that comes nearest to (workers, seconds of a step), where the time on one worker is not known: in
    /// steps of a twentieth of a decade, by the squares of the logarithms.
    fn new(report: &str, n: f64, points: &[(f64, f64)]) -> Self {
        let values =
            || (0..=80).map(|k| if k == 0 { 0.0 } else { 10f64.powf(f64::from(k) / 20.0 - 4.0) });
        let laws =
            values().flat_map(|sigma| values().map(move |kappa| Law { sigma, kappa, c: 0.0 }));
        let off = |law: Law| {
            let logs = points.iter().map(|&(p, t)| (t * law.speedup(1.0, p)).ln());
            let mean = logs.clone().sum::<f64>() / points.len() as f64;
            (logs.map(|log| (log - mean).powi(2)).sum::<f64>(), mean.exp())
        };
        let nearest = laws.min_by(|a, b| off(*a).0.total_cmp(&off(*b).0)).unwrap_or_default();
        let one = off(nearest).1;
        // With so few particles what a worker costs has nothing to do with their number.
        let few = n <= SIZES[0];
        let law = if few { Law { kappa: 0.0, c: nearest.kappa * one, ..nearest } } else { nearest };
        let speedups = points.iter().map(|&(p, t)| (p, one / t)).collect();
        Self { report: report.into(), n, one, law, speedups }
    }
}

/// The reports' tables of threads and ranks, each with its law.
fn reports() -> Vec<Fitted> {
    let mut fitted = Vec::new();
    for (name, report) in [("csc581-openmp", "CSC581, threads"), ("csc581-mpi", "CSC581, ranks")] {
        let points: Vec<_> =
            scaling(name).strong.iter().map(|&(p, t)| (p as f64, t / SOFT_STEPS)).collect();
        fitted.push(Fitted::new(report, 500.0, &points));
    }
    for n in SIZES {
        let at = |threads: f64| {
            let table = growth(&format!("cs267-{threads}-threads"));
            let point = table.points.iter().find(|point| point.0 == n);
            point.map(|point| (threads, point.1 / SOFT_STEPS))
        };
        let points: Vec<_> = [4.0, 16.0, 32.0].into_iter().filter_map(at).collect();
        fitted.push(Fitted::new(&format!("CS267, {n} particles"), n, &points));
    }
    fitted
}

impl Foreseen {
    fn new(name: String, (one, two): (&Record, &Record), reports: &[Fitted]) -> Self {
        let seconds = one.ms().min / 1e3;
        let most =
            |of: fn(&Law) -> f64| reports.iter().map(|report| of(&report.law)).fold(0.0, f64::max);
        let dearest = Law { sigma: 0.0, kappa: most(|law| law.kappa), c: most(|law| law.c) };
        let half = Law { sigma: 0.0, kappa: dearest.kappa / 2.0, c: dearest.c / 2.0 };
        let shortest = two.ms().min / one.ms().min;
        let medians = two.ms().median / one.ms().median;
        let at = |p: usize| {
            let p = p as f64;
            let speedup = |further, two| Law::of_two(further, seconds, two).speedup(seconds, p);
            let ends = [Law::default(), dearest]
                .into_iter()
                .flat_map(|further| [speedup(further, shortest), speedup(further, medians)]);
            let (low, high) =
                ends.fold((f64::INFINITY, 0.0f64), |(low, high), x| (low.min(x), high.max(x)));
            (p, speedup(half, shortest).clamp(low, high), low, high)
        };
        Self { name, speedups: doubled_up_to(MOST).into_iter().map(at).collect() }
    }
}

fn fits(reports: &[Fitted]) -> Table {
    Columns::of("report", |report: &Fitted| report.report.clone())
        .number("not shared out", |report| Some(report.law.sigma))
        .number("a further worker: of a step", |report| Some(report.law.kappa))
        .number("us", |report| Some(1e6 * report.law.c))
        .table(reports)
}

fn table(programs: &[Foreseen]) -> Table {
    let cell = |program: &Foreseen, p: usize| {
        let at = program.speedups.iter().find(|at| at.0 == p as f64);
        at.map_or(String::new(), |(_, _, low, high)| format!("{low:.1} to {high:.1}"))
    };
    let columns = Columns::of("times as fast as one", |program: &Foreseen| program.name.clone());
    let add = |columns: Columns<'static, Foreseen>, p: usize| {
        columns.text(format!("{p} workers"), move |program| cell(program, p))
    };
    doubled_up_to(MOST).into_iter().skip(1).fold(columns, add).table(programs)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_law_is_found_again_from_its_times() {
        let law = Law { sigma: 0.1, kappa: 0.001, c: 0.0 };
        let points = [4.0, 16.0, 32.0].map(|p| (p, 2.0 / law.speedup(2.0, p)));
        let found = Fitted::new("", 5000.0, &points);
        assert!((found.law.sigma / 0.1 - 1.0).abs() < 0.1, "{:?}", found.law);
        assert!((found.law.kappa / 0.001 - 1.0).abs() < 0.1, "{:?}", found.law);
        assert!((found.one - 2.0).abs() < 0.05, "{}", found.one);
    }

    #[test]
    fn two_workers_are_as_fast_as_they_were() {
        let further = Law { sigma: 0.0, kappa: 0.001, c: 1e-6 };
        let speedup = Law::of_two(further, 1e-3, 0.6).speedup(1e-3, 2.0);
        assert!((speedup - 1.0 / 0.6).abs() < 1e-12, "{speedup}");
    }

    /// The printed tables, foreseen from their first two workers: one lies within, one below, one above.
    #[test]
    fn reports_show_how_far_the_model_can_be_off() {
        let reports = reports();
        let dearest = reports.iter().map(|report| report.law.c).fold(0.0, f64::max);
        let foreseen = |name: &str, steps: f64, last: usize| {
            let strong = &scaling(name).strong;
            let on = |p| strong.iter().find(|point| point.0 == p).map_or(f64::NAN, |point| point.1);
            let speedup = |c| {
                let further = Law { c, ..Law::default() };
                Law::of_two(further, on(1) / steps, on(2) / on(1))
                    .speedup(on(1) / steps, last as f64)
            };
            (on(1) / on(last), speedup(dearest), speedup(0.0))
        };
        let (printed, low, high) = foreseen("csc581-openmp", 1000.0, 16);
        assert!((low..high).contains(&printed), "{printed}: {low} to {high}");
        let (printed, low, _) = foreseen("csc581-mpi", 1000.0, 16);
        assert!((0.7 * low..1.2 * low).contains(&printed), "{printed}: {low}");
        let (printed, _, high) = foreseen("cs3210-openmp", 50.0, 20);
        assert!((2.0..3.0).contains(&(printed / high)), "{printed}: {high}");
    }
}
