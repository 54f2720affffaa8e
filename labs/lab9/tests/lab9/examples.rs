//! The worked examples: cases that can be checked by hand, and the lab's results.

use common::hard::{Disc, Scene};
use common::soft;
use device::{Gpu, Launcher};
use device_discs::hard::{HardKernels, WALL};
use lab9::Lab9;
use oracle::{Ask, Columns, Random, Table, ascending, spaced};
use solution7::{Candidate, Hit, Square};
use wgpu::Limits;

use super::adapter::{adapter, adapter_with_doubles};
use super::choices::chooser;
use super::filters::all_pairs;
use super::launched::{ALL_PAIRS, RECTANGLE, Search, line, sums_before};
use super::launches::suffices;
use super::sorts::{at, engine};
use super::steps::single;

pub(crate) fn launch_table(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let limits = Limits {
            max_compute_invocations_per_workgroup: 256,
            max_compute_workgroup_size_x: 256,
            max_compute_workgroups_per_dimension: 4,
            ..Limits::default()
        };
        let mut table = Table::new(["workgroups", "invocations in each", "launch"]);
        for (blocks, threads) in [(1, 64), (4, 64), (5, 64), (16, 256), (17, 64), (4, 257), (0, 64)]
        {
            let launch = match Lab9::launch(blocks, threads, &limits) {
                Ok(launch) if !suffices(launch, blocks, 4) => format!("{launch:?} does not fit"),
                Ok(launch) if launch.groups[1] == 1 => "1 row".into(),
                Ok(launch) => format!("{} rows", launch.groups[1]),
                Err(error) => error.to_string(),
            };
            table.row([&blocks, &threads, &launch]);
        }
        table.to_string()
    });
}

/// Returns four discs of radius 1 in a square of side 20.
fn four_discs() -> Scene {
    let discs = vec![
        Disc::new(4.0, 4.0, 3.0, 0.0),
        Disc::new(8.0, 4.0, 0.0, 0.0),
        Disc::new(4.0, 9.0, 0.0, -1.0),
        Disc::new(8.0, 7.0, 0.0, -2.0),
    ];
    Scene::new(20.0, 1.0, discs).expect("the scene is valid")
}

/// Shows the positions and velocities of discs.
fn table_of(discs: &[Disc]) -> Table {
    let mut table = Table::new(["disc", "x", "y", "vx", "vy"]);
    for (i, disc) in discs.iter().enumerate() {
        table.row([&i, &disc.x, &disc.y, &disc.vx, &disc.vy]);
    }
    table
}

pub(crate) fn pairs_passed_on(_: &mut Random, ask: &mut impl Ask) {
    let Some(gpu) = adapter("9.2") else { return };
    ask.example(|| {
        let scene = four_discs();
        let found = Search::of(&scene, ALL_PAIRS).run::<f32>(gpu);
        let mut table = Table::new(["pair", "times passed on", ""]);
        let words = [
            "one flies towards the other",
            "they pass each other",
            "one flies into the way of the other",
            "they approach, and are too far apart",
            "one flies towards the other",
            "they move apart",
        ];
        for (pair, words) in all_pairs(4).zip(words) {
            let times = found.list.iter().filter(|other| **other == pair).count();
            table.row([&spaced(pair), &times, &words]);
        }
        format!("{}\n{table}", table_of(scene.discs()))
    });
}

pub(crate) fn confirmed_list(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let discs = vec![
            Disc::new(4.0, 4.0, 4.0, 0.0),
            Disc::new(8.0, 4.0, 0.0, 0.0),
            Disc::new(18.0, 9.0, 2.0, 0.0),
            Disc::new(8.0, 18.5, 0.0, 0.5),
        ];
        let square = Square { side: 20.0, radius: 1.0 };
        let passed_on = [[0, 1], [1, 2], [2, WALL], [3, WALL], [1, WALL]];
        let mut candidates = Vec::new();
        Lab9::confirm(&discs, square, &passed_on, &mut candidates);
        let mut table = Table::new(["passed on", "collides"]);
        for [a, b] in passed_on {
            let name = if b == WALL { format!("{a} and a wall") } else { format!("{a} and {b}") };
            let is_it = |candidate: &&Candidate| {
                candidate.hit.first() == a && candidate.hit.second().unwrap_or(WALL) == b
            };
            let found = candidates.iter().find(is_it);
            let collides = found.map_or("no".into(), |found| format!("at {}", found.time + 0.0));
            table.row([&name, &collides]);
        }
        format!("{}\n{table}\n{} candidates\n", table_of(&discs), candidates.len())
    });
}

pub(crate) fn pair_numbers(_: &mut Random, ask: &mut impl Ask) {
    let Some(gpu) = adapter("9.4") else { return };
    ask.example(|| {
        let mut table = Table::new(["row", "pairs of six discs", "pairs of five discs"]);
        let source = format!("{RECTANGLE}{}", Lab9::balanced());
        for row in 0..5 {
            let [six, five] = [6, 5].map(|n| pairs_in_row(gpu, &source, n, row));
            table.row([&row, &six, &five]);
        }
        table.to_string()
    });
}

