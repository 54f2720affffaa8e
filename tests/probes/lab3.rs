//! What is asked about lab 3: each function of a thread, with what the others would have done made
//! by the probe.

use std::ops::Range;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};

use common::Vec2;
use common::soft::{CUTOFF, NoStatistics, Observer, Particle, Scene, Simulation, Statistics};
use lab3::{
    Barrier, VARIANTS, Vanilla, Worker, in_order, on_threads, pool, sum_and_move, take_posted,
    take_steps, under_a_lock, with_atomics,
};
use solution1::Tally;
use solution2::{Grid, SortedBins, VecBins};

use self::meeting::{MEETING, Moved, OfOne, Slow, Visitor};
use self::soft::{Engine, on_edges};
use self::waiting::{Gathering, gather, interrupted, rehearse};
use crate::{Answers, Random};

#[path = "../lab3/meeting.rs"]
mod meeting;
#[path = "../lab3/questions.rs"]
mod questions;
#[path = "soft.rs"]
mod soft;
#[path = "../lab3/waiting.rs"]
mod waiting;

/// Asks everything about a task.
pub fn ask(task: &str, random: &mut Random, answers: &mut Answers) {
    match task {
        "3.1" => all_pairs(random, answers),
        "3.2" => reductions(random, answers),
        "3.3" => questions::rows(random, &mut told(answers)),
        "3.4" => forces(random, answers),
        "3.5" => moves(random, answers),
        "3.6" => loops(random, answers),
        "3.7" => questions::by_one(random, &mut told(answers)),
        "3.8" => questions::by_all(random, &mut told(answers)),
        "3.9" => mail(random, answers),
        "3.10" => barriers(answers),
        "3.11" => threads(answers),
        _ => panic!("there is no task {task}"),
    }
}

/// Tells what the lab answers; what is right is the solution's to say.
fn told(answers: &mut Answers) -> impl FnMut(&str, Vec<usize>, Vec<usize>) {
    |question, found, _| {
        let found: Vec<f64> = found.into_iter().map(|number| number as f64).collect();
        answers.exact(question, &found);
    }
}

fn all_pairs(random: &mut Random, answers: &mut Answers) {
    for threads in [1, 2, 3, 8] {
        let mut engine = Engine::new(VARIANTS, "vanilla", threads, &[]);
        let mut ask = |name: &str, scene: &Scene, steps| {
            let question = format!("vanilla on {threads} threads, {name}");
            answers.bits(&question, &engine.run(scene, steps));
        };
        ask("150 in 10.3 cutoffs", &soft::spread(random, 150, 10.3 * CUTOFF, 1.0), 10);
        ask("a crowd of 200", &soft::crowd(random, 200, 2.55 * CUTOFF, 1.0), 2);
        ask("a heap of 60", &soft::heap(random), 1);
        let mut engine = Engine::counting(VARIANTS, "vanilla", threads, &[]);
        let scene = soft::spread(random, 300, 15.3 * CUTOFF, 1.0);
        for seen in engine.statistics(&scene, 3) {
            let question = format!("dmin, davg, navg, pairs of 300 particles on {threads} threads");
            answers.close(&question, &seen);
        }
    }
    let mut engine = Vanilla::<OfOne>::new(2);
    engine.load(&soft::spread(random, 150, 10.3 * CUTOFF, 1.0));
    engine.sum_forces();
    let alone = Simulation::statistics(&engine).map_or(0, |seen| seen.navg);
    answers.exact("observers that were told of the pairs of one particle", &[alone as f64]);
    for threads in [2, 5] {
        MEETING.begin(threads);
        let mut engine = Vanilla::<Visitor>::new(threads);
        engine.load(&soft::spread(random, 150, 10.3 * CUTOFF, 1.0));
        engine.sum_forces();
        let question = format!("threads of a pool of {threads} that sum forces, at the same time");
        answers.exact(&question, &came(threads));
    }
}

/// How many threads came to the meeting, and how many of them from a pool of so many.
fn came(threads: usize) -> [f64; 2] {
    MEETING.end(threads).map(|count| count as f64)
}

