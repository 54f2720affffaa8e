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

use super::{Options, Shown};
use crate::experiment::{Bound, Record, Records};
use crate::files::Figure;
use crate::fit::Fit;
use crate::job::Job;
use crate::published::HARD_STEPS;
use crate::scene::Scene;
use about::Device;
use lab_kit::Kit;
use lab_kit::program::Program;
use serde::{Deserialize, Serialize};
use show::Split;

/// Unless it is said how many: hard discs are compared in pairs, so there are fewer of them.
const HARD: [usize; 6] = [500, 1000, 2000, 5000, 10_000, 20_000];
const SOFT: [usize; 4] = [1000, 10_000, 100_000, 1_000_000];

/// Sizes of workgroups, unless they are named. The last is beyond most devices' limit, as in the
/// CS3210 report.
const WORKGROUPS: [u32; 6] = [8, 32, 64, 256, 1024, 2048];

/// The workgroup while n varies.
const USUAL: u32 = 64;

/// One n and one size of workgroup of a program.
struct Setting {
    /// The program as it was asked for.
    name: String,
    n: usize,
    workgroup: u32,
    job: Job,
}

/// What came of it.
#[derive(Deserialize, Serialize)]
struct Point {
    n: usize,
    workgroup: u32,
    #[serde(flatten)]
    record: Option<Record>,
    #[serde(flatten, skip_deserializing)]
    split: Option<Split>,
    /// Why it was not measured.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    not_measured: Option<String>,
}

/// All numbers.
#[derive(Deserialize, Serialize)]
pub struct Results {
    device: Device,
    runs: Vec<Point>,
    streaming_bound: Vec<Bound>,
}

/// Measures, prints, writes.
pub(super) fn run(kit: &Kit, options: Options) -> Result<ExitCode> {
    ensure!(
        options.workers.is_empty() && options.per_worker.is_none() && options.counter.is_none(),
        "a device has no workers to vary: use --workgroup and -n"
    );
    let (runner, programs) = options.subject.build_any(kit, &[], true)?;
    let device = Device::ask(kit, &runner)?;
    println!("{device}");
    if !device.timestamps {
        println!(
            "It has no timestamps: kernels and the way there and back cannot be told apart.\n"
        );
    }
    let mut points = Vec::new();
    let settings = plan(&options, &programs);
    let jobs = settings.iter().map(|setting| setting.job.clone()).collect();
    let fit = Fit::Each { most: HARD_STEPS as u64, affordable: true };
    let records = options.effort.run(&runner, jobs, fit)?;
    for settings in settings.chunk_by(|a, b| a.job.is_like(&b.job)) {
        let Setting { name, job, .. } = &settings[0];
        let of_program: Vec<Point> =
            settings.iter().map(|setting| setting.point(&records)).collect();
        let table = show::table(&of_program, job.program.is_hard());
        println!("{name} on {}\n\n{table}", device.name);
        points.extend(of_program);
    }
    if device.software {
        println!(
            "These are times of the host's processor, which plays the device: they say what a\n\
             launch costs here, and nothing about a GPU."
        );
    }
    println!("{}", records.bounds_in_words());
    let results = Results { device, runs: points, streaming_bound: records.bounds };
    options.write(Shown::Device(results))?;
    Ok(ExitCode::SUCCESS)
}

/// Each program at each n with the usual workgroup, and at one n with each workgroup.
fn plan(options: &Options, programs: &[Program]) -> Vec<Setting> {
    let workgroups = match options.workgroup.as_slice() {
        [] => WORKGROUPS.to_vec(),
        sizes => sizes.to_vec(),
    };
    let usual = if workgroups.contains(&USUAL) { USUAL } else { workgroups[0] };
    let mut all: Vec<Setting> = Vec::new();
    for program in programs {
        let sizes = match options.n.as_slice() {
            [] if program.is_hard() => HARD.to_vec(),
            [] => SOFT.to_vec(),
            sizes => sizes.iter().map(|&n| n as usize).collect(),
        };
        // The middle one: large enough to show the device, small enough for its worst launch.
        let middle = sizes[sizes.len() / 2];
        let over_n = sizes.iter().map(|&n| (n, usual));
        let over_workgroups = workgroups.iter().map(|&workgroup| (middle, workgroup));
        let settings: BTreeSet<_> = over_n.chain(over_workgroups).collect();
        all.extend(settings.into_iter().map(|(n, workgroup)| {
            let (name, mut program) = (program.to_string(), program.clone());
            let own = [("workgroup", f64::from(workgroup)), ("timing", 1.0)];
            program.parameters.extend(own.map(|(name, value)| (name.to_owned(), value)));
            let scene = Scene::usual(Some(n), program.is_hard());
            Setting { name, n, workgroup, job: Job::new(program, scene) }
        }));
    }
    all
}

impl Setting {
    fn point(&self, records: &Records) -> Point {
        let Self { n, workgroup, job, .. } = self;
        let record = records.find(job).cloned();
        let mut left_out = records.left_out.iter();
        Point {
            n: *n,
            workgroup: *workgroup,
            split: record.as_ref().map(Split::of),
            record,
            not_measured: left_out.find(|(other, _)| other == job).map(|(_, why)| why.clone()),
        }
    }
}
