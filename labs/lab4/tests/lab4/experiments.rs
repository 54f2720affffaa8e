//! Experiments that print tables for the book. They run only if they are named.

use std::collections::HashMap;
use std::thread;
use std::time::Instant;

use common::soft::{CUTOFF, Scene, Simulation};
use lab4::VARIANTS;
use oracle::{nanoseconds_each, scenes};

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

/// A lab's program, with counters.
type Program = (&'static str, &'static common::Variant<dyn Simulation>);

/// Returns the milliseconds of a step, and the counters for one step.
fn measure(program: Program, threads: usize, scene: &Scene) -> (f64, HashMap<&'static str, f64>) {
    const STEPS: u64 = 200;
    let config = program.1.config().with_threads(threads);
    let mut engine = (program.1.build)(&config).expect("the engine can be built here");
    engine.load(scene);
    // The first steps allocate the memory of the lists.
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
    let official = Scene::official(20_000, 1).expect("the official scene is valid");
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
        // All programs take turns, round after round; the shortest time counts.
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
