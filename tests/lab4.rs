use std::collections::HashMap;
use std::sync::Arc;
use std::thread;
use std::time::Instant;

use common::soft::{CUTOFF, NoStatistics, Scene, Simulation};
use common_threads::{LockOrder, Watch};
use crossbeam::channel::unbounded;
use crossbeam::queue::SegQueue;
use lab4::{
    Change, Cut, Meter, VARIANTS, apply_all, apply_own, change_bin, claim, move_own, pairs_across,
    rebuild, receive, take, take_own,
};
use oracle::scenes::on_edges;
use oracle::yardstick::nanoseconds_each;
use oracle::{Grader, Random, acceleration_of_pair, apart, ask, right, scenes, within};
use solution2::{Grid, SortedBins};
use watched::test;

use self::locked::filled;

#[path = "lab4/locked.rs"]
mod locked;
#[path = "lab4/questions.rs"]
mod questions;

/// A variant that gives the bits of all pairs, on any number of threads.
fn check_bits(task: &'static str, variant: &str) {
    Grader::new(task, VARIANTS, variant).seconds(60).bits_on_any_threads();
}

#[test]
fn task_4_1_every_bin_lies_in_a_region() {
    within("4.1", 30, || questions::regions(&mut Random::new(41), &mut right));
}

#[test]
fn task_4_1_lock_r_guards_region_r() {
    within("4.1", 10, || locked::numbers(&mut Random::new(41), &mut right));
}

#[test]
fn task_4_2_all_waits_are_measured_and_a_free_lock_costs_no_clock() {
    within("4.2", 20, || locked::meters(&mut Random::new(42), &mut right));
}

/// The first particle of bin `from` goes to bin `to`.
fn first_of(from: usize, to: usize) -> Change {
    Change { particle: 30 * from as u32, from, to }
}

#[test]
fn task_4_3_particles_change_their_bins() {
    within("4.3", 10, || locked::one_by_one(&mut Random::new(43), &mut right));
}

#[test]
fn task_4_3_table_of_locks() {
    let mut table = String::from("bins in a region  change    locks taken  held at once\n");
    for each in [1, 3, 12] {
        for (from, to) in [(2, 10), (10, 2), (4, 5)] {
            let (locks, most) = within("4.3", 5, move || {
                let mut regions = filled(12, each);
                let order = Arc::new(LockOrder::default());
                let watch: Arc<dyn Watch> = order.clone();
                regions.watch(&watch);
                let mut meter = Meter::default();
                change_bin(&regions, &mut meter, first_of(from, to));
                (meter.locks, order.most_held())
            });
            let change = format!("{from} -> {to}");
            table += &format!("{each:>16}  {change:<8}  {locks:>11}  {most:>12}\n");
        }
    }
    insta::assert_snapshot!(table);
}

#[test]
fn task_4_3_many_threads_change_bins() {
    within("4.3", 20, || locked::many_threads(&mut Random::new(43), &mut right));
}

#[test]
fn task_4_3_another_thread_between_two_requests() {
    within("4.3", 5, || locked::another_between(&mut Random::new(430), &mut right));
}

#[test]
fn task_4_3_threads_in_other_regions_go_on() {
    within("4.3", 10, || locked::elsewhere(&mut right));
}

#[test]
fn task_4_4_each_moves_and_tells_of_its_bin() {
    within("4.4", 30, || questions::moves(&mut Random::new(44), &mut right));
}

/// On a starter this stops at task 4.3, or after it at 4.4.
fn reach_4_4() {
    move_own(&Grid::with_bins_along(1.0, 1), &mut [], &[], |_| ());
}

#[test]
fn task_4_4_under_one_lock() {
    reach_4_4();
    check_bits("4.4", "global-lock");
}

#[test]
fn task_4_4_under_many_locks() {
    reach_4_4();
    check_bits("4.4", "region-locks");
}

#[test]
fn task_4_4_under_a_lock_for_each_bin() {
    reach_4_4();
    check_bits("4.4", "bin-locks");
}

#[test]
fn task_4_5_all_bins_are_filled_again() {
    within("4.5", 30, || questions::rebuilds(&mut Random::new(45), &mut right));
}

#[test]
fn task_4_5_one_thread_rebuilds() {
    rebuild(&mut filled(1, 1), &Grid::with_bins_along(1.0, 1), &[]);
    check_bits("4.5", "serial-rebuild");
    let fresh = Grader::new("4.5", VARIANTS, "serial-rebuild").threads(2).set("fresh", 1.0);
    fresh.bits_of_all_pairs(&scenes::all_leave(), 20);
}

#[test]
fn task_4_6_one_thread_empties_all_buffers() {
    within("4.6", 30, || questions::by_one(&mut Random::new(46), &mut right));
}

