//! What tests and probe ask alike about launches, lists of candidates, and sums on a device, with drawn inputs and
//! what a plain model says. In which order invocations come is not fixed, so lists are told sorted.

use std::collections::BTreeSet;

use common::hard::{Disc, RandomScene, Scene, Simulation};
use common::soft;
use device::{Gpu, GpuError, Kernel, Launch, LaunchError, Launcher, Real};
use device_discs::hard::{Chooser, Finder, HardDiscs, HardKernels, WALL};
use device_discs::soft::{Double, SoftDiscs, Sorted};
use lab9::Lab9;
use solution7::{Candidate, Hit, Square, pair_hit, take_in_order, wall_hit};

use super::ask::{Ask, truth};
use super::launched::{
    ALL_PAIRS, DEALT, RECTANGLE, appended, everything_found, line, rivals, slow_contacts,
    sums_before, turn_of, written,
};
use crate::Random;

fn numbers(all: &[[u32; 2]]) -> Vec<f64> {
    all.as_flattened().iter().map(|number| f64::from(*number)).collect()
}

/// Kind (0 to 3 for a corner, an x wall, a y wall, a pair), discs, time of each.
fn values(candidates: &[Candidate]) -> Vec<[f64; 4]> {
    let value = |c: &Candidate| {
        let [kind, a, b] = match c.hit {
            Hit::Corner(a) => [0, a, WALL],
            Hit::WallX(a) => [1, a, WALL],
            Hit::WallY(a) => [2, a, WALL],
            Hit::Pair(a, b) => [3, a, b],
        };
        [f64::from(kind), f64::from(a), f64::from(b), c.time]
    };
    candidates.iter().map(value).collect()
}

fn sorted(candidates: &[Candidate]) -> Vec<f64> {
    let mut values = values(candidates);
    values.sort_by(|a, b| a.partial_cmp(b).expect("they are numbers"));
    values.concat()
}

/// A launch, or what is wrong with it: rows may be cut in several ways.
fn shape(launch: Result<Launch, LaunchError>, blocks: u32, most: u32) -> Vec<f64> {
    let [kind, a, b, fits] = match launch {
        Ok(Launch { groups: [x, y], threads }) => {
            let all = u64::from(x) * u64::from(y);
            let fits = x <= most && all >= u64::from(blocks) && all - u64::from(x) < blocks.into();
            [0, y, threads, u32::from(fits)]
        }
        Err(LaunchError::Nothing { blocks, threads }) => [1, blocks, threads, 0],
        Err(LaunchError::Threads { threads, most }) => [2, threads, most, 0],
        Err(LaunchError::Blocks { blocks, most }) => [3, blocks, most, 0],
    };
    [kind, a, b, fits].map(f64::from).to_vec()
}

/// Few and many workgroups and items, at the limits of a device and beside them, and beyond 24 bits.
pub(super) fn launches(random: &mut Random, ask: Ask<'_>) {
    for case in 0..600 {
        let most = [65_535, 2 + random.below(2000) as u32][case % 2];
        let wide = [128, 512][random.below(2)];
        let limits = wgpu::Limits {
            max_compute_invocations_per_workgroup: 256,
            max_compute_workgroup_size_x: wide,
            max_compute_workgroups_per_dimension: most,
            ..Default::default()
        };
        let rows = [1, 2, 300, 1000, most][random.below(5)].min(most);
        let edge = u64::from(most) * u64::from(rows) + random.below(3) as u64;
        let blocks = match random.below(5) {
            0 => random.below(10) as u32,
            1 => random.below(5_000_000) as u32,
            2 => (1 << 24) + 1,
            3 => u32::MAX - random.below(300) as u32,
            _ => u32::try_from(edge).map_or(u32::MAX, |edge| edge - 1),
        };
        let threads = [random.below(3), random.below(300), 128, 129, 256, 257][random.below(6)];
        let threads = threads as u32;
        let right = |blocks: u32| {
            let fit = wide.min(256);
            let needed = blocks.div_ceil(most);
            let [kind, a, b, fits] = match (blocks, threads) {
                (0, _) | (_, 0) => [1, blocks, threads, 0],
                _ if threads > fit => [2, threads, fit, 0],
                _ if needed > most => [3, blocks, most, 0],
                _ => [0, needed, threads, 1],
            };
            [kind, a, b, fits].map(f64::from).to_vec()
        };
        let name = format!("{blocks} workgroups of {threads}, at most {most} along an axis");
        let question = format!(
            "{name}: 0, rows, threads, whether they suffice (1); or the error: 1 nothing, 2 threads, 3 \
             workgroups, and its numbers"
        );
        ask(&question, shape(Lab9::launch(blocks, threads, &limits), blocks, most), right(blocks));
        if threads > 0 {
            let needed = blocks.div_ceil(threads).max(1);
            let found = shape(Lab9::launch_over(blocks, threads, &limits), needed, most);
            ask(&format!("{blocks} items, {question}"), found, right(needed));
        }
    }
    let refused = Lab9::launch_over(10, 0, &wgpu::Limits::default()).is_err();
    ask("whether ten items in workgroups of none are refused", vec![truth(refused)], vec![1.0]);
}

