//! What is asked about lab 3: each function of a thread, with what the others would have done made
//! by the probe.

use std::ops::Range;
use std::sync::Mutex;
use std::thread;
use std::time::Duration;

use common::Vec2;
use common::soft::{CUTOFF, NoStatistics, Observer, Particle, Scene};
use lab3::{
    Barrier, Desk, Part, VARIANTS, one_step, own_rows, rebin_by_one, take_arrivals, take_posted,
};
use solution1::Tally;
use solution2::{Grid, SortedBins, VecBins};

use self::soft::Engine;
use crate::{Answers, Random};

#[path = "soft.rs"]
mod soft;

/// Asks everything about a task.
pub fn ask(task: &str, random: &mut Random, answers: &mut Answers) {
    match task {
        "3.1" => all_pairs(random, answers),
        "3.2" => cuts(answers),
        "3.3" => forces(random, answers),
        "3.4" => moves(random, answers),
        "3.5" => by_one(random, answers),
        "3.6" => by_all(random, answers),
        "3.7" => mail(random, answers),
        "3.8" => barriers(answers),
        _ => panic!("there is no task {task}"),
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
            let question = format!("dmin, davg, navg of 300 particles on {threads} threads");
            answers.close(&question, &seen[..3]);
        }
    }
}

fn cuts(answers: &mut Answers) {
    for workers in 1..=16 {
        for rows in [1, 2, 3, 7, 10, 15, 40, 64, 101] {
            let cuts: Vec<f64> = (0..workers)
                .map(|worker| own_rows(worker, workers, rows))
                .flat_map(|own| [own.start as f64, own.end as f64])
                .collect();
            let question = format!("the rows of each of {workers} workers, {rows} rows in all");
            answers.exact(&question, &cuts);
        }
    }
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
            let mut desk = Desk::<Tally>::new(rows.clone());
            for (step, bins) in [&now, &later].into_iter().enumerate() {
                desk.sum_forces(bins);
                let name = format!("scene {round}, rows {rows:?}, step {}", step + 1);
                let forces: Vec<f64> = desk.accelerations.iter().flat_map(|a| [a.x, a.y]).collect();
                answers.exact(&format!("{name}: the forces on its particles"), &forces);
                answers.exact(&format!("{name}: its observers"), &[desk.seen.len() as f64]);
                let mut all = Tally::default();
                desk.seen.iter().for_each(|seen| all.merge(seen));
                let seen = all.statistics().expect("a tally has statistics");
                answers.close(&format!("{name}: davg, navg"), &[seen.davg, seen.navg as f64]);
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
            let mut desk = Desk::<NoStatistics>::new(rows.clone());
            desk.changed.push(Particle { id: 7777, ..Particle::default() });
            let own = &mut bins.bins_mut()[rows.start * columns..rows.end * columns];
            let mut push = || random.between(-9.0, 9.0);
            desk.accelerations = own.iter().flatten().map(|_| Vec2::new(push(), push())).collect();
            desk.move_particles(&grid, own);
            let name = format!("scene {round}, rows {rows:?}");
            answers.exact(&format!("{name}: bin and id of who stayed"), &soft::residents(own));
            let stayed = states(own.iter().flatten());
            answers.exact(&format!("{name}: id x y vx vy of who stayed"), &stayed);
            let left = states(desk.changed.iter());
            answers.exact(&format!("{name}: id x y vx vy in the change buffer"), &left);
        }
    }
}

/// Particles cut into the change buffers of four threads, one of them empty.
fn buffers(scene: &Scene, random: &mut Random) -> [Vec<Particle>; 4] {
    let mut all = scene.particles().to_vec();
    soft::shuffle(random, &mut all);
    let (a, rest) = all.split_at(random.below(all.len()));
    let (b, c) = rest.split_at(random.below(rest.len() + 1));
    [a.to_vec(), Vec::new(), b.to_vec(), c.to_vec()]
}

fn by_one(random: &mut Random, answers: &mut Answers) {
    for round in 0..30 {
        let scene = soft::crowd(random, 120, 9.5 * CUTOFF, 0.0);
        let buffers = buffers(&scene, random);
        let mut bins = VecBins::of_scene(&scene, 1.0);
        let resident = Particle { id: 999, ..scene.particles()[0] };
        bins.put(resident);
        rebin_by_one(&mut bins, buffers.iter().map(Vec::as_slice));
        let question = format!("round {round}: bin and id of 999, who was there, and 120 leavers");
        answers.exact(&question, &soft::residents(bins.bins()));
    }
}