#[test]
fn task_4_6_every_thread_its_own_bins() {
    within("4.6", 30, || questions::by_owners(&mut Random::new(47), &mut right));
}

#[test]
fn task_4_6_buffers_emptied_by_one() {
    apply_all(&mut filled(1, 1), std::iter::empty());
    check_bits("4.6", "buffers-by-one");
}

#[test]
fn task_4_6_buffers_emptied_by_all() {
    apply_own(Cut { bins_each: 1 }, 0, &mut [], std::iter::empty());
    check_bits("4.6", "buffers-by-all");
}

#[test]
fn task_4_7_owners_empty_their_queues() {
    within("4.7", 30, || questions::queues(&mut Random::new(48), &mut right));
}

#[test]
fn task_4_7_queues() {
    take(Cut { bins_each: 1 }, 0, &mut [], &SegQueue::new());
    check_bits("4.7", "queues");
}

#[test]
fn task_4_8_changes_are_sent_and_received() {
    within("4.8", 30, || questions::channels(&mut Random::new(49), &mut right));
}

#[test]
fn task_4_8_channels() {
    within("4.8", 10, || {
        let (_sender, receiver) = unbounded();
        receive(Cut { bins_each: 1 }, 0, &mut [], &receiver);
    });
    check_bits("4.8", "channels");
}

#[test]
fn task_4_9_owners_claim_each_particle_once() {
    within("4.9", 30, || questions::claims(&mut Random::new(50), &mut right));
}

#[test]
fn task_4_9_owners_of_shared_bins() {
    claim(Cut { bins_each: 1 }, 0, &mut [], &Grid::with_bins_along(1.0, 1), &[]);
    check_bits("4.9", "owners");
}

#[test]
fn task_4_9_owners_take_each_particle_once() {
    take_own(&mut SortedBins::new(Grid::with_bins_along(1.0, 1), 0..1), std::iter::empty());
    within("4.9", 30, || questions::owners(&mut Random::new(51), &mut right));
}

#[test]
fn task_4_9_owner_computes() {
    take_own(&mut SortedBins::new(Grid::with_bins_along(1.0, 1), 0..1), std::iter::empty());
    check_bits("4.9", "owner-computes");
}

#[test]
fn task_4_9_memory_does_not_grow() {
    take_own(&mut SortedBins::new(Grid::with_bins_along(1.0, 1), 0..1), std::iter::empty());
    let grader = Grader::new("4.9", VARIANTS, "owner-computes").threads(3);
    apart(|| grader.keeps_its_memory());
}

#[test]
fn task_4_10_every_pair_of_a_strip() {
    within("4.10", 30, || questions::within_rows(&mut Random::new(52), &mut right));
}

#[test]
fn task_4_11_the_pair_across_a_cut_counts_once() {
    within("4.11", 30, || questions::across(&mut Random::new(53), &mut right));
}

/// On a starter this stops at task 4.11.
fn reach_4_11() {
    let grid = Grid::with_bins_along(1.0, 2);
    let [lower, upper] = [0..1, 1..2].map(|rows| SortedBins::new(grid, rows));
    pairs_across(&lower, &upper, &mut [], &mut [], &mut NoStatistics);
}

/// A variant with two-way forces, on any number of threads.
fn check_two_way(variant: &str) {
    for threads in [1, 2, 3, 4, 8, 15] {
        let grader = Grader::new("4.11", VARIANTS, variant).threads(threads).seconds(30);
        for bin_size in [1.0, 2.0, 3.0] {
            let grader = grader.clone().set("bin-size", bin_size);
            grader.resynchronised(&scenes::dense(), 20);
            grader.resynchronised_on_each(scenes::edges(), 1);
            grader.resynchronised_on_each((1..=20).map(scenes::crowd).collect(), 2);
        }
        grader.forces();
        grader.statistics_of_each_step(&scenes::dense(), 5);
        grader.same_bits_on_threads(&scenes::dense_with_seed(7), 20, &[threads]);
    }
    Grader::new("4.11", VARIANTS, variant).threads(2).free_run();
    let grader = Grader::new("4.11", VARIANTS, variant).threads(3);
    grader.keeps_everyone(&scenes::dense_with_seed(8), 1000);
}

#[test]
fn task_4_11_owners_with_two_way_forces() {
    reach_4_11();
    check_two_way("owner-two-way");
}

#[test]
fn task_4_11_owners_with_linked_lists() {
    reach_4_11();
    check_two_way("owner-lists");
    let fresh = Grader::new("4.11", VARIANTS, "owner-lists").threads(2).set("fresh", 1.0);
    fresh.resynchronised(&scenes::dense(), 20);
}

/// Takes a lock `count` times on each of `threads` threads, by `take`.
fn all_take(threads: usize, count: usize, take: impl Fn() + Sync) {
    thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(|| (0..count).for_each(|_| take()));
        }
    });
}

