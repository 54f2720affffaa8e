//! What is asked about lab 9: launches, and hard discs. Soft discs are in `lab9_soft.rs`.
//!
//! Kernels run on whatever Vulkan finds, on a grader's machine mostly a driver made of software. In
//! which order invocations come is not fixed, so lists are told sorted.

use std::collections::BTreeSet;

use common::hard::{Scene, Simulation};
use device::{Gpu, GpuError, Kernel, Launch, LaunchError, Launcher, Real};
use device_discs::hard::{Choice, Chooser, Deal, Finder, HardDiscs, HardKernels};
use lab9::Lab9;
use solution7::{Candidate, Hit, Square, pair_hit};

use self::hard::{crowd, hit};
use self::launched::{
    ALL_PAIRS, DEALT, RECTANGLE, SMALL, appended, everything_found, line, rivals, slow_contacts,
    written,
};
use crate::{Answers, Random, truth};

#[path = "../oracle/src/ask.rs"]
mod ask;
#[path = "../lab9/confirmed.rs"]
mod confirmed;
#[path = "lab9_soft.rs"]
mod discs;
#[path = "hard.rs"]
mod hard;
#[path = "../lab9/launched.rs"]
mod launched;

/// Asks everything about a task.
pub fn ask(task: &str, random: &mut Random, answers: &mut Answers) {
    match task {
        "9.1" => launches(random, answers),
        "9.2" => filters(random, answers),
        "9.3" => {
            confirmed::confirmed(random, &mut answers.told());
            basic(random, answers);
        }
        "9.4" => balanced(random, answers),
        "9.5" => choices(random, answers),
        "9.6" => discs::scans(random, answers),
        "9.7" => discs::sorts(random, answers),
        "9.8" => discs::single(random, answers),
        _ => panic!("there is no task {task}"),
    }
}

fn gpu() -> &'static Gpu {
    Gpu::shared().unwrap_or_else(|error| panic!("{error}"))
}

/// A launch, or what is wrong with it. Rows may be cut in several ways.
fn shape(launch: Result<Launch, LaunchError>, blocks: u32, most: u32) -> [f64; 4] {
    let number = f64::from;
    match launch {
        Ok(Launch { groups: [x, y], threads }) => {
            let fits = x <= most && u64::from(x) * u64::from(y) >= u64::from(blocks);
            [0.0, number(y), number(threads), truth(fits && x * (y - 1) < blocks.max(1))]
        }
        Err(LaunchError::Nothing { blocks, threads }) => {
            [1.0, number(blocks), number(threads), 0.0]
        }
        Err(LaunchError::Threads { threads, most }) => [2.0, number(threads), number(most), 0.0],
        Err(LaunchError::Blocks { blocks, most }) => [3.0, number(blocks), number(most), 0.0],
    }
}

fn launches(random: &mut Random, answers: &mut Answers) {
    for _ in 0..150 {
        let most = 2 + random.below(2000) as u32;
        let limits = wgpu::Limits {
            max_compute_invocations_per_workgroup: 256,
            max_compute_workgroup_size_x: [128, 512][random.below(2)],
            max_compute_workgroups_per_dimension: most,
            ..Default::default()
        };
        let (many, wide) = (random.below(3), random.below(3));
        let blocks = random.below([10, 5000, 5_000_000][many]) as u32;
        let threads = random.below([2, 100, 300][wide]) as u32;
        let name = format!("{blocks} workgroups of {threads}, at most {most} along an axis");
        let question = format!("{name}: 0, rows, threads, whether they suffice; or the error");
        answers.exact(&question, &shape(Lab9::launch(blocks, threads, &limits), blocks, most));
        let launch = Lab9::launch_over(blocks, threads, &limits);
        let needed = blocks.div_ceil(threads.max(1)).max(1);
        let question = format!("for {blocks} items, workgroups of {threads}, at most {most}");
        answers.exact(&question, &shape(launch, needed, most));
    }
    refusals(answers);
}

