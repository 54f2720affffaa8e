//! What is asked about lab 4: the functions one at a time, and those that lock by several threads.

use std::ops::Range;
use std::sync::Arc;
use std::thread;

use common::Vec2;
use common::soft::{CUTOFF, Observer, Particle, Scene};
use crossbeam::channel::unbounded;
use crossbeam::queue::SegQueue;
use lab4::{
    Change, Cut, Lock, LockOrder, Meter, Regions, Watch, apply_all, apply_own, change_bin, claim,
    move_own, pairs_across, pairs_within, post, rebuild, receive, send, take, take_own,
};
use solution1::Tally;
use solution2::{Grid, SortedBins};

use self::locked::{BINS, changes, concerning, filled, sent_by_four, strip, two_waits};
use crate::{Answers, Random, truth};

#[path = "../lab4/locked.rs"]
mod locked;
#[path = "soft.rs"]
mod soft;

/// Asks everything about a task.
pub fn ask(task: &str, random: &mut Random, answers: &mut Answers) {
    match task {
        "4.1" => {
            regions(random, answers);
            places(random, answers);
        }
        "4.2" => meters(answers),
        "4.3" => two_locks(random, answers),
        "4.4" => moves(random, answers),
        "4.5" => rebuilds(random, answers),
        "4.6" => buffers(random, answers),
        "4.7" => queues(random, answers),
        "4.8" => channels(random, answers),
        "4.9" => owners(random, answers),
        "4.10" => pairs_of_a_strip(random, answers),
        "4.11" => pairs_across_a_cut(random, answers),
        _ => panic!("there is no task {task}"),
    }
}

/// 150 particles anywhere in 9 rows of bins or more.
fn scene(random: &mut Random) -> Scene {
    soft::crowd(random, 150, 9.5 * CUTOFF, 1.0)
}

fn regions(random: &mut Random, answers: &mut Answers) {
    for bins in [1, 2, 9, 10 + random.below(200)] {
        for count in [1, 2, 3, 7, 40, 1000] {
            let mut regions = Regions::new(bins, count);
            let name = format!("{bins} bins in {count} regions");
            let sizes: Vec<f64> = regions.parts_mut().map(|bins| bins.len() as f64).collect();
            answers.exact(&format!("{name}: bins in each"), &sizes);
            let numbers = locked::numbers(&mut regions).into_iter().map(|lock| lock as f64);
            let numbers: Vec<f64> = numbers.collect();
            answers.exact(&format!("{name}: the number of each lock"), &numbers);
            let bins_each = 1 + random.below(9);
            let found: Vec<f64> = (0..bins)
                .map(|bin| Cut { bins_each }.find(bin))
                .flat_map(|(region, place)| [region as f64, place as f64])
                .collect();
            let question = format!("region and place of {bins} bins, {bins_each} in a region");
            answers.exact(&question, &found);
        }
    }
}

/// Bins of any number.
fn places(random: &mut Random, answers: &mut Answers) {
    for _ in 0..40 {
        let (bins_each, bin) = (1 + random.size(70_000), random.size(1 << 40));
        let (region, place) = Cut { bins_each }.find(bin);
        let question = format!("region and place of bin {bin}, {bins_each} in a region");
        answers.exact(&question, &[region as f64, place as f64]);
    }
}

fn meters(answers: &mut Answers) {
    let lock = Lock::new(0, 5.0);
    let mut meter = Meter::default();
    for _ in 0..3 {
        *meter.lock(&lock) += 1.0;
    }
    let waited = meter.waiting.as_secs_f64();
    let told = [*lock.lock(), meter.locks as f64, meter.contended as f64, waited];
    answers.exact("a free lock, three times: what it guards, locks, waits, time waited", &told);
    let (meter, waited, requests) = two_waits();
    let measured = meter.waiting > waited / 2 && meter.waiting <= waited;
    let told = [meter.locks as f64, meter.contended as f64, truth(measured)];
    answers.exact("two locks that another holds: locks, waits, whether both were timed", &told);
    let spins = truth(requests > 6);
    answers.exact(
        "two locks that another holds: whether they are asked for again and again",
        &[spins],
    );
}

/// What each bin holds, in the order of numbers, with -1 after each bin.
fn contents(regions: &mut Regions) -> Vec<f64> {
    let mut all = Vec::new();
    for bins in regions.parts_mut() {
        for bin in bins.iter_mut() {
            bin.sort_unstable();
            all.extend(bin.iter().map(|particle| f64::from(*particle)));
            all.push(-1.0);
        }
    }
    all
}

