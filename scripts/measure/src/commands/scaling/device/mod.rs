//! `cargo lab scaling` of a device: what the size of a workgroup and the number of discs bring on a device.
//!
//! A graphics processor has no number of workers to vary. What a launch says instead is how large
//! a workgroup is. The device's own clock tells how long kernels run; what is left of a step is
//! the way there and back, and the host.

mod about;
mod show;

use std::collections::BTreeSet;
use std::process::ExitCode;

use anyhow::{Result, ensure};

use super::Options;
use crate::experiment::{Bound, Record};
use crate::files::Figure;
use crate::job::Job;
use crate::published::HARD_STEPS;
use crate::runner::Runner;
use crate::scene::Scene;
use about::Device;
use lab_kit::Kit;
use lab_kit::program::Program;
use serde::Serialize;
pub(super) use show::Runs;
use show::Split;

/// Unless it is said how many: hard discs are compared in pairs, so there are fewer of them.
const HARD: [usize; 6] = [500, 1000, 2000, 5000, 10_000, 20_000];
const SOFT: [usize; 4] = [1000, 10_000, 100_000, 1_000_000];

/// Sizes of workgroups, unless they are named. The last is beyond most devices' limit, as in the
/// CS3210 report.
const WORKGROUPS: [u32; 6] = [8, 32, 64, 256, 1024, 2048];

/// The workgroup while n varies.
const USUAL: u32 = 64;

/// A single step may take this share of all the time.
const LONGEST: f64 = 1.0 / 20.0;

/// A program at one n and one size of workgroup.
#[derive(Serialize)]
struct Point {
    #[serde(skip)]
    program: Program,
    n: usize,
    workgroup: u32,
    #[serde(flatten)]
    record: Option<Record>,
    #[serde(flatten)]
    split: Option<Split>,
    /// Why it was not measured.
    #[serde(skip_serializing_if = "Option::is_none")]
    not_measured: Option<String>,
}

/// All numbers.
#[derive(Serialize)]
struct Results<'r> {
    device: &'r Device,
    runs: &'r [Point],
    streaming_bound: &'r [Bound],
}

/// Measures, prints, writes.
pub(super) fn run(kit: &Kit, options: Options) -> Result<ExitCode> {
    ensure!(
        options.workers.is_empty() && options.per_worker.is_none() && options.counter.is_none(),
        "a device has no workers to vary: use --workgroup and -n"
    );
    let (runner, mut programs) = options.subject.build_any(kit, &[], true)?;
    let device = Device::ask(&runner, &options.subject.package()?)?;
    if options.quick {
        // The last of each kind: in single precision, which every device has.
        let last = |hard| programs.iter().rfind(|p| p.is_hard() == hard).cloned();
        programs = [last(false), last(true)].into_iter().flatten().collect();
    }
    println!("{device}");
    if !device.timestamps {
        println!(
            "It has no timestamps: kernels and the way there and back cannot be told apart.\n"
        );
    }
    let mut points = plan(&options, &programs);
    let mut experiment =
        options.effort.experiment(&runner, points.iter().map(Point::job).collect());
    let share = experiment.share();
    experiment.jobs.clear();
    let mut tried: Vec<Tried> = Vec::new();
    for point in &mut points {
        match steps(&runner, point, &mut tried, share, &options) {
            Ok(steps) => experiment.jobs.push(Job { steps, ..point.job() }),
            Err(why) => point.not_measured = Some(why),
        }
    }
    let records = experiment.run()?;
    for point in &mut points {
        let job = point.job();
        if let Some(record) = records.find(&job.program, &job.scene, job.workers) {
            point.split = Some(Split::of(point, record));
            point.record = Some(record.clone());
        }
    }
    show::print(&device, &points);
    println!("{}", records.bounds_in_words());
    let results = Results { device: &device, runs: &points, streaming_bound: &records.bounds };
    options.write(results)?;
    Ok(ExitCode::SUCCESS)
}

/// Each program at each n with the usual workgroup, and at one n with each workgroup.
fn plan(options: &Options, programs: &[Program]) -> Vec<Point> {
    let workgroups = match options.workgroup.as_slice() {
        [] if options.quick => vec![USUAL, 2048],
        [] => WORKGROUPS.to_vec(),
        sizes => sizes.to_vec(),
    };
    let usual = if workgroups.contains(&USUAL) { USUAL } else { workgroups[0] };
    let mut points: Vec<Point> = Vec::new();
    for program in programs {
        let sizes = match options.n.as_slice() {
            [] if options.quick => vec![500, 1000],
            [] if program.is_hard() => HARD.to_vec(),
            [] => SOFT.to_vec(),
            sizes => sizes.iter().map(|&n| n as usize).collect(),
        };
        // The middle one: large enough to show the device, small enough for its worst launch.
        let middle = sizes[sizes.len() / 2];
        let over_n = sizes.iter().map(|&n| (n, usual));
        let over_workgroups = workgroups.iter().map(|&workgroup| (middle, workgroup));
        let places: BTreeSet<_> = over_n.chain(over_workgroups).collect();
        points.extend(places.into_iter().map(|(n, workgroup)| Point {
            program: program.clone(),
            n,
            workgroup,
            record: None,
            split: None,
            not_measured: None,
        }));
    }
    points
}

/// How long a step took that was tried.
struct Tried {
    program: Program,
    n: usize,
    seconds: f64,
}

/// How many steps of a point take about `share` seconds, at most the report's 50. Whatever the
/// device refuses and whatever would take too long is not measured: the error says why.
fn steps(
    runner: &Runner,
    point: &Point,
    tried: &mut Vec<Tried>,
    share: f64,
    options: &Options,
) -> Result<u64, String> {
    let longest = options.effort.seconds * LONGEST;
    let same = |t: &&Tried| t.program == point.program && t.n <= point.n;
    if let Some(nearest) = tried.iter().filter(same).max_by_key(|t| t.n) {
        let power = if point.program.is_hard() { 2 } else { 1 };
        let expected = nearest.seconds * (point.n as f64 / nearest.n as f64).powi(power);
        if expected > longest && nearest.n < point.n {
            return Err(format!(
                "left out: a step would take about {expected:.1} s, and --seconds {} allows {longest:.1}",
                options.effort.seconds
            ));
        }
    }
    // The first step also finds kernels that the driver has not translated yet.
    let job = Job { steps: 2, ..point.job() };
    let seconds = runner.run(&job).map_err(|e| refusal(&e))?.seconds / 2.0;
    tried.push(Tried { program: point.program.clone(), n: point.n, seconds });
    Ok(options
        .effort
        .steps
        .unwrap_or((share / seconds.max(1e-9)) as u64)
        .clamp(1, HARD_STEPS as u64))
}

/// A program's own words without its name.
fn refusal(error: &anyhow::Error) -> String {
    let words = error.root_cause().to_string();
    format!("not run: {}", words.split_once(" failed: ").map_or(&*words, |(_, words)| words))
}

impl Point {
    fn job(&self) -> Job {
        let mut program = self.program.clone();
        let own = [("workgroup", f64::from(self.workgroup)), ("timing", 1.0)];
        program.parameters.extend(own.map(|(name, value)| (name.to_owned(), value)));
        let scene = Scene::usual(Some(self.n), program.is_hard());
        Job::new(program, scene)
    }
}