#[test]
#[ignore = "an experiment: prints a table"]
fn experiment_two_mutexes() {
    const COUNT: usize = 2_000_000;
    println!("mutex        free [ns]  wanted by 2 threads [ns]  bytes  after a panic");
    let (own, theirs) = (std::sync::Mutex::new(0_u64), parking_lot::Mutex::new(0_u64));
    let times = |take: &(dyn Fn() + Sync)| {
        [1, 2].map(|threads| nanoseconds_each(threads * COUNT, || all_take(threads, COUNT, take)))
    };
    let add_own = || *own.lock().expect("no thread has panicked") += 1;
    let add_theirs = || *theirs.lock() += 1;
    let [free, wanted] = times(&add_own);
    let (size, after) = (size_of::<std::sync::Mutex<()>>(), "poisoned: lock() is an error");
    println!("std          {free:>9.1}  {wanted:>24.1}  {size:>5}  {after}");
    let [free, wanted] = times(&add_theirs);
    let (size, after) = (size_of::<parking_lot::Mutex<()>>(), "free again");
    println!("parking_lot  {free:>9.1}  {wanted:>24.1}  {size:>5}  {after}");
}

/// A program of one of the labs, with counters.
type Program = (&'static str, &'static common::Variant<dyn Simulation>);

/// Milliseconds of a step, and the counters for one step.
fn measure(program: Program, threads: usize, scene: &Scene) -> (f64, HashMap<&'static str, f64>) {
    const STEPS: u64 = 200;
    let config = program.1.config().with_threads(threads);
    let mut engine = (program.1.build)(&config).expect("it can be built here");
    engine.load(scene);
    // Lists get their memory.
    engine.run(STEPS / 4);
    let before: HashMap<_, _> = engine.counters().into_iter().collect();
    let start = Instant::now();
    engine.run(STEPS);
    let time = 1e3 * start.elapsed().as_secs_f64() / STEPS as f64;
    let counters = engine.counters().into_iter();
    let each = |(name, value)| (name, (value - before.get(name).unwrap_or(&0.0)) / STEPS as f64);
    (time, counters.map(each).collect())
}

#[test]
#[ignore = "an experiment: prints two tables in some minutes"]
fn experiment_ways() {
    const ROUNDS: usize = 3;
    let official = Scene::official(20_000, 1).expect("the official scene is sound");
    let fast = scenes::lattice_with_jitter(5_000, 59.5 * CUTOFF, 40.0, 5);
    let sorted: Program = ("lab 2 sorted", &solution2::VARIANTS[0]);
    for (name, scene) in
        [("official scene, n = 20,000", official), ("dense and fast, n = 5000", fast)]
    {
        println!("\n{name}, milliseconds a step, all threads together but for the first\n");
        println!(
            "| program | threads | step | own eff. | against `sorted` | locks | waited for | lock wait | moving, rebinning | waiting at ends |"
        );
        println!("|---|---|---|---|---|---|---|---|---|---|");
        let mut jobs = vec![(sorted, 1)];
        for variant in VARIANTS {
            jobs.extend([1, 2, 4, 8].map(|threads| ((variant.name, variant), threads)));
        }
        // All take turns, round after round; the least counts.
        let mut best: Vec<Option<(f64, HashMap<_, f64>)>> = vec![None; jobs.len()];
        for _ in 0..ROUNDS {
            for ((program, threads), best) in jobs.iter().zip(&mut best) {
                let found = measure(*program, *threads, &scene);
                if best.as_ref().is_none_or(|(time, _)| found.0 < *time) {
                    *best = Some(found);
                }
            }
        }
        let best: Vec<_> = best.into_iter().flatten().collect();
        let mut alone = best[0].0;
        for (((name, _), threads), (time, counters)) in jobs.iter().zip(&best) {
            if *threads == 1 {
                alone = *time;
            }
            let efficiency = |serial: f64| serial / (time * *threads as f64);
            let count = |name| counters.get(name).map_or("".into(), |value| format!("{value:.0}"));
            let ms = |names: &[&str]| {
                let sum: Option<f64> = names.iter().map(|name| counters.get(name)).sum();
                sum.map_or("".into(), |value| format!("{:.2}", 1e3 * value))
            };
            println!(
                "| `{name}` | {threads} | {time:.2} | {:.2} | {:.2} | {} | {} | {} | {} | {} |",
                efficiency(alone),
                efficiency(best[0].0),
                count("locks taken"),
                count("locks waited for"),
                ms(&["lock wait, all threads [s]"]),
                ms(&["moving, all threads [s]", "rebinning, all threads [s]"]),
                ms(&["waiting for other threads, all threads [s]"]),
            );
        }
    }
}
