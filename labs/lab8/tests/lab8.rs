//! Lab 8's graders.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;
use std::process::ExitCode;
use std::slice;

use common::hard::{Disc, Scene, Simulation};
use common::{Config, Variant};
use common_mpi::as_rank;
use hard_disc_ranks::{CandidateWire, Deal, Decisions, DiscWire, Job, Reach};
use lab8::{VARIANTS, hear, jobs, news_for, take_certain};
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;
use oracle::hard::{difference, one_step, scenes};
use oracle::mpiexec::{self, ends_when_a_rank_is_killed};
use oracle::{Columns, Random, ask, right, within};
use solution7::{Candidate, Hit, Lab7, take_in_order};
use watched::test;

use self::given::{tower, zigzag};

#[path = "lab8/given.rs"]
mod given;
#[path = "lab8/messages.rs"]
mod messages;
#[path = "lab8/questions.rs"]
mod questions;

/// The lab's own program: the student's or the solution's.
const PROGRAM: &str =
    match (option_env!("CARGO_BIN_EXE_lab8"), option_env!("CARGO_BIN_EXE_solution8")) {
        (Some(program), _) | (None, Some(program)) => program,
        (None, None) => panic!("the lab has no program"),
    };

/// Has each rank of a job do `check`, on each of these numbers of ranks.
fn on_each(task: &str, counts: &[usize], check: impl FnOnce(&SimpleCommunicator)) {
    mpiexec::on_each(task, counts, || {
        as_rank(|world| {
            check(world);
            ExitCode::SUCCESS
        });
    });
}

fn variant(name: &str) -> &'static Variant<dyn Simulation> {
    VARIANTS.iter().find(|v| v.name == name).expect("the variant is there")
}

/// The discs after each of `steps` steps of a variant, as far as this rank sees them.
fn run(
    variant: &Variant<dyn Simulation>,
    config: &Config,
    scene: &Scene,
    steps: usize,
) -> Vec<Vec<Disc>> {
    let mut simulation = (variant.build)(config).expect("the variant can be built");
    simulation.load(scene);
    (0..steps)
        .map(|_| {
            simulation.step();
            let mut discs = scene.discs().to_vec();
            simulation.read(0, &mut discs);
            discs
        })
        .collect()
}

/// The variant, on all ranks of this job, has the bits of lab 7's `sequential` after every step.
fn bits_of_sequential(
    world: &SimpleCommunicator,
    name: &str,
    set: &[(&str, f64)],
    scenes: &[(&str, Scene)],
) {
    let variant = variant(name);
    let mut config = variant.config();
    for (parameter, value) in set {
        variant.set(&mut config, parameter, *value).expect("the variant has the parameter");
    }
    for (scene_name, scene) in scenes {
        let states = run(variant, &config, scene, 6);
        if world.rank() > 0 {
            continue;
        }
        let sequential = &solution7::VARIANTS[0];
        let expected = run(sequential, &sequential.config(), scene, 6);
        for (step, (expected, found)) in (1..).zip(expected.iter().zip(&states)) {
            if let Some(wrong) = difference(expected, found) {
                // What should have happened to a disc says more than a position.
                let before = if step > 1 { &*states[step - 2] } else { scene.discs() };
                let wrong = one_step(before, found, scene).unwrap_or(wrong);
                panic!(
                    "variant {name} {set:?}, {} ranks, scene {scene_name}, step {step}: {wrong}",
                    world.size()
                );
            }
        }
    }
}

/// The oracle's scenes and some that are hard on ranks.
fn all_scenes() -> Vec<(&'static str, Scene)> {
    let mut all = scenes::all();
    // All discs in the lowest hundredth of the square, and on one line that is no strip at all.
    let low: Vec<_> = (0..40).map(|k| (2.0 * f64::from(k) + 5.0, 1.0, 1.5, 0.2)).collect();
    all.push(("all in one strip", scenes::of(100.0, 1.0, &low)));
    let line: Vec<_> =
        (0..30).map(|k| (3.0 * f64::from(k) + 5.0, 50.0, f64::from(k % 3) - 1.0, 0.0)).collect();
    all.push(("all on one line", scenes::of(100.0, 1.0, &line)));
    all.push(("a tower", tower(8.0)));
    all.push(("a zigzag", zigzag(3.0)));
    all.push(("two discs", scenes::of(10.0, 1.0, &[(3.0, 3.0, 2.0, 2.0), (7.0, 7.0, -2.0, -2.0)])));
    all
}

/// A job that simulates `input` by a variant, written to a file in `folder`.
fn job(task: &str, folder: &Path, name: &str, ranks: usize, input: &str) -> mpiexec::Job {
    let path = folder.join("input.txt");
    fs::write(&path, input).expect("the temporary folder is writable");
    mpiexec::Job::new(task, PROGRAM, ranks).args(["--variant", name]).arg(path)
}

fn killed_rank_ends_the_job(task: &str, name: &str) {
    let folder = tempfile::tempdir().expect("the temporary folder is writable");
    let long = |steps: u64| format!("40 30 1 {steps} perf");
    // Only a program that works has a middle to be killed in.
    job(task, folder.path(), name, 3, &long(3)).arg("--json").succeed();
    let out = folder.path().join("never-complete.txt");
    let job = job(task, folder.path(), name, 3, &long(1_000_000_000)).arg("-o").arg(&out);
    let title = format!("task {task}, variant {name}, 3 ranks");
    ends_when_a_rank_is_killed(&title, &job, &out);
}