fn two_locks(random: &mut Random, answers: &mut Answers) {
    for each in [1, 3, 12] {
        let name = format!("12 bins, {each} in a region");
        // One thread, and whether its locks could be in the way of another's.
        let mut regions = filled(BINS, each);
        let order = Arc::new(LockOrder::default());
        let watch: Arc<dyn Watch> = order.clone();
        regions.watch(&watch);
        let mut meter = Meter::default();
        for change in changes(random).into_iter().flatten() {
            change_bin(&regions, &mut meter, change);
        }
        let counts = [meter.locks as f64, meter.contended as f64, order.most_held() as f64];
        answers.exact(&format!("{name}: locks taken, waited for, most at once"), &counts);
        answers.exact(&format!("{name}: particles in each bin"), &contents(&mut regions));
        let (mut regions, locks) = sent_by_four(each, 25);
        answers.exact(&format!("{name}, 4 threads: locks taken"), &[locks as f64]);
        answers
            .exact(&format!("{name}, 4 threads: particles in each bin"), &contents(&mut regions));
    }
    answers.exact(
        "two threads in two bins, one between the other's requests",
        &contents(&mut locked::changed_by_two()),
    );
}

fn moves(random: &mut Random, answers: &mut Answers) {
    for round in 0..20 {
        let scene = soft::crowd(random, 150, 9.5 * CUTOFF, 30.0);
        let grid = Grid::of_scene(&scene, 2.0);
        let mut particles = scene.particles()[..random.below(151)].to_vec();
        let mut push = || random.between(-9.0, 9.0);
        let accelerations: Vec<Vec2> =
            particles.iter().map(|_| Vec2::new(push(), push())).collect();
        let mut told = Vec::new();
        move_own(&grid, &mut particles, &accelerations, |change| {
            told.extend([f64::from(change.particle), change.from as f64, change.to as f64]);
        });
        let state: Vec<f64> = particles.iter().flat_map(|p| [p.x, p.y, p.vx, p.vy]).collect();
        answers
            .exact(&format!("round {round}: x y vx vy of {} particles", particles.len()), &state);
        answers.exact(&format!("round {round}: particle, old bin, new bin"), &told);
    }
}

/// Particles on walls and edges of bins, and their bins.
fn binned(random: &mut Random) -> (Grid, Vec<Particle>) {
    let grid = Grid::with_bins_along(random.between(0.1, 9.0), 5 + random.below(9));
    (grid, soft::on_edges(random, 150, grid.size(), grid.rows()))
}

fn rebuilds(random: &mut Random, answers: &mut Answers) {
    for round in 0..20 {
        let (grid, particles) = binned(random);
        let mut regions = filled(grid.bins(), 1 + random.below(40));
        rebuild(&mut regions, &grid, &particles);
        answers.exact(&format!("round {round}: particles in each bin"), &contents(&mut regions));
    }
}

fn buffers(random: &mut Random, answers: &mut Answers) {
    for round in 0..20 {
        let each = 1 + random.below(6);
        let (mut regions, buffers) = (filled(BINS, each), changes(random));
        apply_all(&mut regions, buffers.iter().map(|buffer| &buffer[..]));
        answers.exact(&format!("round {round}, by one: each bin"), &contents(&mut regions));
        let mut regions = filled(BINS, each);
        let cut = regions.cut;
        for (own, bins) in regions.parts_mut().enumerate() {
            apply_own(cut, own, bins, buffers.iter().flatten().copied());
        }
        answers.exact(&format!("round {round}, by all: each bin"), &contents(&mut regions));
    }
}

/// A change and the particle, old and new bin that it speaks of.
fn words(change: &Change) -> [f64; 3] {
    [f64::from(change.particle), change.from as f64, change.to as f64]
}

/// Changes in the order of particles.
fn sorted(mut changes: Vec<Change>) -> Vec<f64> {
    changes.sort_by_key(|change| change.particle);
    changes.iter().flat_map(words).collect()
}

fn queues(random: &mut Random, answers: &mut Answers) {
    let cut = Cut { bins_each: 4 };
    for round in 0..20 {
        let changes = changes(random);
        let queues = [SegQueue::new(), SegQueue::new(), SegQueue::new()];
        thread::scope(|scope| {
            for buffer in &changes {
                let queues = &queues;
                scope.spawn(move || buffer.iter().for_each(|change| post(cut, queues, *change)));
            }
        });
        let mut regions = filled(BINS, 4);
        for (owner, bins) in regions.parts_mut().enumerate() {
            let posted = std::iter::from_fn(|| queues[owner].pop()).collect();
            let name = format!("round {round}, owner {owner}");
            answers.exact(
                &format!("{name}: particle, old bin, new bin in its queue"),
                &sorted(posted),
            );
            // The queue again, filled by the probe.
            concerning(owner, &changes).for_each(|change| queues[owner].push(change));
            take(cut, owner, bins, &queues[owner]);
            answers.exact(&format!("{name}: left in its queue"), &[queues[owner].len() as f64]);
        }
        answers.exact(&format!("round {round}: particles in each bin"), &contents(&mut regions));
    }
}

