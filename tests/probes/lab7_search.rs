//! How lab 7 shares out pairs, orders candidates, and looks only where discs can meet.

use std::ops::Range;
use std::sync::Mutex;
use std::thread;

use common::hard::{Disc, RandomScene};
use hard_discs::{
    Candidate, Entry, Hit, LockedCount, Schedule, SharedCount, Slots, Span, Square, Survey, Team,
    Window,
};
use lab7::{
    append_atomic, append_locked, block_of, blocks_around, choose_windows, fixed_part, inner,
    nested, next_part, outer, partners, span,
};

use super::interrupted::{
    appended_between_critical_sections, appended_between_load_and_store, between_load_and_store,
};
use super::values;
use crate::{Answers, Random, cut};

/// Parts as a program may cut them: how they join, and how uneven they are.
pub fn schedules(random: &mut Random, answers: &mut Answers) {
    for n in [0, 1, 3, 10, 100 + random.below(1000)] {
        for workers in 1..=9 {
            let parts: Vec<_> = (0..workers).map(|w| fixed_part(n, workers, w)).collect();
            let question = format!(
                "{n} iterations, {workers} workers: begin, end, gaps between, and unevenness, at least 1"
            );
            answers.exact(&question, &cut(&parts));
        }
    }
    for (n, chunk) in [(10, 4), (0, 3), (100, 1), (7, 100), (64, 8)] {
        let next = SharedCount::default();
        let parts = std::iter::from_fn(|| next_part(&next, n, chunk)).take(200);
        let ends: Vec<f64> = parts.flat_map(|part| [part.start as f64, part.end as f64]).collect();
        answers.exact(&format!("the parts of {n} iterations in chunks of {chunk}"), &ends);
    }
    interrupted(answers);
    many_workers(random, answers);
}

/// How often each iteration is handed out when another worker comes between.
fn interrupted(answers: &mut Answers) {
    let mut times = [0.0; 100];
    between_load_and_store().into_iter().flatten().for_each(|k| times[k] += 1.0);
    let question = "how often each of 100 is handed out if another worker comes between";
    answers.exact(question, &times);
}

fn many_workers(random: &mut Random, answers: &mut Answers) {
    let n = 20_000 + random.below(1000);
    let next = SharedCount::default();
    let mut times = vec![0.0; n];
    thread::scope(|scope| {
        let work = || std::iter::from_fn(|| next_part(&next, n, 3)).take(n).collect::<Vec<_>>();
        let workers: Vec<_> = (0..4).map(|_| scope.spawn(work)).collect();
        for worker in workers {
            worker.join().expect("it ends").into_iter().flatten().for_each(|k| times[k] += 1.0);
        }
    });
    let wrong = times.iter().filter(|times| **times != 1.0).count();
    let question = format!("of {n} iterations for four workers, lost or handed out twice");
    answers.exact(&question, &[wrong as f64]);
}

/// Which list each pair comes into, if both loops are cut into fixed parts.
pub fn loops(random: &mut Random, answers: &mut Answers) {
    type Share = fn(usize, Team, &(dyn Fn(usize, usize, Range<usize>) + Sync));
    let shares: [(&str, Share); 3] = [
        ("outer", |n, team, look| outer(n, team, Schedule::Static, look)),
        ("inner", |n, team, look| inner(n, team, Schedule::Static, look)),
        ("both", |n, team, look| nested(n, team, Schedule::Static, look)),
    ];
    for (which, share) in shares {
        for workers in 1..=5 {
            let n = 1 + random.below(30);
            let looks = Mutex::new(Vec::new());
            share(n, Team::Fresh(workers), &|list, a, partners| {
                let pairs = partners.take(100).map(|b| [a as f64, b as f64, list as f64]);
                looks.lock().expect("no thread panics here").extend(pairs);
            });
            let mut looks = looks.into_inner().expect("as above");
            looks.sort_by(|a, b| a.partial_cmp(b).expect("they are numbers"));
            let question = format!("{which}, {n} discs, {workers} workers: disc, partner, list");
            answers.exact(&question, looks.as_flattened());
        }
    }
}