/// Lists the pairs of a row of the rectangle of `n` discs, in ascending order.
fn pairs_in_row(gpu: &Gpu, source: &str, n: usize, row: u32) -> String {
    let scene = line(n);
    let search = Search { rows: row..row + 1, everything: true, ..Search::of(&scene, source) };
    let list = search.run::<f32>(gpu).list;
    ascending(list.into_iter().map(|[a, b]| format!("{a}-{b}")))
}

pub(crate) fn chosen_candidates(_: &mut Random, ask: &mut impl Ask) {
    let Some(gpu) = adapter("9.5") else { return };
    ask.example(|| {
        let candidates = [
            (0.25, Hit::Pair(1, 2), "at the same time as 0 and 1, and its second disc is greater"),
            (0.25, Hit::Pair(0, 1), "the first of both its discs"),
            (0.5, Hit::Pair(2, 3), "at the same time as a wall"),
            (0.5, Hit::WallX(3), "walls come before pairs"),
            (0.75, Hit::Pair(2, 4), "its discs are still free"),
            (0.875, Hit::Pair(4, 5), "disc 4 has collided"),
            (1.0, Hit::WallY(5), "disc 5 has not"),
        ];
        let all = candidates.map(|(time, hit, _)| Candidate { time, hit });
        let chosen = chooser(gpu).choose(&all, 6).unwrap_or_else(|error| panic!("{error}"));
        let mut table = Table::new(["time", "candidate", "chosen", ""]);
        for ((time, hit, words), chosen) in candidates.iter().zip(chosen) {
            let name = match hit.second() {
                Some(second) => format!("{} and {second}", hit.first()),
                None => format!("{} and a wall", hit.first()),
            };
            table.row([time, &name, &if chosen == 1 { "yes" } else { "no" }, words]);
        }
        table.to_string()
    });
}

pub(crate) fn summed_blocks(_: &mut Random, ask: &mut impl Ask) {
    let Some(gpu) = adapter("9.6") else { return };
    ask.example(|| {
        const THREADS: usize = 3;
        let numbers = [3, 1, 4, 1, 5, 9, 2, 6, 5];
        let blocks: Vec<&[u32]> = numbers.chunks(THREADS).collect();
        let alone = blocks.iter().map(|block| sums_before(gpu, block, THREADS as u32));
        let alone: Vec<Vec<u32>> = alone.collect();
        // The total of a block: the sum before its last number, plus that number.
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
        table.to_string()
    });
}

pub(crate) fn sorted_particles(_: &mut Random, ask: &mut impl Ask) {
    let Some(gpu) = adapter_with_doubles("9.7") else { return };
    ask.example(|| {
        let places = [
            (2.5, 0.5),
            (0.5, 0.5),
            (1.75, 2.5),
            (0.25, 0.75),
            (1.75, 1.75),
            (0.5, 2.5),
            (2.75, 0.25),
            (0.75, 0.25),
        ];
        let particles = places.map(|(x, y)| at(x, y)).to_vec();
        let scene = soft::Scene::new(3.01 * soft::CUTOFF, particles).expect("the scene is valid");
        let mut engine = engine(gpu, 64);
        soft::Simulation::load(&mut engine, &scene);
        let sorted = engine.sort();
        let mut list = Table::new(["particle", "x / cutoff", "y / cutoff"]);
        for (id, (x, y)) in places.iter().enumerate() {
            list.row([&id, x, y]);
        }
        let mut table = Table::new(["bin", "column", "row", "begins at", "particles, in order"]);
        for bin in 0..sorted.grid.bins() {
            let [begin, end] = [bin, bin + 1].map(|bin| sorted.starts[bin as usize]);
            let ids = sorted.ids.get(begin as usize..end as usize).unwrap_or_default();
            let [column, row] = [bin % sorted.grid.columns, bin / sorted.grid.columns];
            table.row([&bin, &column, &row, &begin, &spaced(ids)]);
        }
        format!("{list}\n{table}")
    });
}

pub(crate) fn single_step(_: &mut Random, ask: &mut impl Ask) {
    let Some(runs) = single() else { return };
    ask.example(|| {
        let mut particles = vec![at(2.75, 5.5), at(3.25, 5.5), at(7.98, 8.5)];
        (particles[2].vx, particles[2].vy) = (1.0, -1.0);
        let scene = soft::Scene::new(10.01 * soft::CUTOFF, particles).expect("the scene is valid");
        let before = scene.particles().to_vec();
        let after = runs.run(move |engine| {
            engine.load(&scene);
            engine.step();
            let mut after = scene.particles().to_vec();
            engine.read(0, &mut after);
            after
        });
        let mut table = Table::new(["particle", "", "x / cutoff", "y / cutoff", "vx", "vy"]);
        for (before, after) in before.iter().zip(&after) {
            for (when, particle) in [("before", before), ("after", after)] {
                let [x, y, vx, vy] = rounded(particle);
                table.row([&particle.id, &when, &x, &y, &vx, &vy]);
            }
        }
        table.to_string()
    });
}

/// Formats x and y in cutoffs, vx and vy. Negative zero becomes zero.
fn rounded(particle: &soft::Particle) -> [String; 4] {
    let soft::Particle { x, y, vx, vy, .. } = *particle;
    let [x, y] = [x, y].map(|at| format!("{:.3}", at / soft::CUTOFF));
    let [vx, vy] = [vx, vy].map(|v| format!("{:.2}", v + 0.0));
    [x, y, vx, vy]
}
