//! What is asked about lab 7: walls, pairs, the order of candidates, and a step of an engine. How pairs are
//! shared out and looked for is in `lab7_search.rs`.

use common::hard::Disc;
use hard_discs::{Candidate, Hit, Square};
use lab7::{bounce, collide, order, pair_time, stop_at_wall, take, take_in_order, wall_hit};

use self::hard::{state, values};
use crate::{Answers, Random, flags};

#[path = "hard.rs"]
mod hard;
#[path = "../lab7/interrupted.rs"]
mod interrupted;
#[path = "lab7_search.rs"]
mod search;
#[path = "lab7_step.rs"]
mod step;

const BOX: Square = Square { side: 10.0, radius: 1.0 };
const WIDE: Square = Square { side: 1000.0, radius: 1.0 };

/// Asks everything about a task.
pub fn ask(task: &str, random: &mut Random, answers: &mut Answers) {
    match task {
        "7.1" => walls(random, answers),
        "7.2" => pairs(random, answers),
        "7.3" => orders(random, answers),
        "7.4" => taken(random, answers),
        "7.5" => stops(random, answers),
        "7.6" => collisions(random, answers),
        "7.7" => step::steps(random, answers),
        "7.8" => search::schedules(random, answers),
        "7.9" => search::loops(random, answers),
        "7.10" => search::appended(answers),
        "7.11" => search::boxes(random, answers),
        "7.12" => search::blocks(random, answers),
        "7.13" => search::meetings(random, answers),
        "7.14" => search::windows(random, answers),
        _ => panic!("there is no task {task}"),
    }
}

fn words(disc: &Disc) -> String {
    format!("({:?}, {:?}) with velocity ({:?}, {:?})", disc.x, disc.y, disc.vx, disc.vy)
}

fn walls(random: &mut Random, answers: &mut Answers) {
    let mut ask = |disc: Disc| {
        let found = wall_hit(3, &disc, BOX);
        let question = format!("when disc 3 at {} hits which wall of a box of 10", words(&disc));
        answers.close(&question, &values(found.as_slice()));
    };
    for case in 0..400 {
        let speed = [3.0, 20.0][case % 2];
        let mut coordinate = || random.between(1.0, 9.0);
        let (x, y) = (coordinate(), coordinate());
        let mut velocity = || random.between(-speed, speed);
        ask(Disc::new(x, y, velocity(), velocity()));
    }
    // Corners, paths that end at a wall, discs at a wall or a hair beyond it.
    for (x, y, vx, vy) in [
        (5.0, 5.0, 8.0, -8.0),
        (3.0, 7.0, -4.0, 4.0),
        (5.0, 5.0, 4.0, 4.0),
        (1.0, 5.0, -1.0, 0.0),
        (1.0, 5.0, 1.0, 0.0),
        (1.0 - f64::EPSILON, 5.0, -2.0, 0.0),
        (5.0, 9.0 + 2e-15, 0.0, 3.0),
        (9.0_f64.next_up(), 5.0, -1e-17, 0.0),
        (5.0, 5.0, 8.0, 8.0 + 1e-12),
        (5.0, 5.0, 0.0, 0.0),
    ] {
        ask(Disc::new(x, y, vx, vy));
    }
}

