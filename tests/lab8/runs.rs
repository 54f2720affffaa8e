//! Questions about whole runs: the bits of one rank, the counters, and the lab's own program.

use std::fs;
use std::path::Path;

use hard_disc_ranks::DiscWire;
use lab8::VARIANTS;
use mpi::topology::SimpleCommunicator;
use oracle::hard::scenes;
use oracle::mpiexec::{Job, ends_when_a_rank_is_killed};
use oracle::{Ask, Random};
use oracle_mpi::DiscsOnRanks;

use super::crowds::{all_scenes, wide, zigzag};

/// Number of steps of a run whose bits are compared.
const STEPS: usize = 6;

const MASTER_WORKERS: &str = "master-workers";
const SPATIAL_CUTS: &str = "spatial-cuts";

fn master_workers(ranks: &[usize]) -> DiscsOnRanks {
    DiscsOnRanks::new("8.7", VARIANTS, MASTER_WORKERS, ranks)
}

fn spatial_cuts(ranks: &[usize]) -> DiscsOnRanks {
    DiscsOnRanks::new("8.13", VARIANTS, SPATIAL_CUTS, ranks)
}

fn bits_of_sequential(runs: &DiscsOnRanks, random: &mut Random, ask: &mut impl Ask) {
    runs.bits_of(ask, &solution7::VARIANTS[0], &all_scenes(random), STEPS);
}

pub(crate) fn bits_with_master(random: &mut Random, ask: &mut impl Ask) {
    bits_of_sequential(&master_workers(&[1, 2, 3, 4, 5]), random, ask);
}

pub(crate) fn master_works(random: &mut Random, ask: &mut impl Ask) {
    bits_of_sequential(&master_workers(&[2, 4]).set("master-works", 1.0), random, ask);
}

pub(crate) fn blocks_again(random: &mut Random, ask: &mut impl Ask) {
    bits_of_sequential(&master_workers(&[3]).set("keep", 0.0), random, ask);
}

/// Asks for the report's program, which is given but uses tasks 8.1 to 8.5.
pub(crate) fn as_reported(random: &mut Random, ask: &mut impl Ask) {
    let runs = DiscsOnRanks::new("8.7", VARIANTS, "as-reported", &[1, 2, 3, 4, 5]);
    // Runs this task's functions first, so that an unsolved starter stops at the task's `todo!`.
    bits_of_sequential(&runs.first(a_step_of_master_workers), random, ask);
}

fn a_step_of_master_workers(world: &SimpleCommunicator) {
    let mut engine = master_workers(&[]).engine(world);
    engine.load(&scenes::of(10.0, 1.0, &[(3.0, 3.0, 2.0, 2.0)]));
    engine.step();
}

pub(crate) fn counts_with_master(_: &mut Random, ask: &mut impl Ask) {
    let names = ["pair tests", "candidates", "pair collisions", "wall collisions"];
    let scene = scenes::random(400, 0.3, 2.0, 1);
    let runs = master_workers(&[1, 3]);
    runs.counters_of(ask, &solution7::VARIANTS[0], (&scene, 3), &names);
}

pub(crate) fn shares_with_master(random: &mut Random, ask: &mut impl Ask) {
    shares(&master_workers(&[4]), random, ask);
}

/// Asks whether ranks share the search for pairs. Three of four ranks are workers, or each rank has
/// a strip with an equal number of discs.
fn shares(runs: &DiscsOnRanks, random: &mut Random, ask: &mut impl Ask) {
    let scene = wide(random);
    let names = ["pair tests, busiest rank", "pair tests"];
    runs.counters(ask, (&scene, 4), &names, |found| match 3.0 * found[0] > 2.0 * found[1] {
        true => Err(format!(
            "the busiest rank tests {} of all {} pairs, but may test at most two thirds",
            found[0], found[1]
        )),
        false => Ok(()),
    });
}

pub(crate) fn memory_with_master(_: &mut Random, ask: &mut impl Ask) {
    master_workers(&[3]).keeps_its_memory(ask);
}

pub(crate) fn bits_with_cuts(random: &mut Random, ask: &mut impl Ask) {
    bits_of_sequential(&spatial_cuts(&[1, 2, 3, 4, 5]), random, ask);
}

pub(crate) fn many_rounds(random: &mut Random, ask: &mut impl Ask) {
    let scenes = [("a zigzag", zigzag(3.0)), ("other speeds", zigzag(random.between(2.9, 3.1)))];
    spatial_cuts(&[2, 4]).bits_of(ask, &solution7::VARIANTS[0], &scenes, 1);
}

