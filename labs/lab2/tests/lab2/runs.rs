//! Questions about whole runs of the four variants.

use common::soft::{CUTOFF, NoStatistics, Particle, Scene, Simulation};
use lab2::{BIN_SIZE, Gather, Grid, VARIANTS, VecBins, forward, take_leavers};
use oracle::scenes::{anywhere, spread};
use oracle::{Ask, Random, Runs, drawn, scenes};

use super::particles::numbered;

/// Returns a grid of one bin.
fn one_bin() -> Grid {
    Grid::with_bins_along(1.0, 1)
}

/// Returns runs of `rebuild`. An unsolved starter stops at the `todo!` of task 2.4.
pub(crate) fn rebuild() -> Runs {
    VecBins::new(one_bin()).acceleration(&Particle::default(), &mut NoStatistics);
    Runs::new("2.4", VARIANTS, "rebuild")
}

/// Returns runs of `incremental`. An unsolved starter stops at the `todo!` of task 2.5.
pub(crate) fn incremental() -> Runs {
    take_leavers(&one_bin(), 0, &mut Vec::new(), &mut Vec::new());
    Runs::new("2.5", VARIANTS, "incremental")
}

/// Returns runs of `linked-list`. An unsolved starter stops at the `todo!` of task 2.7.
pub(crate) fn linked_list() -> Runs {
    forward(&one_bin(), 0, 0, &mut [0; 4]);
    Runs::new("2.7", VARIANTS, "linked-list")
}

/// Returns runs of `sorted`. An unsolved starter stops at the `todo!` of task 2.9.
pub(crate) fn sorted() -> Runs {
    Gather::default().acceleration(&Particle::default(), [], &mut NoStatistics);
    Runs::new("2.9", VARIANTS, "sorted")
}

pub(crate) fn edges(ask: &mut impl Ask, runs: &Runs) {
    for bin_size in [1.0, 2.0] {
        runs.clone().set(BIN_SIZE, bin_size).resynchronised_on_each(ask, scenes::edges(), 1);
    }
}

pub(crate) fn steps(ask: &mut impl Ask, runs: &Runs) {
    for bin_size in [1.0, 1.3, 2.0, 3.0] {
        let runs = runs.clone().set(BIN_SIZE, bin_size);
        runs.resynchronised(ask, &scenes::dense(), 20);
        runs.resynchronised(ask, &scenes::close_pairs(), 5);
        for scene in scenes::fast() {
            runs.resynchronised(ask, &scene, 20);
        }
    }
    runs.forces(ask);
}

pub(crate) fn crowds(ask: &mut impl Ask, runs: &Runs) {
    runs.clone().set(BIN_SIZE, 1.0).crowds(ask);
}

pub(crate) fn sparse(ask: &mut impl Ask, runs: &Runs) {
    runs.resynchronised_on_each(ask, loners(), 3);
    runs.resynchronised(ask, &wide(), 3);
}

/// Returns boxes of one particle, in the middle, on walls and in corners, large and small.
fn loners() -> Vec<Scene> {
    let mut scenes = Vec::new();
    for size in [1e-300, 0.3 * CUTOFF, CUTOFF, 7.7 * CUTOFF, 1e300] {
        for (x, y) in [(0.5, 0.5), (1.0, 1.0), (0.0, 1.0), (1.0, 0.3)] {
            let scene = Scene::new(size, vec![numbered(0, x * size, y * size)]);
            scenes.push(scene.expect("the scene is valid"));
        }
    }
    scenes
}

/// Returns 500 pairs within the cutoff, each pair alone in a box a million cutoffs wide.
fn wide() -> Scene {
    let size = 1e6 * CUTOFF;
    let mut random = Random::new(21);
    let mut particles = Vec::new();
    for _ in 0..500 {
        let x = random.between(0.0, 0.99 * size);
        let y = random.between(0.0, 0.99 * size);
        particles.extend([numbered(0, x, y), numbered(0, x + 0.6 * CUTOFF, y + 0.5 * CUTOFF)]);
    }
    // The test stops here, before it requests memory that the machine does not have.
    let bins = Grid::new(size, CUTOFF, particles.len()).bins();
    assert!(
        bins <= 8000,
        "{bins} bins for 1000 particles in a box a million cutoffs wide: there must be at most 8 × 1000 bins"
    );
    Scene::new(size, particles).expect("the scene is valid")
}

