//! Questions about sums of blocks and about the counting sort.

use common::soft::{CUTOFF, Particle, Scene, Simulation};
use device::Gpu;
use device_discs::soft::{Double, Grid, Options, SoftDiscs};
use lab9::Lab9;
use oracle::{Ask, Random, scenes};

use super::adapter::{adapter, adapter_with_doubles};
use super::launched::sums_before;

pub(super) fn integers(all: &[u32]) -> Vec<f64> {
    all.iter().copied().map(f64::from).collect()
}

/// Asks for the prefix sums of few and many numbers, by workgroups of few and many threads.
pub(crate) fn scans(random: &mut Random, ask: &mut impl Ask) {
    let Some(gpu) = adapter("9.6") else { return };
    for threads in [1, 2, 8, 32, 64, 96, 256] {
        let drawn = 1 + random.below(70_000);
        for n in [1, 2, 31, 32, 33, 63, 64, 65, 255, 256, 257, 1000, 4096, 4097, 70_000, drawn] {
            let numbers: Vec<u32> = (0..n).map(|_| random.below(10) as u32).collect();
            let list = if n <= 33 { format!(" {numbers:?}") } else { String::new() };
            let question = format!(
                "{n} numbers{list}, workgroups of {threads}: for each number, the sum of the numbers before it"
            );
            let found = || integers(&sums_before(gpu, &numbers, threads));
            ask.exact(&question, found, || before_each(&numbers));
        }
    }
}

fn before_each(numbers: &[u32]) -> Vec<f64> {
    let mut sum = 0.0;
    let before = |&number: &u32| {
        sum += f64::from(number);
        sum - f64::from(number)
    };
    numbers.iter().map(before).collect()
}

/// Returns an engine of soft discs in double precision, with workgroups of `threads`.
pub(super) fn engine(gpu: &'static Gpu, threads: u32) -> SoftDiscs<Lab9, Double> {
    let options = Options { threads, bin: 1.0, in_flight: 1, statistics: false };
    SoftDiscs::new(gpu, options, None).unwrap_or_else(|error| panic!("{error}"))
}

/// Asks about bins that fit into one workgroup of the prefix sum. Longer sums are a different task.
pub(crate) fn bins(random: &mut Random, ask: &mut impl Ask) {
    let Some(gpu) = adapter_with_doubles("9.7") else { return };
    let n = 120 + random.below(60);
    let drawn = scenes::spread(random, n, 10.3 * CUTOFF, 1.0);
    let scenes = [("dense", scenes::dense()), ("crowd", scenes::crowd(3)), ("drawn", drawn)];
    bins_of_each(gpu, 256, &scenes, ask);
}

/// Asks about more bins than a workgroup has invocations.
pub(crate) fn many_bins(_: &mut Random, ask: &mut impl Ask) {
    let Some(gpu) = adapter_with_doubles("9.7") else { return };
    for threads in [1, 7, 64] {
        let dense = ("dense", scenes::dense());
        let scenes = [dense, ("crowd", scenes::crowd(3)), ("official", scenes::official())];
        bins_of_each(gpu, threads, &scenes, ask);
    }
}

/// Asks one engine for the bins of each scene.
fn bins_of_each(
    gpu: &'static Gpu,
    threads: u32,
    scenes: &[(&'static str, Scene)],
    ask: &mut impl Ask,
) {
    let mut engine = engine(gpu, threads);
    for (name, scene) in scenes {
        let name = format!("scene '{name}', workgroups of {threads}");
        bins_of(&mut engine, &name, scene, ask);
    }
}

/// Asks for the order of particles before each of six steps.
fn bins_of(engine: &mut SoftDiscs<Lab9, Double>, name: &str, scene: &Scene, ask: &mut impl Ask) {
    for step in 0..6 {
        let question = format!(
            "{name}, after {step} steps: (1) x and y of each particle, (2) the particles in the order of bins and \
             ids, (3) the index at which each bin begins"
        );
        let found = || {
            if step == 0 {
                engine.load(scene);
            } else {
                engine.step();
            }
            let mut particles = scene.particles().to_vec();
            engine.read(0, &mut particles);
            let positions = particles.iter().flat_map(|p| [p.x, p.y]).collect();
            let sorted = engine.sort();
            [positions, integers(&sorted.ids), integers(&sorted.starts)].concat()
        };
        ask.judge(&question, found, |found| are_sorted(found, scene));
    }
}

/// Checks that particles are in order by bin and by id, and that the starts of the bins are
/// correct.
fn are_sorted(found: &[f64], scene: &Scene) -> Result<(), String> {
    let n = scene.len();
    let grid = Grid::new(scene.size(), n, 1.0);
    if found.len() != 3 * n + grid.bins() as usize + 1 {
        return Err("the answer has a wrong number of particles or bins".into());
    }
    let (positions, found) = found.split_at(2 * n);
    let (places, _) = positions.as_chunks();
    let mut right: Vec<[u32; 2]> = Vec::new();
    for (id, &[x, y]) in (0..).zip(places) {
        right.push([grid.column(y) * grid.columns + grid.column(x), id]);
    }
    right.sort_unstable();
    let (ids, starts) = found.split_at(n);
    for (place, &[bin, id]) in right.iter().enumerate() {
        if ids[place] != f64::from(id) {
            return Err(format!(
                "place {place} belongs to particle {id}, which is in bin {bin}, but particle {} is at this place",
                ids[place]
            ));
        }
    }
    for (bin, start) in (0..).zip(starts) {
        let begins = right.partition_point(|[other, _]| *other < bin);
        if *start != begins as f64 {
            return Err(format!("bin {bin} begins at {begins}, not at {start}"));
        }
    }
    Ok(())
}

/// Returns a particle at rest at (x, y) cutoffs.
pub(super) fn at(x: f64, y: f64) -> Particle {
    Particle { x: x * CUTOFF, y: y * CUTOFF, ..Particle::default() }
}