/// What a list holds that is appended to, by one worker and by two.
pub fn appended(answers: &mut Answers) {
    let (list, locked, atomic) = (Slots::default(), LockedCount::default(), SharedCount::default());
    let candidates =
        (0..5000).map(|k| Candidate { time: f64::from(k) / 5000.0, hit: Hit::Pair(k, k + 1) });
    candidates.clone().for_each(|candidate| append_locked(&list, &locked, candidate));
    let held: Vec<_> = list.first(locked.locked(|count| *count).min(6000)).collect();
    answers.exact("5000 candidates appended under a lock", &values(&held));
    let list = Slots::default();
    candidates.for_each(|candidate| append_atomic(&list, &atomic, candidate));
    let held: Vec<_> = list.first(atomic.load().min(6000)).collect();
    answers.exact("5000 candidates appended without a lock", &values(&held));
    for (when, discs) in [
        ("when the lock is free", appended_between_critical_sections()),
        ("between two operations", appended_between_load_and_store()),
    ] {
        let discs: Vec<_> = discs.into_iter().map(f64::from).collect();
        answers.exact(&format!("discs 1 and 2 appended, 3 by another worker {when}"), &discs);
    }
}

pub fn boxes(random: &mut Random, answers: &mut Answers) {
    for case in 0..300 {
        let count = [1, 2, 3, 8, 64][case % 5];
        let window = Window::part(random.below(count), count);
        let (x, v) = (random.between(0.0, 10.0), random.between(-9.0, 9.0));
        let reach = random.between(0.1, 2.0);
        let found = span(x, v, window, reach);
        let question = format!(
            "low and high of the box of x = {x}, v = {v} from {} to {}, reach {reach}",
            window.from, window.to
        );
        answers.close(&question, &[found.low, found.high]);
    }
}

pub fn blocks(random: &mut Random, answers: &mut Answers) {
    let side = 16.0;
    for _ in 0..600 {
        let mut span = |wide: f64| {
            let (low, width) = (random.between(-2.0, 16.0), random.between(0.0, wide));
            Span { low, high: low + width }
        };
        let wide = [1.0, 4.0, 9.0];
        let (x, y) = (span(wide[0]), span(wide[0]));
        let (u, v) = (span(wide[1]), span(wide[2]));
        for (x, y) in [(x, y), (u, y), (x, v), (u, v)] {
            let question = format!("the block of {x:?} × {y:?} in a square of 16");
            answers.exact(&question, &[block_of(x, y, side) as f64]);
        }
    }
    for block in 0..=20 {
        let mut around: Vec<f64> = blocks_around(block).iter().map(|b| *b as f64).collect();
        around.sort_by(f64::total_cmp);
        answers.exact(&format!("the blocks around block {block}"), &around);
    }
}

pub fn meetings(random: &mut Random, answers: &mut Answers) {
    const COLUMNS: usize = 20;
    for round in 0..60 {
        let entry = |disc: u32| {
            let (row, column) = (random.below(4), random.below(COLUMNS));
            let further = random.below(5).min(COLUMNS - 1 - column) as u32;
            Entry::new((row * COLUMNS + column) as u64, further, disc, true)
        };
        let mut entries: Vec<Entry> = (0..60).map(entry).collect();
        entries.sort_by_key(|entry| entry.cell);
        let mut met = Vec::new();
        for (k, a) in entries.iter().enumerate() {
            let partners = partners(&entries, k);
            // Beyond the last entry nothing is met, and nothing can be looked up.
            for b in
                &entries[partners.start.min(60)..partners.end.clamp(partners.start.min(60), 60)]
            {
                met.push([a.disc().min(b.disc()), a.disc().max(b.disc())].map(f64::from));
            }
        }
        met.sort_by(|a, b| a.partial_cmp(b).expect("they are numbers"));
        let question = format!("round {round}: which two of 60 boxes share a row and a column");
        answers.exact(&question, met.as_flattened());
    }
}

pub fn windows(random: &mut Random, answers: &mut Answers) {
    let radius_one = [0.5, 3.0, 30.0, 200.0, 1000.0, 5000.0].map(|speed| (speed, 1.0));
    // Large discs are asked more often; small ones are worth more windows than there may be.
    let sizes = [(5000.0, 8.0), (5000.0, 64.0), (5000.0, 512.0), (5000.0, 0.001)];
    for (speed, radius) in radius_one.into_iter().chain(sizes) {
        for crowding in [1.0, random.between(2.0, 6.0), 1e12] {
            let seed = 1 + random.below(1_000_000) as u32;
            let scene = RandomScene::new(5000, 20_000.0, radius, seed);
            let scene = scene.with_speeds(speed / 2.0, speed);
            let scene = scene.draw().expect("the scene is sound");
            let square = Square::of(&scene);
            let windows = choose_windows(&Survey::of(scene.discs(), square), square, crowding);
            let question = format!(
                "the windows for 5000 discs of radius {radius} with speeds up to {speed}, crowding {crowding:.2}"
            );
            answers.exact(&question, &[windows as f64]);
        }
    }
}