fn pairs(random: &mut Random, answers: &mut Answers) {
    let mut ask = |a: Disc, b: Disc| {
        let found = pair_time(&a, &b, 1.0);
        let question = format!("when discs of radius 1 at {} and {} touch", words(&a), words(&b));
        answers.close(&question, found.as_slice());
    };
    for _ in 0..1500 {
        let mut number = |limit: f64| random.between(-limit, limit);
        let a = Disc::new(number(5.0), number(5.0), number(4.0), number(4.0));
        ask(a, Disc::new(number(5.0), number(5.0), number(4.0), number(4.0)));
    }
    // Exactly at the end of the step, just before it, in contact, at one position, side by side.
    for (x, y, vx, vy) in [
        (6.0, 0.0, -4.0, 0.0),
        (7.0, 0.0, -5.0, 0.0),
        (0.0, 10.0, 0.0, -8.0),
        (6.0, 0.0, -4.1, 0.0),
        (6.0, 2.0, -8.0, 0.0),
        (2.0, 0.0, -1.0, 0.0),
        (2.0, 0.0, 1.0, 0.0),
        (1.0, 0.0, 1.0, 0.0),
        (1.0, 0.0, -1.0, 0.0),
        (0.0, 0.0, 1.0, 0.0),
        (6.0, 0.0, 0.0, 0.0),
    ] {
        ask(Disc::new(5.0, 5.0, 1.0, 1.0), Disc::new(5.0 + x, 5.0 + y, 1.0 + vx, 1.0 + vy));
    }
    for _ in 0..20 {
        let speed = random.between(1.0, 5.0);
        for k in 10..25 {
            let gap = 0.5_f64.powi(k);
            let (a, b) = (Disc::new(0.0, 0.0, 0.0, 0.0), Disc::new(2.0 + gap, 0.0, -speed, 0.0));
            let time = pair_time(&a, &b, 1.0).map(|time| time * speed / gap);
            let question = format!(
                "a gap of 2^-{k}, closed at {speed}: the time, times the speed, by the gap"
            );
            answers.close(&question, time.as_slice());
        }
    }
}

fn orders(random: &mut Random, answers: &mut Answers) {
    let times = [0.0, -0.0, 1e-12, 0.25, 0.25 + 1e-13, random.between(0.3, 0.9), 1.0];
    let mut all = Vec::new();
    for time in times {
        for _ in 0..3 {
            let (a, b) = (random.below(5) as u32, 5 + random.below(5) as u32);
            all.extend(
                [Hit::Corner(a), Hit::WallX(a), Hit::WallY(b), Hit::Pair(a, b)]
                    .map(|hit| Candidate { time, hit }),
            );
        }
    }
    for a in &all {
        let row: Vec<f64> = all.iter().map(|b| f64::from(order(a, b) as i8)).collect();
        let question =
            format!("whether {a:?} comes before (-1) or after (1) each of {}", all.len());
        answers.exact(&question, &row);
    }
}

/// Candidates among 40 discs. The one that comes first does so by time, by number and because walls come
/// before pairs: which of these counts is another task.
fn rivals(random: &mut Random, count: usize) -> Vec<Candidate> {
    let mut hits = std::collections::BTreeSet::new();
    while hits.len() < count {
        let (a, b) = (random.below(40) as u32, random.below(40) as u32);
        let (low, high) = (a.min(b), a.max(b));
        match low {
            0..=9 => _ = hits.insert(Hit::WallX(low)),
            _ if low < high => _ = hits.insert(Hit::Pair(low, high)),
            _ => {}
        }
        if low == 9 && high > 9 {
            hits.insert(Hit::Pair(low, high));
        }
    }
    let gap = 0.9 / hits.len() as f64;
    let candidates = hits.into_iter().enumerate();
    candidates
        .map(|(k, hit)| Candidate { time: (k as f64 + random.between(0.1, 0.9)) * gap, hit })
        .collect()
}

fn taken(random: &mut Random, answers: &mut Answers) {
    for round in 0..60 {
        let mut candidates = rivals(random, 60);
        let mut free: Vec<bool> = (0..40).map(|_| random.below(8) > 0).collect();
        let (mut each, mut one_by_one) = (free.clone(), Vec::new());
        for _ in 0..60 {
            let (a, b) = (random.below(40) as u32, random.below(40) as u32);
            let hit = if a == b { Hit::WallY(a) } else { Hit::Pair(a.min(b), a.max(b)) };
            take(&Candidate { time: 0.5, hit }, &mut each, &mut one_by_one);
        }
        answers.exact(&format!("round {round}: taken one by one"), &values(&one_by_one));
        answers.exact(&format!("round {round}: which discs are still free"), &flags(&each));
        random.shuffle(&mut candidates);
        let mut taken = Vec::new();
        take_in_order(&mut candidates, &mut free, &mut taken);
        answers.exact(&format!("round {round}: taken in order"), &values(&taken));
        answers.exact(&format!("round {round}: which discs are free after it"), &flags(&free));
    }
    for count in 1..=4 {
        // Each shares a disc with the one before it, which is later.
        let late = |k: u32| Candidate { time: 0.9 / f64::from(k + 1), hit: Hit::Pair(k, k + 1) };
        let mut candidates: Vec<_> = (0..count).map(late).collect();
        let mut taken = Vec::new();
        take_in_order(&mut candidates, &mut [true; 5], &mut taken);
        let question = format!("taken of {count} candidates, the last of which is the earliest");
        answers.exact(&question, &values(&taken));
    }
}