pub(crate) fn official_run(ask: &mut impl Ask, runs: &Runs) {
    runs.resynchronised(ask, &scenes::official(), 1000);
    runs.official_bytes(ask);
}

pub(crate) fn statistics(ask: &mut impl Ask, runs: &Runs) {
    runs.statistics_of_each_step(ask, &scenes::at_the_cutoff(), 1);
    runs.statistics_of_each_step(ask, &scenes::dense(), 10);
    runs.long_statistics(ask);
}

/// Asks for the number of particles, so that a program that doubles them in each step fails before
/// memory is full.
pub(crate) fn memory(ask: &mut impl Ask, runs: &Runs) {
    runs.resynchronised(ask, &scenes::dense(), 8);
    runs.keeps_its_memory(ask);
}

/// Asks for the forces first, because doubled particles would fill the memory.
pub(crate) fn keeps_everyone(ask: &mut impl Ask, runs: &Runs) {
    for bin_size in [1.0, 2.0] {
        let runs = runs.clone().set(BIN_SIZE, bin_size);
        runs.resynchronised(ask, &scenes::dense_with_seed(2), 1000);
        runs.keeps_everyone(ask, &scenes::dense(), 1000);
    }
}

/// Asks whether the number of pair tests per particle is independent of the number of particles.
pub(crate) fn pair_tests(ask: &mut impl Ask, runs: &Runs) {
    for n in [1000, 8000, 64_000] {
        let found = move |engine: &mut dyn Simulation| {
            engine.load_official(n, 1).expect("the official scene is valid");
            engine.step();
            let seen = engine.statistics().expect("the engine was built with statistics");
            vec![seen.pair_tests as f64 / n as f64]
        };
        let runs = runs.clone().set(BIN_SIZE, 1.0).statistics();
        let question = format!(
            "{}, a step of the official scene with {n} particles: number of pair tests (`tested`) divided by the \
             number of particles. On average, a particle has about 0.1 pairs within the cutoff, and bins of one \
             cutoff need fewer than 4 tests",
            runs.name()
        );
        ask.judge(
            &question,
            || runs.run(found),
            |found| match found {
                [tests] if (0.1..=4.0).contains(tests) => Ok(()),
                _ => Err(format!("     found: {found:.1?}\n  expected: from 0.1 to 4")),
            },
        );
    }
}

/// Asks for steps with bins of two and three cutoffs. A grid with slightly narrower bins still
/// finds every pair.
pub(crate) fn drawn_boxes(random: &mut Random, ask: &mut impl Ask) {
    for bin_size in [2.0, 3.0] {
        let runs = linked_list().set(BIN_SIZE, bin_size);
        let n = 100 + random.below(120);
        let scene = spread(random, n, 10.3 * CUTOFF, 1.0);
        runs.resynchronised(ask, &scene, 8 + random.below(15));
        runs.resynchronised(ask, &drawn::heap(random), 1 + random.below(3));
        let n = 100 + random.below(120);
        let scene = anywhere(random, n, 6.9 * CUTOFF, 1.0);
        runs.resynchronised(ask, &scene, 1 + random.below(3));
        runs.resynchronised(ask, &drawn::pairs_over_edges(random), 1);
    }
    let n = 200 + random.below(200);
    let scene = spread(random, n, 15.3 * CUTOFF, 1.0);
    linked_list().set(BIN_SIZE, 2.0).statistics_of_each_step(ask, &scene, 1);
}

pub(crate) fn bits(_: &mut Random, ask: &mut impl Ask) {
    for bin_size in [1.0, 1.7, 3.0] {
        let runs = sorted().set(BIN_SIZE, bin_size);
        for seed in 1..=5 {
            runs.bits_of_all_pairs(ask, &scenes::dense_with_seed(seed), 100);
            runs.bits_of_all_pairs(ask, &scenes::crowd(seed), 10);
        }
        runs.bits_of_all_pairs(ask, &scenes::close_pairs(), 20);
    }
}

pub(crate) fn bits_of_official_scenes(_: &mut Random, ask: &mut impl Ask) {
    for (n, seed) in [(1, 1), (2, 9), (300, 7), (777, 5), (1500, 2)] {
        let scene = Scene::official(n, seed).expect("the official scene is valid");
        sorted().bits_of_all_pairs(ask, &scene, 200);
    }
}
