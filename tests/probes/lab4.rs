//! What is asked about lab 4: the functions one at a time, and those that lock by several threads.

use std::ops::Range;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::Duration;

use common::Vec2;
use common::soft::{CUTOFF, Observer, Particle, Scene};
use crossbeam_queue::SegQueue;
use lab4::{Meter, Regions, pairs_across, pairs_within, post, put_all, rebuild, take, take_own};
use parking_lot::Mutex;
use solution1::Tally;
use solution2::{Grid, SortedBins, VecBins};

use crate::{Answers, Random};

#[path = "soft.rs"]
mod soft;

/// Asks everything about a task.
pub fn ask(task: &str, random: &mut Random, answers: &mut Answers) {
    match task {
        "4.1" => rebuilds(random, answers),
        "4.2" => regions(random, answers),
        "4.3" => meters(answers),
        "4.4" => locks(random, answers),
        "4.5" => queues(random, answers),
        "4.6" => owners(random, answers),
        "4.7" => pairs_of_a_strip(random, answers),
        "4.8" => pairs_across_a_cut(random, answers),
        _ => panic!("there is no task {task}"),
    }
}

/// 150 particles anywhere in 9 rows of bins or more.
fn scene(random: &mut Random) -> Scene {
    soft::crowd(random, 150, 9.5 * CUTOFF, 1.0)
}

fn rebuilds(random: &mut Random, answers: &mut Answers) {
    for round in 0..30 {
        let scene = scene(random);
        let (inside, left) = scene.particles().split_at(random.below(150));
        let (some, others) = left.split_at(random.below(left.len() + 1));
        let mut bins = VecBins::of_scene(&scene, 1.0);
        bins.refill(inside);
        // What the step before left in the list.
        let mut all = vec![scene.particles()[0]; random.below(9)];
        rebuild(&mut bins, [some, &[], others].into_iter(), &mut all);
        let question = format!("round {round}: bin and id of 150 particles");
        answers.exact(&question, &soft::residents(bins.bins()));
    }
}

fn regions(random: &mut Random, answers: &mut Answers) {
    for bins in [1, 2, 9, 10 + random.below(200)] {
        for count in [1, 2, 3, 7, 40, 1000] {
            let mark = |bin: usize| vec![Particle { id: bin as u32, ..Particle::default() }];
            let mut lists: Vec<_> = (0..bins).map(mark).collect();
            let regions = Regions::new(&mut lists, count);
            let found = |bin| {
                let (region, place) = regions.find(bin);
                let region = region.lock();
                region.get(place).map_or(-1.0, |list: &Vec<Particle>| f64::from(list[0].id))
            };
            let found: Vec<f64> = (0..bins).map(found).collect();
            let question =
                format!("the bins found when asked for bins 0 to {bins} of {count} regions");
            answers.exact(&question, &found);
        }
    }
}

fn meters(answers: &mut Answers) {
    let mutex = Mutex::new(5.0);
    let mut meter = Meter::default();
    for _ in 0..3 {
        *meter.lock(&mutex) += 1.0;
    }
    let waited = meter.waiting.as_secs_f64();
    let told = [*mutex.lock(), meter.locks as f64, meter.contended as f64, waited];
    answers.exact("a free lock, three times: what it guards, locks, waits, time waited", &told);
    // On a busy machine the lock may be free again before it is asked for: then again.
    let meter = (0..20).map(|_| wait_for_a_lock()).find(|meter| meter.contended > 0);
    let meter = meter.unwrap_or_default();
    let measured = f64::from(u8::from(meter.waiting > Duration::ZERO));
    let told = [meter.locks as f64, meter.contended as f64, measured];
    answers.exact("a lock that another holds: locks, waits, whether the wait has a length", &told);
}

/// The meter of somebody who asks for a lock while another holds it.
fn wait_for_a_lock() -> Meter {
    let (mutex, held, asking) = (Mutex::new(()), AtomicBool::new(false), AtomicBool::new(false));
    let until = |flag: &AtomicBool| {
        while !flag.load(Ordering::Acquire) {
            thread::yield_now();
        }
    };
    let mut meter = Meter::default();
    thread::scope(|scope| {
        scope.spawn(|| {
            let _guard = mutex.lock();
            held.store(true, Ordering::Release);
            until(&asking);
            thread::sleep(Duration::from_millis(30));
        });
        until(&held);
        asking.store(true, Ordering::Release);
        drop(meter.lock(&mutex));
    });
    meter
}

