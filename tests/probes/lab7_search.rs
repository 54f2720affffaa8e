//! How lab 7 shares out pairs, orders candidates, and looks only where discs can meet.

use std::thread;

use common::hard::{Disc, RandomScene};
use lab7::{
    Candidate, Deque, Entry, SharedCount, Span, Square, Survey, Victim, Window,
    block_of, blocks_around, choose_windows, fixed_part, leave_halves, look_along, merge,
    next_part, partners, span, take_or_steal,
};

use super::interrupted::{between_critical_sections, between_load_and_store};
use super::{rivals, values};
use crate::{Answers, Random, cut};

/// One disc flies towards discs at rest, all of them ahead and none of them near: whether two
/// that recede or overlap collide is another task.
pub fn all_pairs(random: &mut Random, answers: &mut Answers) {
    for round in 0..60 {
        let runner = random.below(10);
        let disc = |k: usize| match k {
            _ if k == runner => Disc::new(0.0, 50.0, 30.0, random.between(-5.0, 5.0)),
            _ => Disc::new(random.between(8.0, 60.0), random.between(30.0, 70.0), 0.0, 0.0),
        };
        let discs: Vec<Disc> = (0..60).map(disc).collect();
        let (from, to) = (runner + 1 + random.below(10), 40 + random.below(21));
        let mut list = Vec::new();
        for partners in [from..to, to..60, to..to] {
            look_along(&discs, runner, partners, 1.0, &mut list);
        }
        list.sort_by_key(|c: &Candidate| c.hit);
        let question =
            format!("round {round}: time and numbers of discs {from} to 59 hit by {runner}");
        answers.close(&question, &values(&list));
    }
}

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
    for (when, parts) in [
        ("between load and store", between_load_and_store()),
        ("when the lock is free", between_critical_sections()),
    ] {
        let mut times = [0.0; 100];
        parts.into_iter().flatten().for_each(|k| times[k] += 1.0);
        let question = format!("how often each of 100 is handed out if another comes {when}");
        answers.exact(&question, &times);
    }
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

/// Parts that a worker takes or steals, and what it leaves for thieves.
pub fn stealing(random: &mut Random, answers: &mut Answers) {
    for round in 0..60 {
        let deque = |first: usize, count: usize| {
            let deque = Deque::new_lifo();
            (0..count).for_each(|k| deque.push(first + k..first + k + 1));
            deque
        };
        let deques: Vec<Deque> = (0..4).map(|k| deque(100 * k, random.below(4))).collect();
        let crowded = |deque| Victim::crowded(deque, random.below(3));
        let others: Vec<Victim> = deques[1..].iter().map(crowded).collect();
        // Which of the victims is crowded decides the order; all parts must come, the own first.
        let taken = std::iter::from_fn(|| take_or_steal(&deques[0], &others)).take(20);
        let mut starts: Vec<f64> = taken.map(|part| part.start as f64).collect();
        let own = starts.iter().take_while(|start| **start < 100.0).count();
        starts[own..].sort_by(f64::total_cmp);
        answers.exact(&format!("round {round}: the parts taken, then those stolen"), &starts);
    }
    for round in 0..60 {
        let (start, length, least) =
            (random.below(50), 1 + random.below(300), 1 + random.below(20));
        let own = Deque::new_lifo();
        let kept = leave_halves(start..start + length, least, &own);
        let parts = [kept].into_iter().chain(std::iter::from_fn(|| own.pop())).take(200);
        let ends: Vec<f64> = parts.flat_map(|part| [part.start as f64, part.end as f64]).collect();
        let question =
            format!("round {round}: {length} iterations from {start} halved down to {least}");
        answers.exact(&question, &ends);
    }
}

pub fn merges(random: &mut Random, answers: &mut Answers) {
    for lists in 0..9 {
        for round in 0..8 {
            let mut parts = vec![Vec::new(); lists];
            for candidate in rivals(random, 50).into_iter().filter(|_| lists > 0) {
                parts[random.below(lists)].push(candidate);
            }
            let merged = merge(&parts);
            let question = format!("round {round}: {lists} sorted lists of 50 in all, merged");
            answers.exact(&question, &values(&merged));
        }
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