fn reductions(random: &mut Random, answers: &mut Answers) {
    let of = |tally: &Tally| tally.statistics().expect("a tally has statistics");
    for count in [0, 1, 64, 1000, 5000] {
        let parts: Vec<Tally> = (0..count)
            .map(|_| {
                let mut tally = Tally::default();
                tally.tested(random.below(9) as u64);
                tally.seen((CUTOFF * random.between(0.01, 1.0)).powi(2));
                tally
            })
            .collect();
        let statistics: Vec<Statistics> = parts.iter().map(of).collect();
        for threads in [1, 2, 3, 8] {
            let pool = pool(threads);
            let name = format!("dmin, davg, navg, pairs of {count} parts on {threads} threads");
            let found = pool.install(|| under_a_lock(&parts));
            answers.close(&format!("{name}, under a lock"), &soft::numbers(of(&found)));
            let found = pool.install(|| with_atomics(&statistics));
            answers.close(&format!("{name}, with atomics"), &soft::numbers(found));
            let found = pool.install(|| in_order(&parts));
            answers.exact(&format!("{name}, in order"), &soft::numbers(of(&found)));
        }
    }
    for threads in [2, 3] {
        let parts = vec![Visitor; 1000];
        MEETING.begin(threads);
        pool(threads).install(|| under_a_lock(&parts));
        let question = format!("threads of a pool of {threads} that add parts, under a lock");
        answers.exact(&question, &came(threads));
        MEETING.begin(threads);
        pool(threads).install(|| in_order(&parts));
        let question = format!("threads of a pool of {threads} that sum blocks, in order");
        answers.exact(&question, &came(threads));
    }
    let found = pool(4).install(|| under_a_lock(&vec![Slow(1); 100]));
    answers.exact("100 parts of one under a lock, with slow additions", &[found.0 as f64]);
    for times in [1, 3, 40] {
        let question =
            format!("the sum added twice while another thread comes between {times} times");
        answers.close(&question, &[interrupted(times).davg]);
    }
    let question = "dmin, davg, navg, pairs added twice while another thread comes between";
    answers.close(question, &soft::numbers(interrupted(1)));
}

/// Filled bins, one cutoff wide or more, at least eight rows of them.
fn bins(random: &mut Random) -> VecBins {
    let scene = soft::spread(random, 150, 9.5 * CUTOFF, 1.0);
    let mut bins = VecBins::of_scene(&scene, 1.0);
    bins.refill(scene.particles());
    bins
}

/// Rows that a thread may own: all, none, the first, the last, some.
fn parts(rows: usize) -> [Range<usize>; 5] {
    [0..rows, 4..4, 0..1, rows - 2..rows, 2..5]
}

fn forces(random: &mut Random, answers: &mut Answers) {
    for round in 0..6 {
        let (now, later) = (bins(random), bins(random));
        for rows in parts(now.grid().rows()) {
            let mut worker = Worker::<Tally>::new(rows.clone());
            for (step, bins) in [&now, &later].into_iter().enumerate() {
                worker.sum_forces(bins);
                let name = format!("scene {round}, rows {rows:?}, step {}", step + 1);
                let forces: Vec<f64> =
                    worker.accelerations.iter().flat_map(|a| [a.x, a.y]).collect();
                answers.exact(&format!("{name}: the forces on its particles"), &forces);
                let of_rows: Vec<f64> = worker
                    .seen
                    .iter()
                    .map(|seen| seen.statistics().expect("a tally has statistics"))
                    .flat_map(|seen| [seen.davg, seen.navg as f64])
                    .collect();
                answers.close(&format!("{name}: davg, navg of each row"), &of_rows);
            }
        }
    }
}

/// id x y vx vy of particles, in the order of ids.
fn states<'a>(particles: impl Iterator<Item = &'a Particle>) -> Vec<f64> {
    let mut all: Vec<Particle> = particles.copied().collect();
    all.sort_by_key(|p| p.id);
    all.iter().flat_map(|p| [f64::from(p.id), p.x, p.y, p.vx, p.vy]).collect()
}

fn moves(random: &mut Random, answers: &mut Answers) {
    for round in 0..20 {
        let mut bins = bins(random);
        let grid = *bins.grid();
        let columns = grid.columns();
        for p in bins.bins_mut().iter_mut().flatten() {
            (p.vx, p.vy) = (random.between(-15.0, 15.0), random.between(-15.0, 15.0));
        }
        for rows in parts(grid.rows()) {
            let mut worker = Worker::<NoStatistics>::new(rows.clone());
            worker.changed.push(Particle { id: 7777, ..Particle::default() });
            let own = &mut bins.bins_mut()[rows.start * columns..rows.end * columns];
            let mut push = || random.between(-9.0, 9.0);
            worker.accelerations =
                own.iter().flatten().map(|_| Vec2::new(push(), push())).collect();
            worker.move_particles(&grid, own);
            let name = format!("scene {round}, rows {rows:?}");
            answers.exact(
                &format!("{name}: bin and id of particles that stayed"),
                &soft::residents(own),
            );
            let stayed = states(own.iter().flatten());
            answers.exact(&format!("{name}: id x y vx vy of particles that stayed"), &stayed);
            let left = states(worker.changed.iter());
            answers.exact(&format!("{name}: id x y vx vy in the change buffer"), &left);
        }
    }
}