pub(crate) fn cuts_that_move(random: &mut Random, ask: &mut impl Ask) {
    bits_of_sequential(&spatial_cuts(&[4]).set("recut", 1.0), random, ask);
}

pub(crate) fn counts_with_cuts(_: &mut Random, ask: &mut impl Ask) {
    let names = ["candidates", "pair collisions", "wall collisions"];
    let scene = scenes::random(400, 0.3, 2.0, 1);
    spatial_cuts(&[1, 4]).counters_of(ask, &solution7::VARIANTS[0], (&scene, 3), &names);
}

/// Asks about 40 discs per unit of height, whose boxes reach less than a unit beyond each of three
/// cuts.
pub(crate) fn only_what_crosses(_: &mut Random, ask: &mut impl Ask) {
    let scene = scenes::random(4000, 0.1, 2.0, 813);
    let names = ["ghosts per step, all ranks", "bytes per step, busiest rank"];
    let all_bytes = (4000 * size_of::<DiscWire>()) as f64;
    spatial_cuts(&[4]).counters(ask, (&scene, 3), &names, |found| {
        if !(20.0..240.0).contains(&found[0]) {
            return Err(format!(
                "the ranks get {} ghosts in a step at three cuts, but must get 20 to 240",
                found[0]
            ));
        }
        match found[1] < all_bytes / 4.0 {
            true => Ok(()),
            false => Err(format!(
                "a rank sends {} bytes in a step, but may send less than a quarter of the {all_bytes} bytes of all \
                 discs",
                found[1]
            )),
        }
    });
}

pub(crate) fn shares_with_cuts(random: &mut Random, ask: &mut impl Ask) {
    shares(&spatial_cuts(&[4]), random, ask);
}

pub(crate) fn memory_with_cuts(_: &mut Random, ask: &mut impl Ask) {
    spatial_cuts(&[2]).keeps_its_memory(ask);
}

pub(crate) fn program_with_master(_: &mut Random, ask: &mut impl Ask) {
    ask.in_tests_only(|| {
        killed_rank_ends_the_job("8.7", MASTER_WORKERS);
        bad_input_ends_the_job_with_one_line();
    });
}

pub(crate) fn program_with_cuts(_: &mut Random, ask: &mut impl Ask) {
    ask.in_tests_only(|| killed_rank_ends_the_job("8.13", SPATIAL_CUTS));
}

/// Returns a job that simulates `input` with a variant. The input is written to a file in `folder`.
fn job(task: &str, folder: &Path, variant: &str, ranks: usize, input: &str) -> Job {
    let program = option_env!("CARGO_BIN_EXE_lab8").or(option_env!("CARGO_BIN_EXE_solution8"));
    let path = folder.join("input.txt");
    fs::write(&path, input).expect("the temporary folder is writable");
    let job = Job::new(task, program.expect("the lab has its own program"), ranks);
    job.args(["--variant", variant]).arg(path)
}

fn killed_rank_ends_the_job(task: &str, variant: &str) {
    let folder = tempfile::tempdir().expect("the temporary folder is writable");
    let long = |steps: u64| format!("40 30 1 {steps} perf");
    // Only a correct program can be killed in the middle of a run.
    job(task, folder.path(), variant, 3, &long(3)).arg("--json").succeed();
    let out = folder.path().join("never-complete.txt");
    let job = job(task, folder.path(), variant, 3, &long(1_000_000_000)).arg("-o").arg(&out);
    let title = format!("task {task}, variant {variant}, 3 ranks");
    ends_when_a_rank_is_killed(&title, &job, &out);
}

fn bad_input_ends_the_job_with_one_line() {
    let folder = tempfile::tempdir().expect("the temporary folder is writable");
    let input = "3 10 1 5 perf\n0 5 5 0 0\n1 2 2 1 inf\n";
    let ended = job("8.7", folder.path(), MASTER_WORKERS, 3, input).run();
    assert!(!ended.status.success(), "an input that is not a scene was simulated");
    let lines: Vec<_> = ended.stderr.lines().filter(|l| l.starts_with("error")).collect();
    let expected = "input.txt: line 3: vy of disc 1: expected a finite number, found 'inf'";
    assert!(lines.len() == 1 && lines[0].ends_with(expected), "{}", ended.stderr);
}