fn channels(random: &mut Random, answers: &mut Answers) {
    let cut = Cut { bins_each: 4 };
    for round in 0..20 {
        let changes = changes(random);
        let (senders, receivers): (Vec<_>, Vec<_>) = (0..3).map(|_| unbounded()).unzip();
        thread::scope(|scope| {
            for buffer in &changes {
                let senders = &senders;
                scope.spawn(move || buffer.iter().for_each(|change| send(cut, senders, *change)));
            }
        });
        let mut regions = filled(BINS, 4);
        for (owner, bins) in regions.parts_mut().enumerate() {
            let sent = receivers[owner].try_iter().collect();
            let name = format!("round {round}, owner {owner}");
            answers.exact(&format!("{name}: particle, old bin, new bin sent to it"), &sorted(sent));
            // The channel again, filled by the probe.
            concerning(owner, &changes)
                .for_each(|change| senders[owner].send(change).expect("it has a receiver"));
            receive(cut, owner, bins, &receivers[owner]);
        }
        answers.exact(&format!("round {round}: particles in each bin"), &contents(&mut regions));
    }
}

/// Rows that an owner may have.
fn parts(rows: usize) -> [Range<usize>; 5] {
    [0..rows, 4..4, 0..1, rows - 2..rows, 2..5]
}

fn owners(random: &mut Random, answers: &mut Answers) {
    for round in 0..30 {
        let (grid, particles) = binned(random);
        for rows in parts(grid.rows()) {
            let mut own = SortedBins::new(grid, rows.clone());
            own.put(Particle { y: grid.size() * 0.5, ..particles[7] });
            take_own(&mut own, particles.iter());
            let ids = soft::ids(own.particles());
            answers.exact(&format!("round {round}: particles in rows {rows:?}"), &ids);
        }
        let mut regions = filled(grid.bins(), 1 + random.below(40));
        let cut = regions.cut;
        for (own, bins) in regions.parts_mut().enumerate() {
            claim(cut, own, bins, &grid, &particles);
        }
        answers.exact(&format!("round {round}: particles in each bin"), &contents(&mut regions));
    }
}

/// The accelerations of some particles, each in units of what pairs in the scene do to it at most.
fn scaled(accelerations: &[Vec2], particles: &[Particle], scene: &Scene) -> Vec<f64> {
    let scale = |p: &Particle| {
        let parts = scene.particles().iter().filter_map(|q| solution1::pair_acceleration(p.to(q)));
        1.0 + parts.map(|a| a.norm_squared().sqrt()).sum::<f64>()
    };
    let pairs = accelerations.iter().zip(particles);
    pairs.flat_map(|(a, p)| [a.x / scale(p), a.y / scale(p)]).collect()
}

/// navg and the pairs looked at.
fn seen(tally: &Tally) -> [f64; 2] {
    let seen = tally.statistics().expect("a tally has statistics");
    [seen.navg as f64, seen.pair_tests as f64]
}

fn pairs_of_a_strip(random: &mut Random, answers: &mut Answers) {
    for round in 0..8 {
        let scene = scene(random);
        for bin_size in [1.0, 2.0, 9.0] {
            let grid = Grid::of_scene(&scene, bin_size);
            for rows in [0..grid.rows(), 0..1, grid.rows() / 2..grid.rows()] {
                let bins = strip(&scene, grid, rows.clone());
                let mut forces = vec![Vec2::ZERO; bins.particles().len()];
                let mut tally = Tally::default();
                pairs_within(&bins, &mut forces, &mut tally);
                let name = format!("round {round}, rows {rows:?} of bins of {bin_size} cutoffs");
                let forces = scaled(&forces, bins.particles(), &scene);
                answers.close(&format!("{name}: the forces among them, bin by bin"), &forces);
                let question = format!("{name}: ordered pairs seen, pairs looked at");
                answers.exact(&question, &seen(&tally));
            }
        }
    }
}

fn pairs_across_a_cut(random: &mut Random, answers: &mut Answers) {
    for round in 0..8 {
        let scene = scene(random);
        for bin_size in [1.0, 2.0] {
            let grid = Grid::of_scene(&scene, bin_size);
            for cut in 1..grid.rows() {
                let lower = strip(&scene, grid, cut - 1..cut);
                let upper = strip(&scene, grid, cut..grid.rows());
                let first_row = &upper.particles()[upper.places(cut..cut + 1)];
                let mut forces = vec![Vec2::ZERO; lower.particles().len()];
                let mut across = vec![Vec2::ZERO; first_row.len()];
                let mut tally = Tally::default();
                pairs_across(&lower, &upper, &mut forces, &mut across, &mut tally);
                let name =
                    format!("round {round}, bins of {bin_size} cutoffs, cut below row {cut}");
                let forces = scaled(&forces, lower.particles(), &scene);
                answers.close(&format!("{name}: the forces on the row below it"), &forces);
                let across = scaled(&across, first_row, &scene);
                answers.close(&format!("{name}: the forces on the row above it"), &across);
                let question = format!("{name}: ordered pairs seen, pairs looked at");
                answers.exact(&question, &seen(&tally));
            }
        }
    }
}