/// A launch that never ran is an error, and so is a kernel that is no WGSL.
pub(super) fn refusals(gpu: &Gpu, ask: Ask<'_>) {
    let too_many = gpu.limits().max_compute_workgroups_per_dimension + 1;
    for (groups, right) in [(too_many, [1, 0, 0, 0, 0]), (1, [0, 7, 8, 9, 10])] {
        let (ended, written) = written(gpu, groups);
        let why = matches!(ended, Err(GpuError::Refused { what, why }) if what != why);
        let written = written.into_iter().map(f64::from);
        let question = format!(
            "{groups} workgroups: whether they are refused with a reason (1), and the numbers that were written"
        );
        ask(
            &question,
            [truth(why)].into_iter().chain(written).collect(),
            right.map(f64::from).to_vec(),
        );
    }
    let kernel = || Kernel::new(gpu, "write", &["fn write( {"], 4, &[]);
    let refused = matches!(Lab9::checked(gpu, "write", kernel), Err(GpuError::Refused { .. }));
    ask("whether the kernel `fn write( {` is refused", vec![truth(refused)], vec![1.0]);
}

/// `n` discs of radius 1 on a part of the square, that fly up to `speed`.
pub(super) fn scene(random: &mut Random, n: u64, fraction: f64, speed: f64) -> Scene {
    let side = (n as f64 * std::f64::consts::PI / fraction).sqrt();
    let seed = 1 + random.below(1_000_000_000) as u32;
    let scene = RandomScene::new(n, side, 1.0, seed).with_speeds(speed / 4.0, speed);
    scene.draw().expect("the scene is sound")
}

/// Which pairs of a scene the filter passes on: all that collide, each once, and of others hardly any; where discs
/// graze each other or touch, that is not strict.
pub(super) fn filtered<R: Real>(gpu: &Gpu, name: &str, scene: &Scene, strict: bool, ask: Ask<'_>) {
    let n = scene.len() as u64;
    let (count, mut list) = appended::<R>(gpu, ALL_PAIRS, scene, 0..0, false, n * n);
    let meet = |[a, b]: &[u32; 2]| pair_hit(scene.discs(), *a, *b, scene.radius()).is_some();
    let pairs = (0..n as u32).flat_map(|a| (a + 1..n as u32).map(move |b| [a, b]));
    let right: Vec<[u32; 2]> = pairs.filter(meet).collect();
    let spare = list.iter().filter(|pair| !meet(pair)).count();
    let all = count as usize == list.len();
    let name = format!("{name}, in {}", std::any::type_name::<R>());
    let few = spare <= right.len() / 20 + 2 || !strict;
    let question = format!(
        "{name}: whether all that are passed on are counted, and whether few others are (1)"
    );
    ask(&question, vec![truth(all), truth(few)], vec![1.0, 1.0]);
    list.retain(meet);
    list.sort_unstable();
    ask(&format!("{name}: colliding pairs passed on"), numbers(&list), numbers(&right));
}