/// A launch that never ran is an error, and so is a kernel that is no WGSL.
fn refusals(answers: &mut Answers) {
    let gpu = gpu();
    let too_many = gpu.limits().max_compute_workgroups_per_dimension + 1;
    for groups in [too_many, 1] {
        let (ended, numbers) = written(gpu, groups);
        let mut told = vec![truth(matches!(ended, Err(GpuError::Refused { .. })))];
        told.extend(numbers.iter().map(|number| f64::from(*number)));
        let much = if groups == 1 { "one workgroup" } else { "one workgroup too many" };
        answers.exact(&format!("{much}: whether it is refused, and what it wrote"), &told);
    }
    let refused = matches!(
        Lab9::checked(gpu, "write", || Kernel::new(gpu, "write", &["fn write( {"], 4, &[])),
        Err(GpuError::Refused { .. })
    );
    answers.exact("whether a kernel that is no WGSL is refused", &[truth(refused)]);
}

/// `n` discs on a part of the square, that fly up to `speed`.
fn scene(random: &mut Random, n: u64, fraction: f64, speed: f64) -> Scene {
    crowd(random, n, fraction, [speed / 4.0, speed])
}

/// Tells which of the pairs that collide are in a list, and how much else.
fn tell_found(answers: &mut Answers, name: &str, scene: &Scene, count: u32, list: &[[u32; 2]]) {
    let meet =
        |pair: &&[u32; 2]| pair_hit(scene.discs(), pair[0], pair[1], scene.radius()).is_some();
    let mut pairs: Vec<[u32; 2]> = list.iter().filter(meet).copied().collect();
    pairs.sort_unstable();
    let found: Vec<f64> = pairs.as_flattened().iter().map(|disc| f64::from(*disc)).collect();
    answers.exact(&format!("{name}: the pairs passed on that collide"), &found);
    let distinct = list.iter().collect::<BTreeSet<_>>().len();
    let spare = list.len() - pairs.len();
    let told = [
        truth(count as usize == list.len()),
        (list.len() - distinct) as f64,
        truth(spare > pairs.len() / 20 + 2),
    ];
    let question =
        format!("{name}: whether all are counted, how many twice, whether too many other pairs");
    answers.exact(&question, &told);
}

fn filters(random: &mut Random, answers: &mut Answers) {
    for (n, fraction, speed) in [(100, 0.3, 2.0), (150, 0.6, 1.0), (150, 0.02, 10.0)] {
        let scene = scene(random, n, fraction, speed);
        let room = n * n;
        let name = format!("{n} discs on {fraction} of the square");
        let (count, list) = appended::<f32>(gpu(), ALL_PAIRS, &scene, 0..0, false, room);
        tell_found(answers, &format!("{name}, single precision"), &scene, count, &list);
        if gpu().expect_real::<f64>().is_ok() {
            let (count, list) = appended::<f64>(gpu(), ALL_PAIRS, &scene, 0..0, false, room);
            tell_found(answers, &format!("{name}, double precision"), &scene, count, &list);
        }
    }
    let slow = slow_contacts(|| random.between(0.0, std::f64::consts::TAU));
    let (_, list) = appended::<f32>(gpu(), ALL_PAIRS, &slow, 0..0, false, 10_000);
    let found: BTreeSet<_> = list.iter().filter(|[a, b]| a / 2 == b / 2).collect();
    answers.exact("of 100 slow contacts, passed on", &[found.len() as f64]);
    let scene = scene(random, 100, 0.3, 2.0);
    let (count, list) = appended::<f32>(gpu(), ALL_PAIRS, &scene, 0..0, true, 16);
    let kinds: BTreeSet<_> = list.iter().collect();
    let told = [f64::from(count), list.len() as f64, kinds.len() as f64];
    answers.exact("4950 pairs, room for 16: counted, held, different ones", &told);
}

fn finder<R: Real>(deal: Deal) -> Finder<Lab9, R> {
    Finder::new(gpu(), deal, SMALL, None).unwrap_or_else(|error| panic!("{error}"))
}

