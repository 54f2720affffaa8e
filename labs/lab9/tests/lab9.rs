//! Lab 9's graders.

use std::collections::BTreeSet;
use std::io::{self, Write};
use std::sync::Mutex;

use common::hard::Scene;
use common::soft;
use device::{Gpu, GpuError, Launcher, Real, refuse_todo};
use device_discs::hard::{Choice, Deal, Finder, HardDiscs, HardKernels};
use device_discs::soft::{Double, Grid, Options, SoftDiscs, SoftKernels};
use lab9::{HARD_VARIANTS, Lab9, VARIANTS};
use oracle::hard::{self, difference};
use oracle::{Columns, Grader, Random, ask, right, scenes, spaced, within};

use self::launched::{SMALL, sums_before};

#[path = "lab9/launched.rs"]
mod launched;
#[path = "lab9/questions.rs"]
mod questions;

/// Stops at the todo of a task before anything else can, device or not.
fn visit(task: &str) {
    let source = match task {
        "9.1" => {
            let _ = Lab9::launch(1, 1, &wgpu::Limits::default());
            return;
        }
        "9.2" => Lab9::filter(),
        "9.3" => Lab9::basic(),
        "9.4" => Lab9::balanced(),
        "9.5" => Lab9::choose(),
        "9.6" => Lab9::scan(),
        "9.7" => Lab9::sort(),
        "9.8" => Lab9::position_f32(),
        _ => return,
    };
    refuse_todo(&[source]);
}

/// Says once that tests, or parts of them, do not run here. `eprintln` would be kept from the
/// reader, since a test that has nothing to run on passes.
fn skip(what: &str, why: &GpuError) {
    static SAID: Mutex<BTreeSet<String>> = Mutex::new(BTreeSet::new());
    let line = format!("{what}: {why}\n");
    if SAID.lock().expect("no test panics here").insert(line.clone()) {
        io::stderr().write_all(line.as_bytes()).expect("standard error is open");
    }
}

/// Whether there is a device. If not, the test has nothing to run on, and says so.
fn has_adapter() -> bool {
    match Gpu::shared() {
        Ok(_) => true,
        Err(error @ (GpuError::NoAdapter | GpuError::NoSuchAdapter { .. })) => {
            skip("skipped", &error);
            false
        }
        Err(error) => panic!("{error}"),
    }
}

/// Runs `check` on the device, under the watchdog.
fn on_device(task: &'static str, check: impl FnOnce(&'static Gpu) + Send + 'static) {
    visit(task);
    if has_adapter() {
        within(task, 120, || check(Gpu::shared().expect("it is there")));
    }
}

/// Whether the device computes in f64; if not, says that some tests leave that out.
fn has_doubles(gpu: &Gpu) -> bool {
    gpu.expect_real::<f64>().inspect_err(|error| skip("left out", error)).is_ok()
}

#[test]
fn task_9_1_launches_within_the_limits() {
    questions::launches(&mut Random::new(91), &mut right);
}

#[test]
fn task_9_1_a_launch_that_never_ran_is_an_error() {
    on_device("9.1", |gpu| questions::refusals(gpu, &mut right));
}

#[test]
fn task_9_6_table_of_blocks() {
    on_device("9.6", |gpu| {
        const THREADS: usize = 3;
        let numbers = [3, 1, 4, 1, 5, 9, 2, 6, 5];
        let blocks: Vec<&[u32]> = numbers.chunks(THREADS).collect();
        let alone = blocks.iter().map(|block| sums_before(gpu, block, THREADS as u32));
        let alone: Vec<Vec<u32>> = alone.collect();
        // What a block holds all in all: the sum before its last number, and that number.
        let sums: Vec<u32> =
            blocks.iter().zip(&alone).map(|(block, sums)| block[2] + sums[2]).collect();
        let before = sums_before(gpu, &sums, THREADS as u32);
        let all = sums_before(gpu, &numbers, THREADS as u32);
        let mut table = Columns::new((0..blocks.len()).map(|block| format!("workgroup {block}")));
        table.row("particles in bins: counts", blocks.iter().map(|block| spaced(*block)));
        table.row("counts before, in its own block", alone.iter().map(spaced));
        table.row("its sum: a count", sums.iter().map(u32::to_string));
        table.row("counts in the blocks before", before.iter().map(u32::to_string));
        table.row("added: counts before, in all", all.chunks(THREADS).map(spaced));
        insta::assert_snapshot!(table.to_string());
    });
}

// The tests of kernels, one file for each problem.
include!("lab9/hard.rs");
include!("lab9/soft.rs");