/// Pairs that single precision cannot tell from others, and more pairs than the list has room for.
pub(super) fn slow_and_many(gpu: &Gpu, random: &mut Random, ask: Ask<'_>) {
    let slow = slow_contacts(|| random.between(0.0, std::f64::consts::TAU));
    let (_, list) = appended::<f32>(gpu, ALL_PAIRS, &slow, 0..0, false, 10_000);
    let mut touching: Vec<_> = list.into_iter().filter(|[a, b]| a / 2 == b / 2).collect();
    touching.sort_unstable();
    let right: Vec<[u32; 2]> = (0..100).map(|k| [2 * k, 2 * k + 1]).collect();
    ask("the 100 slow contacts, in single precision", numbers(&touching), numbers(&right));
    // A device's memory comes in pieces of two pairs: an even number of them fills it exactly.
    let n = 80 + 4 * random.below(10) as u64;
    let scene = scene(random, n, 0.3, 2.0);
    let all = n * (n - 1) / 2;
    for room in [2 + 2 * random.below(50) as u64, all] {
        let (count, list) = appended::<f32>(gpu, ALL_PAIRS, &scene, 0..0, true, room);
        let pairs: BTreeSet<_> = list.iter().filter(|[a, b]| a < b).collect();
        let question = format!(
            "{all} pairs, room for {room}: how many are counted, are in the list, and are different pairs"
        );
        let found = vec![f64::from(count), list.len() as f64, pairs.len() as f64];
        ask(&question, found, vec![all as f64, room as f64, room as f64]);
    }
}

/// Lists that grow, that have been longer before, and for which the device has no memory: then parts of the rows
/// have room, or not even one.
pub(super) fn grown(random: &mut Random, new: impl Fn() -> Finder<Lab9, f32>, ask: Ask<'_>) {
    let mut finder = new();
    let [few, some, more] = [30, 700, 1100].map(|least| least + random.below(100));
    let room = 1024 + random.below(60) as u64;
    for (n, room) in [few + 10, some + 200, few, more, 1].map(|n| (n, None)).into_iter().chain([
        (some + 200, Some(room)),
        (some, Some(2 * room)),
        (more, Some(room)),
    ]) {
        if let Some(room) = room {
            finder = new().with_room_for(room);
        }
        let found = everything_found(&mut finder, &line(n));
        let all = n * (n + 1) / 2;
        let told = match found {
            Err(GpuError::Memory { .. }) => vec![],
            Err(error) => panic!("{error}"),
            Ok(found) => {
                let kinds: BTreeSet<_> = found.iter().filter(|[a, b]| a < b).collect();
                vec![found.len() as f64, kinds.len() as f64]
            }
        };
        // Each disc comes with all after it and with the walls: in one row as many as there are discs.
        let right =
            if room.is_some_and(|room| room < n as u64) { vec![] } else { vec![all as f64; 2] };
        let room = room.map_or_else(String::new, |room| format!(", memory for {room} candidates"));
        let question = format!(
            "{n} discs{room}, all pairs and all walls: how many are found, and how many of them differ; nothing \
             if there is no memory for one row"
        );
        ask(&question, told, right);
    }
}