fn loops(random: &mut Random, answers: &mut Answers) {
    fn workers<O: Observer>(bins: &VecBins, count: usize) -> Vec<Box<Worker<O>>> {
        let rows = bins.grid().rows();
        let cut = |worker| worker * rows / count;
        (0..count).map(|k| Box::new(Worker::new(cut(k)..cut(k + 1)))).collect()
    }
    for threads in [1, 3, 12] {
        let mut bins = bins(random);
        for p in bins.bins_mut().iter_mut().flatten() {
            (p.vx, p.vy) = (random.between(-15.0, 15.0), random.between(-15.0, 15.0));
        }
        let mut workers = workers::<NoStatistics>(&bins, threads);
        pool(threads).install(|| sum_and_move(&mut workers, &mut bins));
        let name = format!("{threads} workers");
        let stayed = states(bins.particles());
        answers.exact(&format!("{name}: id x y vx vy of particles in bins"), &stayed);
        let left = states(workers.iter().flat_map(|worker| &worker.changed));
        answers.exact(&format!("{name}: id x y vx vy in the change buffers"), &left);
    }
    for threads in [2, 5] {
        let mut bins = bins(random);
        let mut visitors = workers::<Visitor>(&bins, threads);
        MEETING.begin(threads);
        pool(threads).install(|| sum_and_move(&mut visitors, &mut bins));
        let question = format!("threads of a pool of {threads} that sum forces, at the same time");
        answers.exact(&question, &came(threads));
        let mut workers: Vec<Moved> =
            workers(&bins, threads).into_iter().map(|worker| Moved(*worker)).collect();
        MEETING.begin(threads);
        pool(threads).install(|| sum_and_move(&mut workers, &mut bins));
        let question = format!("threads of a pool of {threads} that move, at the same time");
        answers.exact(&question, &came(threads));
    }
}

fn mail(random: &mut Random, answers: &mut Answers) {
    const ALONG: usize = 6;
    let grid = Grid::with_bins_along(1.0, ALONG);
    for round in 0..40 {
        let rows = [0..2, 2..5, 5..6][round % 3].clone();
        let number = round % 3;
        let mut id = 0;
        let mut resident = || {
            id += 1;
            let (lower, upper) = (rows.start as f64 + 0.05, rows.end as f64 - 0.05);
            let y = random.between(lower, upper) / ALONG as f64;
            Particle { x: random.between(0.0, 1.0), y, id, ..Particle::default() }
        };
        let mut bins = SortedBins::new(grid, rows.clone());
        bins.refill((0..20).map(|_| resident()));
        let mail: Vec<Vec<parking_lot::Mutex<Vec<Particle>>>> = (0..11)
            .map(|from| {
                let letters = (0..3).map(|to| {
                    // In the last rounds no mail at all: the member's own particles have moved.
                    let count = if from == to || round > 30 { 0 } else { from + 2 };
                    (0..count).map(|_| resident()).collect::<Vec<_>>()
                });
                letters.map(parking_lot::Mutex::new).collect()
            })
            .collect();
        bins.particles_mut().iter_mut().for_each(|p| p.x = random.between(0.0, 1.0));
        take_posted(&mut bins, number, &mail);
        let name = format!("round {round}, member {number} with rows {rows:?}");
        for (row, column) in rows.flat_map(|row| (0..ALONG).map(move |column| (row, column))) {
            let inside = states(bins.bin(row, column).iter());
            answers.exact(&format!("{name}: particles in row {row}, column {column}"), &inside);
        }
        let left: Vec<f64> = mail.iter().flatten().map(|box_| box_.lock().len() as f64).collect();
        answers.exact(&format!("{name}: letters left in each box"), &left);
    }
}

fn barriers(answers: &mut Answers) {
    let (barrier, steps) = (Barrier::new(1), 1000);
    take_steps(steps, |_| (), &barrier);
    let more = barrier.meetings().saturating_sub(3 * steps);
    answers.exact("barriers in 1000 steps of one member, beyond 3000", &[more as f64]);
    let found = rehearse(8);
    let question = "how often the others do not wait at the barrier for a member held back";
    answers.exact(question, &[found.alone as f64]);
    for (turn, before) in found.before.iter().enumerate() {
        let part = ["forces", "moves", "arrivals"][turn % 3];
        let name = format!("step {}, {part}", turn / 3 + 1);
        let counts = [found.begun[turn] as f64, found.ended[turn] as f64];
        answers.exact(&format!("{name}: how many of 3 members began and ended it"), &counts);
        let question =
            format!("{name}: as members 0, 1, 2 begin, so many have ended the part before");
        answers.exact(&question, &before.map(|count| count as f64));
    }
}

fn threads(answers: &mut Answers) {
    for threads in [1, 2, 5, 11] {
        let Gathering { most, ended, numbers, different } = gather(threads);
        let told = [most, ended, different].map(|count| count as f64);
        let question = format!(
            "{threads} threads: at the same time, ended when it returned, and different ones"
        );
        answers.exact(&question, &told);
        let numbers: Vec<f64> = numbers.into_iter().map(|number| number as f64).collect();
        answers.exact(&format!("{threads} threads: their numbers"), &numbers);
    }
    let work = |number| {
        if number == 1 {
            resume_unwind(Box::new(17_u8));
        }
    };
    let ended = catch_unwind(AssertUnwindSafe(|| on_threads(3, work)));
    let told = ended.map_or_else(|panic| panic.downcast_ref::<u8>().map_or(1, |n| *n), |()| 0);
    answers.exact("a panic in one of 3 threads: 17 if it comes out as it was", &[f64::from(told)]);
}