#[test]
fn bad_input_ends_the_job_with_one_line() {
    let folder = tempfile::tempdir().expect("the temporary folder is writable");
    let input = "3 10 1 5 perf\n0 5 5 0 0\n1 2 2 1 inf\n";
    let ended = job("8.7", folder.path(), "master-workers", 3, input).run();
    assert!(!ended.status.success(), "an input that is no scene was simulated");
    let lines: Vec<_> = ended.stderr.lines().filter(|l| l.starts_with("error")).collect();
    let expected = "input.txt: line 3: vy of disc 1: expected a finite number, found 'inf'";
    assert!(lines.len() == 1 && lines[0].ends_with(expected), "{}", ended.stderr);
}

/// What a variant counts in some steps, on the root.
fn counters(
    variant: &Variant<dyn Simulation>,
    scene: &Scene,
    steps: usize,
) -> Vec<(&'static str, f64)> {
    let mut simulation = (variant.build)(&variant.config()).expect("the variant can be built");
    simulation.load(scene);
    (0..steps).for_each(|_| simulation.step());
    simulation.counters()
}

fn value(counters: &[(&str, f64)], name: &str) -> f64 {
    counters.iter().find(|c| c.0 == name).unwrap_or_else(|| panic!("{name} is not counted")).1
}

/// All ranks of the variant together count what lab 7's `sequential` does.
fn counts_of_sequential(world: &SimpleCommunicator, name: &str, names: &[&str]) {
    let scene = scenes::random(400, 0.3, 2.0, 1);
    let found = counters(variant(name), &scene, 3);
    if world.rank() > 0 {
        return;
    }
    let expected = counters(&solution7::VARIANTS[0], &scene, 3);
    for name in names {
        let (found, expected) = (value(&found, name), value(&expected, name));
        assert_eq!(found, expected, "{name} of three steps on {} ranks", world.size());
    }
}

/// Candidates in words: which discs meet.
fn meetings(candidates: &[Candidate]) -> String {
    let words = candidates.iter().map(|candidate| match candidate.hit {
        Hit::Pair(a, b) => format!("{a}+{b}"),
        hit => format!("{}+wall", hit.first()),
    });
    let words: Vec<_> = words.collect();
    if words.is_empty() { "-".into() } else { words.join(" ") }
}

#[test]
fn task_8_11_table_of_news() {
    news_for(&Decisions::default(), 0);
    // A tower of eight discs on three ranks. Discs 2 and 5 are at the cuts, and known on both sides.
    let reach: [(usize, usize); 8] =
        [(0, 0), (0, 0), (0, 1), (1, 1), (1, 1), (1, 2), (2, 2), (2, 2)];
    let reach = reach.map(|(first, last)| Reach { first, last });
    let found = [
        vec![pair(0.25, 0, 1), pair(0.75, 1, 2)],
        vec![pair(0.5, 2, 3), pair(0.375, 3, 4), pair(0.25, 4, 5)],
        vec![pair(0.125, 5, 6), pair(0.5, 6, 7)],
    ];
    let mut all_ranks: Vec<Decisions> = (0..3)
        .map(|rank| {
            let here: Vec<u32> =
                (0..8).filter(|&disc| reach[disc as usize].contains(rank)).collect();
            let reach: Vec<Reach> = here.iter().map(|&disc| reach[disc as usize]).collect();
            let mut decisions = Decisions::default();
            decisions.start::<Lab7>(&here, &reach, &found[rank]);
            decisions
        })
        .collect();
    let mut table = Columns::new((0..3).map(|rank| format!("rank {rank}")));
    let timed = |c: &Candidate| format!("{} at {}", meetings(slice::from_ref(c)), c.time);
    table.row("finds", found.map(|found| found.iter().map(timed).collect::<Vec<_>>().join(", ")));
    for round in 1..=3 {
        all_ranks.iter_mut().for_each(take_certain);
        let taken = |decisions: &Decisions| meetings(&decisions.taken[decisions.told..]);
        table.row(format!("round {round}: takes"), all_ranks.iter().map(taken));
        let open = all_ranks.iter().map(|decisions| meetings(&decisions.front));
        table.row("  leaves open", open);
        let mut mail: Vec<Vec<CandidateWire>> = vec![Vec::new(); 3];
        for (partner, mail) in mail.iter_mut().enumerate() {
            let tells = all_ranks.iter().enumerate().map(|(rank, decisions)| {
                let news = if rank == partner { Vec::new() } else { news_for(decisions, partner) };
                let told = news.iter().map(|wire| {
                    let end = if wire.is_taken() { "taken" } else { "open" };
                    format!("{} {end}", meetings(&[Candidate::from(wire)]))
                });
                let told = told.collect::<Vec<_>>().join(", ");
                mail.extend(news);
                told
            });
            table.row(format!("  tells rank {partner}"), tells);
        }
        for (decisions, mail) in all_ranks.iter_mut().zip(&mail) {
            decisions.told = decisions.taken.len();
            hear(decisions, mail);
        }
    }
    insta::assert_snapshot!(table);
}

// The tests themselves, one file for each part of the lab.
include!("lab8/master_workers.rs");
include!("lab8/strips.rs");
include!("lab8/decisions.rs");