/// Every pair has a number, and every number a pair.
pub(super) fn rectangles(gpu: &Gpu, random: &mut Random, ask: Ask<'_>) {
    let source = format!("{RECTANGLE}{}", Lab9::balanced());
    for n in [2, 3, 4, 5, 6, 7, 31, 64, 80 + random.below(40)] {
        let rows = 0..(n - 1 + n % 2) as u32;
        let (count, mut list) = appended::<f32>(gpu, &source, &line(n), rows, true, 10_000);
        list.sort_unstable();
        let right: Vec<_> =
            (0..n as u32).flat_map(|a| (a + 1..n as u32).map(move |b| [a, b])).collect();
        let question = format!("{n} discs: how many pairs have a number");
        ask(&question, vec![f64::from(count)], vec![right.len() as f64]);
        ask(&format!("{n} discs: the pairs that have a number"), numbers(&list), numbers(&right));
    }
    let source = format!("{DEALT}{}", Lab9::balanced());
    let n = 100_000_u32;
    for row in [0, 1, 49_999, 50_000, 85_899, 85_900, 99_998, random.below(99_999) as u32] {
        let (count, list) =
            appended::<f32>(gpu, &source, &line(n as usize), row..row + 1, true, 60_000);
        let found: BTreeSet<_> = list.into_iter().collect();
        // n is even: see the picture in balanced.wgsl.
        let pair = |column: u32| match column < row + 1 {
            true => [column, row + 1],
            false => [n - 1 - column, n - 1 - row],
        };
        let lost = (0..n / 2).map(pair).filter(|pair| !found.contains(pair)).count();
        let question = format!(
            "row {row} of {n} discs: how many are dealt, how many differ, how many are lost"
        );
        let told = [count as usize, found.len(), lost].map(|number| number as f64).to_vec();
        ask(&question, told, vec![f64::from(n / 2), f64::from(n / 2), 0.0]);
    }
}

/// Whether four invocations share the work on all rows: none does over two thirds of it.
pub(super) fn turns(gpu: &Gpu, (find, source): (&str, &str), ask: Ask<'_>) {
    for n in [24, 61] {
        let rows = 0..(n as u32);
        let passed_on = |turn: u32| {
            let source = turn_of(find, turn) + source;
            appended::<f32>(gpu, &source, &line(n), rows.clone(), true, 10_000).0
        };
        let found = [0, 1, 2, 3].map(passed_on);
        let all: u32 = found.iter().sum();
        let question =
            format!("{find}, {n} discs, four invocations: does one do over two thirds (1)");
        ask(&question, vec![truth(found.iter().any(|one| 3 * one > 2 * all))], vec![0.0]);
    }
}

/// Few and many candidates, many of them at one time: which are chosen.
pub(super) fn choices(gpu: &'static Gpu, random: &mut Random, ask: Ask<'_>) {
    let mut chooser = Chooser::<Lab9>::new(gpu, 64, None).unwrap_or_else(|error| panic!("{error}"));
    for count in [1, 40, 300, 3000, 200, 5000, 1 + random.below(4000)] {
        let mut candidates = rivals(count, |most| random.below(most));
        let flags = chooser.choose(&candidates, 300);
        let flags = flags.unwrap_or_else(|error| panic!("{error}"));
        let flags = candidates.iter().zip(&flags);
        let chosen: Vec<_> = flags.filter(|(_, flag)| **flag == 1).map(|(c, _)| *c).collect();
        let (mut free, mut taken) = (vec![true; 300], Vec::new());
        take_in_order(&mut candidates, &mut free, &mut taken);
        let question = format!(
            "kind (0 corner, 1 and 2 walls, 3 pair), discs, time of those chosen of {count} among 300 discs"
        );
        ask(&question, sorted(&chosen), sorted(&taken));
    }
}

/// The candidates of each of some steps, which the engine's own state decides.
pub(super) fn candidates<R: Real>(
    engine: &mut HardDiscs<Lab9, R>,
    (name, scene): (&str, &Scene),
    steps: usize,
    ask: Ask<'_>,
) {
    let square = Square::of(scene);
    let mut discs = scene.discs().to_vec();
    engine.load(scene);
    for step in 1..=steps {
        let n = discs.len() as u32;
        let walls = (0..).zip(&discs).filter_map(|(i, disc)| wall_hit(i, disc, square));
        let pairs = (0..n).flat_map(|a| (a + 1..n).map(move |b| (a, b)));
        let pairs = pairs.filter_map(|(a, b)| pair_hit(&discs, a, b, square.radius));
        let right: Vec<Candidate> = walls.chain(pairs).collect();
        engine.step();
        let question = format!(
            "{name}, step {step}: kind (0 corner, 1 and 2 walls, 3 pair), discs, time of each candidate"
        );
        ask(&question, sorted(engine.candidates()), sorted(&right));
        engine.read(0, &mut discs);
    }
}