fn stops(random: &mut Random, answers: &mut Answers) {
    let mut ask = |disc: Disc| {
        let mut stopped = disc;
        stop_at_wall(&mut stopped, BOX);
        let question = format!("where a disc at {} waits in a box of 10", words(&disc));
        answers.close(&question, &state(&stopped));
    };
    for _ in 0..500 {
        // From inside, along its path, beyond a wall or not.
        let mut coordinate = || random.between(1.0, 9.0);
        let (x, y) = (coordinate(), coordinate());
        let mut speed = || random.between(-12.0, 12.0);
        let (vx, vy) = (speed(), speed());
        let part = random.between(0.0, 1.0);
        ask(Disc::new(x + part * vx, y + part * vy, vx, vy));
    }
    for (vx, vy) in [(0.0, 3.0), (-0.0, 3.0), (1e-30, 3.0), (0.0, 0.0)] {
        ask(Disc::new(9.0 + 2e-15, 5.0, vx, vy));
    }
    // More than one step away from the wall, and more than two.
    for x in [10.5, 11.0, 11.5] {
        ask(Disc::new(x, 6.0, 1.0, 2.0));
    }
}

/// A disc that ends beyond a wall flies straight at it: then it does not matter how it is brought back.
fn collisions(random: &mut Random, answers: &mut Answers) {
    for hit in [Hit::WallX(0), Hit::WallY(0), Hit::Corner(0)] {
        for _ in 0..40 {
            let (time, vx, vy) =
                (random.between(0.0, 1.0), random.between(-9.0, 9.0), random.between(-9.0, 9.0));
            let before = Disc::new(500.0, 500.0, vx, vy);
            let mut disc = before;
            bounce(&mut disc, time, hit, WIDE);
            let question = format!(
                "{hit:?} at λ = {time} of a disc at {}: x y vx vy and counts",
                words(&before)
            );
            answers.close(&question, &state(&disc));
        }
    }
    let mut fast = Disc::new(5.0, 5.0, 20.0, 0.0);
    bounce(&mut fast, 0.2, Hit::WallX(0), BOX);
    answers.close("a fast disc that crosses the whole box after its bounce", &state(&fast));
    for case in 0..300 {
        let mut number = |limit: f64| random.between(-limit, limit);
        let (ax, ay, bx, by) = (number(4.0), number(4.0), number(4.0), number(4.0));
        let (x, y) =
            if case % 3 == 0 { (number(1.0), number(1.0)) } else { (number(6.0), number(6.0)) };
        let time = if case % 3 == 0 { 0.0 } else { random.between(0.0, 1.0) };
        let mut a = Disc::new(500.0, 500.0, ax, ay);
        let mut b = Disc::new(500.0 + x, 500.0 + y, bx, by);
        let pair = format!("{} and {} touch at λ = {time}", words(&a), words(&b));
        collide(&mut a, &mut b, time, WIDE);
        // An exchange between discs nearly at one position may be large, so it is taken by its size.
        let scale = 1.0 + a.velocity().norm_squared().sqrt();
        let scaled = |d: &Disc| state(d).map(|v| v / scale);
        answers.close(&format!("{pair}: the first, by its speed"), &scaled(&a));
        answers.close(&format!("{pair}: the second, by the first's speed"), &scaled(&b));
    }
    let (mut a, mut b) = (Disc::new(5.0, 5.0, 1.0, 0.0), Disc::new(5.0, 5.0, -1.0, 0.0));
    collide(&mut a, &mut b, 0.0, BOX);
    answers.close("two discs at one position, the first", &state(&a));
    answers.close("two discs at one position, the second", &state(&b));
}
