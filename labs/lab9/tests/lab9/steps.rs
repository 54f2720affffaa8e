//! Questions about whole runs of soft discs.

use common::soft::{CUTOFF, Scene, Simulation};
use device_discs::soft::Grid;
use lab9::VARIANTS;
use oracle::{Ask, Random, Runs, scenes};

use super::adapter::{adapter, adapter_with_doubles};

/// Returns runs of `soft-f64` in workgroups of 256. `None` if the machine has no double precision.
fn double() -> Option<Runs> {
    let runs = || Runs::new("9.7", VARIANTS, "soft-f64").set("workgroup", 256.0);
    adapter_with_doubles("9.7").map(|_| runs())
}

/// Asks for steps with bins that fit into one workgroup of the prefix sum.
pub(crate) fn double_steps(random: &mut Random, ask: &mut impl Ask) {
    let Some(runs) = double() else { return };
    runs.resynchronised(ask, &scenes::dense(), 20);
    runs.resynchronised_on_each(ask, (1..=20).map(scenes::crowd).collect(), 2);
    runs.clone().set("bin", 2.0).resynchronised(ask, &scenes::dense(), 5);
    runs.clone().set("bin", 3.0).resynchronised_on_each(ask, scenes::edges(), 1);
    let many = 120 + random.below(60);
    runs.resynchronised(ask, &scenes::spread(random, many, 10.3 * CUTOFF, 1.0), 10);
    let crowd = 150 + random.below(100);
    runs.resynchronised(ask, &scenes::anywhere(random, crowd, 2.55 * CUTOFF, 1.0), 1);
}

pub(crate) fn double_steps_of_many(_: &mut Random, ask: &mut impl Ask) {
    let Some(runs) = double() else { return };
    for threads in [5.0, 64.0] {
        let runs = runs.clone().set("workgroup", threads);
        runs.resynchronised(ask, &scenes::dense(), 20);
        runs.resynchronised_on_each(ask, scenes::edges(), 1);
        runs.resynchronised_on_each(ask, (1..=20).map(scenes::crowd).collect(), 2);
    }
    runs.resynchronised_on_each(ask, scenes::fast().to_vec(), 3);
    runs.forces(ask);
    runs.keeps_everyone(ask, &scenes::dense(), 100);
}

pub(crate) fn double_repeats(_: &mut Random, ask: &mut impl Ask) {
    let Some(runs) = double() else { return };
    runs.same_bits_on_threads(ask, &scenes::dense(), 50, &[1]);
    runs.free_run(ask);
}

pub(crate) fn statistics(_: &mut Random, ask: &mut impl Ask) {
    let Some(runs) = double() else { return };
    runs.statistics_of_each_step(ask, &scenes::dense(), 5);
    pair_tests(&runs.statistics(), &scenes::dense(), ask);
}

/// Asks for the pair tests of a step. A particle may be tested with itself or not.
fn pair_tests(runs: &Runs, scene: &Scene, ask: &mut impl Ask) {
    let of_run = scene.clone();
    let found = move |engine: &mut dyn Simulation| {
        engine.load(&of_run);
        engine.step();
        let statistics = engine.statistics().expect("the engine was built with statistics");
        vec![statistics.pair_tests as f64]
    };
    let question = format!("{}, {} particles: pair tests of a step", runs.name(), scene.len());
    ask.judge(
        &question,
        || runs.run(found),
        |found| {
            let all = tests_of_nine_bins(scene);
            let others = all - scene.len();
            match found {
                [tests] if [all as f64, others as f64].contains(tests) => Ok(()),
                _ => Err(format!(
                    "     found: {found:?}\n  expected: {all}, or {others} without the tests of particles with \
                     themselves. Each particle is tested with all particles of nine bins, also with distant particles"
                )),
            }
        },
    );
}

/// Returns the number of ordered pairs of particles in the same bin or in adjacent bins, each
/// particle with itself included.
fn tests_of_nine_bins(scene: &Scene) -> usize {
    let grid = Grid::new(scene.size(), scene.len(), 1.0);
    let index = |at: f64| ((at / grid.side) as u32).min(grid.columns - 1);
    let bins: Vec<_> = scene.particles().iter().map(|p| [index(p.x), index(p.y)]).collect();
    let are_near = |a: &[u32; 2], b: &[u32; 2]| (0..2).all(|k| a[k].abs_diff(b[k]) <= 1);
    bins.iter().map(|a| bins.iter().filter(|b| are_near(a, b)).count()).sum()
}

/// Returns runs of `soft-f32`. `None` if there is no device.
pub(super) fn single() -> Option<Runs> {
    adapter("9.8").map(|_| Runs::new("9.8", VARIANTS, "soft-f32"))
}

/// Returns 2,000 particles in a box of 100 × 100 bins. In single precision, positions relative to
/// the corner of the box have a hundred times the error of positions relative to the bin.
fn wide() -> Scene {
    scenes::lattice_with_jitter(2000, 100.05 * CUTOFF, 1.0, 9)
}

/// Asks for the first step, with bins of three cutoffs.
pub(crate) fn single_steps(random: &mut Random, ask: &mut impl Ask) {
    let Some(runs) = single() else { return };
    let runs = runs.set("workgroup", 256.0).set("bin", 3.0);
    let runs = runs.in_single(|scene| Grid::new(scene.size(), scene.len(), 3.0).side);
    runs.resynchronised_on_each(ask, scenes::edges(), 1);
    let many = 250 + random.below(100);
    runs.resynchronised(ask, &scenes::spread(random, many, 15.3 * CUTOFF, 0.5), 1);
}

/// Asks for one step of many particles. The rounding error of a particle is derived from its
/// neighbours: see tests/oracle/src/single.rs, and the book, chapter 9, *What single precision
/// owes*.
pub(crate) fn single_steps_of_many(_: &mut Random, ask: &mut impl Ask) {
    let Some(runs) = single() else { return };
    let runs = runs.in_single(|scene| Grid::new(scene.size(), scene.len(), 1.0).side);
    runs.resynchronised_on_each(ask, scenes::edges(), 1);
    runs.resynchronised(ask, &scenes::dense(), 20);
    runs.resynchronised(ask, &wide(), 3);
    runs.resynchronised_on_each(ask, (1..=20).map(scenes::crowd).collect(), 3);
    let close = vec![scenes::close_pairs(), scenes::cloud(200, 4.0, 1)];
    runs.resynchronised_on_each(ask, close, 2);
    runs.resynchronised_on_each(ask, scenes::fast().to_vec(), 3);
}

pub(crate) fn single_repeats(_: &mut Random, ask: &mut impl Ask) {
    let Some(runs) = single() else { return };
    runs.keeps_everyone(ask, &scenes::dense(), 200);
    runs.same_bits_on_threads(ask, &scenes::dense(), 50, &[1]);
}