fn by_all(random: &mut Random, answers: &mut Answers) {
    for round in 0..30 {
        let scene = soft::crowd(random, 120, 9.5 * CUTOFF, 0.0);
        let buffers = buffers(&scene, random);
        let grid = Grid::of_scene(&scene, 1.0);
        let columns = grid.columns();
        for rows in parts(grid.rows()) {
            let mut own = vec![Vec::new(); rows.len() * columns];
            if let Some(bin) = own.first_mut() {
                bin.push(Particle { id: 999, ..Particle::default() });
            }
            let buffers = buffers.iter().map(Vec::as_slice);
            take_arrivals(&grid, rows.start * columns, &mut own, buffers);
            let question = format!("round {round}, rows {rows:?}: bin and id of who is there now");
            answers.exact(&question, &soft::residents(&own));
        }
    }
}

fn mail(random: &mut Random, answers: &mut Answers) {
    const ALONG: usize = 6;
    let grid = Grid::with_bins_along(1.0, ALONG);
    for round in 0..40 {
        let rows = [0..2, 2..5, 5..6][round % 3].clone();
        let number = round % 3;
        let mut id = 0;
        let mut somebody = || {
            id += 1;
            let (lower, upper) = (rows.start as f64 + 0.05, rows.end as f64 - 0.05);
            let y = random.between(lower, upper) / ALONG as f64;
            Particle { x: random.between(0.0, 1.0), y, id, ..Particle::default() }
        };
        let mut bins = SortedBins::new(grid, rows.clone());
        bins.refill((0..20).map(|_| somebody()));
        let mail: Vec<Vec<parking_lot::Mutex<Vec<Particle>>>> = (0..4)
            .map(|from| {
                let letters = (0..3).map(|to| {
                    let count = if from == to { 0 } else { from + 2 };
                    (0..count).map(|_| somebody()).collect::<Vec<_>>()
                });
                letters.map(parking_lot::Mutex::new).collect()
            })
            .collect();
        take_posted(&mut bins, number, &mail);
        let name = format!("round {round}, member {number} with rows {rows:?}");
        for (row, column) in rows.flat_map(|row| (0..ALONG).map(move |column| (row, column))) {
            let inside = states(bins.bin(row, column).iter());
            answers.exact(&format!("{name}: who is in row {row}, column {column}"), &inside);
        }
        let left: Vec<f64> = mail.iter().flatten().map(|box_| box_.lock().len() as f64).collect();
        answers.exact(&format!("{name}: letters left in each box"), &left);
    }
}

/// Three members note what they begin and end, and dawdle in between, each in its own way. Told is
/// how many have ended the part before, whenever somebody begins one.
fn barriers(answers: &mut Answers) {
    const STEPS: usize = 8;
    const TURNS: usize = 3 * STEPS;
    let barrier = Barrier::new(3);
    let notes = Mutex::new(([0; TURNS], [[usize::MAX; 3]; TURNS], [0; TURNS]));
    thread::scope(|scope| {
        for member in 0..3 {
            let (barrier, notes) = (&barrier, &notes);
            scope.spawn(move || {
                let _membership = barrier.membership();
                for step in 0..STEPS {
                    let part = |part: Part| {
                        let turn = 3 * step + part as usize;
                        {
                            let (ended, before, begun) = &mut *notes.lock().expect("no panic");
                            begun[turn] += 1;
                            before[turn][member] = turn.checked_sub(1).map_or(3, |t| ended[t]);
                        }
                        thread::sleep(Duration::from_millis(6 * ((member + turn) % 3) as u64));
                        notes.lock().expect("no panic").0[turn] += 1;
                    };
                    one_step(part, barrier);
                }
            });
        }
    });
    let (ended, before, begun) = notes.into_inner().expect("no panic");
    for turn in 0..TURNS {
        let part = ["forces", "moves", "arrivals"][turn % 3];
        let name = format!("step {}, {part}", turn / 3 + 1);
        let counts = [begun[turn] as f64, ended[turn] as f64];
        answers.exact(&format!("{name}: how many of 3 members began and ended it"), &counts);
        let question =
            format!("{name}: as members 0, 1, 2 begin, so many have ended the part before");
        answers.exact(&question, &before[turn].map(|count| count as f64));
    }
}