/// Time, kind and discs, sorted.
fn values(candidates: &[Candidate]) -> Vec<f64> {
    let value = |c: &Candidate| {
        let [kind, a, b] = hit(c.hit);
        [kind, a, b, c.time]
    };
    let mut values: Vec<[f64; 4]> = candidates.iter().map(value).collect();
    values.sort_by(|a, b| a.partial_cmp(b).expect("they are numbers"));
    values.as_flattened().to_vec()
}

fn basic(random: &mut Random, answers: &mut Answers) {
    let mut engine = HardDiscs::new(finder::<f32>(Deal::Discs), Choice::Host);
    for (n, fraction) in [(300, 0.3), (100, 0.6), (400, 0.05)] {
        let scene = scene(random, n, fraction, 2.0);
        engine.load(&scene);
        engine.step();
        let question = format!("kind, discs, time of the candidates of {n} discs");
        answers.exact(&question, &values(engine.candidates()));
        for step in 2..=4 {
            engine.step();
            let mut discs = scene.discs().to_vec();
            engine.read(0, &mut discs);
            let state: Vec<f64> = discs.iter().flat_map(|d| [d.x, d.y, d.vx, d.vy]).collect();
            answers.exact(&format!("{n} discs, step {step}, as x y vx vy"), &state);
        }
    }
    let mut finder = finder::<f32>(Deal::Discs);
    for n in [40, 900, 30, 1200, 1] {
        let found = everything_found(&mut finder, &scene(random, n, 0.3, 2.0));
        let kinds: BTreeSet<_> = found.iter().copied().collect();
        let sum: f64 =
            kinds.iter().map(|[a, b]| f64::from(*a) + 1e-4 * f64::from(*b % 10_000)).sum();
        let question = format!("{n} discs, all pairs and all walls: found");
        answers.exact(&question, &[found.len() as f64, kinds.len() as f64, sum.round()]);
    }
}

/// How many pairs there are, how many different ones, how many are no pairs, and a sum over them.
fn digest(count: u32, list: &[[u32; 2]], n: u32) -> [f64; 4] {
    let all: BTreeSet<_> = list.iter().copied().collect();
    let wrong = all.iter().filter(|[a, b]| a >= b || *b >= n).count();
    let sum: u64 = all.iter().map(|[a, b]| u64::from(*a) * 7 + u64::from(*b) * 13).sum();
    [f64::from(count), all.len() as f64, wrong as f64, sum as f64]
}

/// Everything passes the filter here: what it lets through is another task.
fn balanced(random: &mut Random, answers: &mut Answers) {
    let source = format!("{RECTANGLE}{}", Lab9::balanced());
    for n in [2, 3, 4, 5, 6, 7, 31, 64, 80 + random.below(40)] {
        let rows = 0..(n - 1 + n % 2) as u32;
        let (count, list) = appended::<f32>(gpu(), &source, &line(n), rows, true, 10_000);
        let question = format!("{n} discs: pairs with numbers, different ones, no pairs, a sum");
        answers.exact(&question, &digest(count, &list, n as u32));
    }
    let source = format!("{DEALT}{}", Lab9::balanced());
    let n = 100_000_u32;
    for row in [0, 49_999, 85_900, 99_998, random.below(99_999) as u32] {
        let (count, list) =
            appended::<f32>(gpu(), &source, &line(n as usize), row..row + 1, true, 60_000);
        let question =
            format!("row {row} of {n} discs: pairs dealt, different ones, no pairs, a sum");
        answers.exact(&question, &digest(count, &list, n));
    }
}

fn choices(random: &mut Random, answers: &mut Answers) {
    let mut chooser =
        Chooser::<Lab9>::new(gpu(), 64, None).unwrap_or_else(|error| panic!("{error}"));
    for count in [1, 40, 300, 3000, 200] {
        let candidates = rivals(count, |most| random.below(most));
        let flags = chooser.choose(&candidates, 300).expect("there is memory");
        let flags = candidates.iter().zip(&flags);
        let chosen: Vec<_> = flags.filter(|(_, flag)| **flag == 1).map(|(c, _)| *c).collect();
        let question = format!("kind, discs, time of those chosen of {count} among 300 discs");
        answers.exact(&question, &values(&chosen));
    }
}