fn locks(random: &mut Random, answers: &mut Answers) {
    for (round, count) in [1, 7, 40, 1, 7, 40].into_iter().enumerate() {
        let scene = soft::crowd(random, 2000, 9.5 * CUTOFF, 0.0);
        let grid = Grid::of_scene(&scene, 1.0);
        let mut bins = VecBins::new(grid);
        let locks: u64 = {
            let regions = Regions::new(bins.bins_mut(), count);
            let regions = &regions;
            thread::scope(|scope| {
                let threads: Vec<_> = scene
                    .particles()
                    .chunks(500)
                    .map(|leavers| {
                        scope.spawn(move || {
                            let mut meter = Meter::default();
                            put_all(&grid, regions, leavers, &mut meter);
                            meter.locks
                        })
                    })
                    .collect();
                threads.into_iter().map(|thread| thread.join().expect("put_all returns")).sum()
            })
        };
        let name = format!("round {round}, 2000 particles, 4 threads, {count} locks");
        answers.exact(&format!("{name}: bin and id of everybody"), &soft::residents(bins.bins()));
        answers.exact(&format!("{name}: locks taken"), &[locks as f64]);
    }
}

fn queues(random: &mut Random, answers: &mut Answers) {
    for round in 0..20 {
        let scene = scene(random);
        let grid = Grid::of_scene(&scene, 1.0);
        let columns = grid.columns();
        let cuts = [0, 1 + random.below(4), 6, grid.rows()];
        let owner = |row: usize| cuts[1..].iter().filter(|cut| row >= **cut).count();
        let owners: Vec<usize> = (0..grid.rows()).map(owner).collect();
        let queues = [SegQueue::new(), SegQueue::new(), SegQueue::new()];
        let (some, others) = scene.particles().split_at(70);
        thread::scope(|scope| {
            for leavers in [some, others] {
                scope.spawn(|| post(&grid, &owners, &queues, leavers));
            }
        });
        for (owner, queue) in queues.iter().enumerate() {
            let mut ids = Vec::new();
            while let Some(particle) = queue.pop() {
                ids.push(f64::from(particle.id));
            }
            ids.sort_by(f64::total_cmp);
            let rows = cuts[owner]..cuts[owner + 1];
            answers.exact(&format!("round {round}: who is posted to the owner of {rows:?}"), &ids);
            // The queue again, filled by the probe.
            let mine = scene.particles().iter().filter(|p| rows.contains(&grid.row(p.y)));
            mine.for_each(|p| queue.push(*p));
            let mut own = vec![Vec::new(); rows.len() * columns];
            take(&grid, rows.start * columns, &mut own, queue);
            let left = queue.len() as f64;
            answers
                .exact(&format!("round {round}: letters left for the owner of {rows:?}"), &[left]);
            let question = format!("round {round}: bin and id of who arrived in rows {rows:?}");
            answers.exact(&question, &soft::residents(&own));
        }
    }
}

/// Rows that an owner may have.
fn parts(rows: usize) -> [Range<usize>; 5] {
    [0..rows, 4..4, 0..1, rows - 2..rows, 2..5]
}

fn owners(random: &mut Random, answers: &mut Answers) {
    for round in 0..30 {
        let scene = scene(random);
        let grid = Grid::of_scene(&scene, 1.0);
        for rows in parts(grid.rows()) {
            let mut own = SortedBins::new(grid, rows.clone());
            own.put(Particle { y: grid.size() * 0.5, ..scene.particles()[7] });
            take_own(&mut own, scene.particles().iter());
            let mut ids: Vec<f64> = own.particles().iter().map(|p| f64::from(p.id)).collect();
            ids.sort_by(f64::total_cmp);
            answers.exact(&format!("round {round}: who is in rows {rows:?}"), &ids);
        }
    }
}

/// The particles that lie in some rows, in sorted bins.
fn strip(scene: &Scene, grid: Grid, rows: Range<usize>) -> SortedBins {
    let mut bins = SortedBins::new(grid, rows.clone());
    bins.refill(scene.particles().iter().filter(|p| rows.contains(&grid.row(p.y))).copied());
    bins
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