/// Sums of few and many numbers, by workgroups of few and many threads.
pub(super) fn scans(gpu: &Gpu, random: &mut Random, ask: Ask<'_>) {
    for threads in [1, 2, 8, 32, 64, 96, 256] {
        let drawn = 1 + random.below(70_000);
        for n in [1, 2, 31, 32, 33, 63, 64, 65, 255, 256, 257, 1000, 4096, 4097, 70_000, drawn] {
            let numbers: Vec<u32> = (0..n).map(|_| random.below(10) as u32).collect();
            let mut sum = 0;
            let before = |number: &u32| {
                sum += number;
                sum - number
            };
            let right: Vec<u32> = numbers.iter().map(before).collect();
            let told = |sums: &[u32]| {
                let all = (1..).zip(sums).map(|(k, sum)| f64::from(k) * f64::from(*sum)).sum();
                sums.iter().take(300).map(|sum| f64::from(*sum)).chain([all]).collect::<Vec<f64>>()
            };
            let question = format!(
                "{n} numbers, workgroups of {threads}: sums before the first 300, and all of them weighed"
            );
            ask(&question, told(&sums_before(gpu, &numbers, threads)), told(&right));
        }
    }
}

/// Where particles stand before each of some steps, by bin and by id.
pub(super) fn bins(
    engine: &mut SoftDiscs<Lab9, Double>,
    (name, scene): (&str, &soft::Scene),
    ask: Ask<'_>,
) {
    use soft::Simulation;
    engine.load(scene);
    let mut particles = scene.particles().to_vec();
    for step in 0..6 {
        engine.read(0, &mut particles);
        let Sorted { grid, starts, ids } = engine.sort();
        let bin = |p: &soft::Particle| grid.column(p.y) * grid.columns + grid.column(p.x);
        let mut right: Vec<_> = particles.iter().map(|p| (bin(p), p.id)).collect();
        right.sort_unstable();
        let real = |all: &[u32]| all.iter().map(|number| f64::from(*number)).collect::<Vec<f64>>();
        let by_id: Vec<u32> = right.iter().map(|(_, id)| *id).collect();
        let name = format!("{name}, after {step} steps");
        ask(&format!("{name}: the particles by bin and by id"), real(&ids), real(&by_id));
        let begins = |bin: u32| right.partition_point(|(other, _)| *other < bin) as u32;
        let begins: Vec<u32> = (0..=grid.bins()).map(begins).collect();
        ask(&format!("{name}: where each bin begins"), real(&starts), real(&begins));
        engine.step();
    }
}

/// What a device passed on, one list after the other into the same candidates: more, fewer, none, with pairs and walls
/// that collide or not.
pub(super) fn confirmed(random: &mut Random, ask: Ask<'_>) {
    let mut candidates = Vec::new();
    for n in random.sizes(4097).into_iter().chain([257, 1, 0]) {
        let square = Square { side: 3.0 * (n as f64 + 4.0).sqrt(), radius: 1.0 };
        let discs: Vec<Disc> = (0..n + 2)
            .map(|_| {
                let mut coordinate = || random.between(1.0, square.side - 1.0);
                let (x, y) = (coordinate(), coordinate());
                Disc::new(x, y, random.signed(1e-3, 8.0), random.signed(1e-3, 8.0))
            })
            .collect();
        let found: Vec<[u32; 2]> = (0..n)
            .map(|_| {
                let (a, b) = (random.below(n + 2) as u32, random.below(n + 2) as u32);
                if a == b || random.below(3) == 0 { [a, WALL] } else { [a.min(b), a.max(b)] }
            })
            .collect();
        let right: Vec<Candidate> = found
            .iter()
            .filter_map(|&[a, b]| match b {
                WALL => wall_hit(a, &discs[a as usize], square),
                b => pair_hit(&discs, a, b, square.radius),
            })
            .collect();
        let before = candidates.len();
        Lab9::confirm(&discs, square, &found, &mut candidates);
        let question = format!(
            "a device passed on {n}, and {before} candidates stand there from before: kind, discs, time of each \
             that is confirmed"
        );
        ask(&question, values(&candidates).concat(), values(&right).concat());
    }
}
