//! Lab 8 without a master: strips, ghosts, and deciding together.

use std::cmp::Ordering;
use std::collections::BTreeSet;

use common::hard::{Disc, Scene};
use hard_disc_ranks::{CandidateWire, Decisions, DiscWire, Reach, Strips};
use lab8::{ghosts_for, hear, looks_at, move_on, news_for, reached, take_certain};
use mpi::traits::Communicator;
use solution6::Cuts;
use solution7::{Candidate, Hit, Lab7, Square, order};

use super::given::tower;
use super::{discs, numbers, ranks, state, tell_run, values};
use crate::{Answers, Random, flags, truth};

/// Rows of height 2 from y = 10 on, cut at random into strips, one for each rank; and the top.
fn some_strips(random: &mut Random, ranks: usize) -> (Strips, f64) {
    let rows = 10;
    let starts = ranks::starts(random, ranks, rows);
    (Strips { bottom: 10.0, height: 2.0, cuts: Cuts { starts } }, 30.0)
}

fn disc(random: &mut Random, number: u64, top: f64, speed: f64) -> DiscWire {
    let (y, vy) = (random.between(9.0, top + 1.0), random.between(-speed, speed));
    DiscWire { x: 50.0, y, vx: 3.0, vy, number, ..DiscWire::default() }
}

pub fn reaches(random: &mut Random, answers: &mut Answers) {
    for _ in 0..300 {
        let ranks = 1 + random.below(6);
        let (strips, top) = some_strips(random, ranks);
        let speed = [1.0, 5.0, 30.0][random.below(3)];
        let disc = disc(random, 0, top, speed);
        let reach = random.between(0.2, 2.0);
        let found = reached(&strips, &disc, reach);
        let question = format!(
            "first and last rank that a disc at y = {} with vy = {}, {reach} wide, reaches; strips \
             of rows of 2 from 10 on, cut at {:?}",
            disc.y, disc.vy, strips.cuts.starts
        );
        answers.exact(&question, &numbers([found.first, found.last]));
    }
    let all = || (0..5).flat_map(|first| (first..5).map(move |last| Reach { first, last }));
    for (a, b) in all().flat_map(|a| all().map(move |b| (a, b))) {
        // A rank that has only one of the two is never asked.
        let both = (0..5).filter(|&rank| a.contains(rank) && b.contains(rank));
        let looking = both.filter(|&rank| looks_at(rank, a, b));
        let question = format!("which rank looks at a pair that reaches {a:?} and {b:?}");
        answers.exact(&question, &numbers(looking));
    }
}

pub fn ghosts(random: &mut Random, answers: &mut Answers) {
    for round in 0..60 {
        let ranks = 2 + random.below(5);
        let (strips, top) = some_strips(random, ranks);
        let rank = random.below(ranks);
        let own: Vec<DiscWire> = (0..30).map(|k| disc(random, 3 * k, top, 6.0)).collect();
        let partners: Vec<usize> = (0..ranks).filter(|other| *other != rank).collect();
        let lists = ghosts_for(&partners, &own, &strips, 0.7);
        for (partner, list) in partners.iter().zip(&lists) {
            let list: Vec<f64> = list.iter().flat_map(|d| [d.number as f64, d.y, d.vy]).collect();
            let question = format!(
                "round {round}: number, y, vy of the ghosts of rank {rank} for {partner} of {ranks}"
            );
            answers.exact(&question, &list);
        }
    }
}

/// What rank 1 of three may know in the middle of deciding.
fn decisions(random: &mut Random) -> Decisions {
    let (mut numbers, mut reach) = (Vec::new(), Vec::new());
    for number in 0..30 {
        if random.below(4) > 0 {
            numbers.push(2 * number + random.below(2) as u32);
            let (first, last) = [(1, 1), (0, 1), (1, 2), (0, 2), (1, 1)][random.below(5)];
            reach.push(Reach { first, last });
        }
    }
    let found = candidates(random, &numbers, 40);
    let mut decisions = Decisions::default();
    decisions.start::<Lab7>(&numbers, &reach, &found);
    decisions
}

/// Candidates among these discs, no two of the same discs, many of them at exactly the same time.
fn candidates(random: &mut Random, numbers: &[u32], count: usize) -> Vec<Candidate> {
    let mut hits = BTreeSet::new();
    for _ in 0..count {
        let (a, b) = (numbers[random.below(numbers.len())], numbers[random.below(numbers.len())]);
        hits.insert(if a == b { Hit::WallX(a) } else { Hit::Pair(a.min(b), a.max(b)) });
    }
    let mut all: Vec<Candidate> =
        hits.into_iter().map(|hit| Candidate { time: random.below(8) as f64 / 8.0, hit }).collect();
    random.shuffle(&mut all);
    all
}

/// What other ranks have told of a disc: another candidate of it, or that they have none.
fn rival(random: &mut Random, number: u32) -> Option<Candidate> {
    let other = random.below(70) as u32;
    let hit = match other.cmp(&number) {
        Ordering::Less => Hit::Pair(other, number),
        Ordering::Equal => Hit::WallY(number),
        Ordering::Greater => Hit::Pair(number, other),
    };
    let time = random.below(8) as f64 / 8.0;
    Some(Candidate { time, hit }).filter(|_| random.below(3) > 0)
}

/// In two rounds, as candidates come in two windows; in the second other ranks know of less.
pub fn certain(random: &mut Random, answers: &mut Answers) {
    for round in 0..120 {
        let mut decisions = decisions(random);
        for slot in 0..decisions.numbers.len() {
            if decisions.reach[slot].is_shared() && random.below(4) > 0 {
                decisions.rivals[slot] = rival(random, decisions.numbers[slot]);
            }
            decisions.free[slot] = random.below(10) > 0;
        }
        tell_certain(answers, &format!("decisions {round}"), &mut decisions);
        let mut late = candidates(random, &decisions.numbers, 10);
        late.iter_mut().for_each(|candidate| candidate.time += 1.0);
        decisions
            .queues
            .enter::<Lab7>(late.iter().map(|candidate| decisions.local(candidate)).collect());
        for slot in 0..decisions.numbers.len() {
            if random.below(2) > 0 {
                decisions.rivals[slot] = None;
            }
        }
        tell_certain(answers, &format!("decisions {round} after news"), &mut decisions);
    }
}

/// Tells what becomes certain. The order in which that is found out does not matter.
fn tell_certain(answers: &mut Answers, name: &str, decisions: &mut Decisions) {
    take_certain(decisions);
    let sorted = |list: &[Candidate]| {
        let mut list = list.to_vec();
        list.sort_by(order);
        values(&list)
    };
    answers.exact(&format!("{name}: what is taken"), &sorted(&decisions.taken));
    answers.exact(&format!("{name}: the front"), &sorted(&decisions.front));
    answers.exact(&format!("{name}: which discs are free"), &flags(&decisions.free));
    answers.exact(&format!("{name}: which discs wait"), &flags(&decisions.waits));
}

pub fn news(random: &mut Random, answers: &mut Answers) {
    for round in 0..80 {
        let mut decisions = decisions(random);
        // Not all that are in a queue are open and the earliest of a disc.
        let all: Vec<_> =
            decisions.queues.all().iter().map(|local| decisions.named(local)).collect();
        let (taken, open) = all.split_at(all.len() / 2);
        decisions.taken = taken.to_vec();
        decisions.front = open.iter().copied().filter(|_| random.below(3) > 0).collect();
        decisions.told = random.below(decisions.taken.len() + 1);
        for partner in [0, 2] {
            let told = news_for(&decisions, partner);
            let told: Vec<f64> = told
                .iter()
                .flat_map(|wire| {
                    let mut told = values(&[wire.into()]);
                    told.push(truth(wire.is_taken()));
                    told
                })
                .collect();
            let question = format!(
                "round {round}: time, kind, discs, whether taken, of the news for rank {partner}"
            );
            answers.exact(&question, &told);
        }
        for hearing in 0..2 {
            let numbers: Vec<u32> = (0..62).collect();
            let news: Vec<CandidateWire> = candidates(random, &numbers, 40)
                .iter()
                .map(|c| if random.below(3) == 0 { CandidateWire::taken(c) } else { c.into() })
                .collect();
            hear(&mut decisions, &news);
            let rivals: Vec<f64> = decisions
                .rivals
                .iter()
                .flat_map(|rival| rival.map_or(vec![-1.0; 4], |rival| values(&[rival])))
                .collect();
            let question = format!("round {round}, news {hearing}: the rival of each disc");
            answers.exact(&question, &rivals);
            let question = format!("round {round}, news {hearing}: which discs are free");
            answers.exact(&question, &flags(&decisions.free));
        }
    }
}

pub fn moves(random: &mut Random, answers: &mut Answers) {
    let square = Square { side: 400.0, radius: 1.0 };
    for round in 0..60 {
        let mut decisions = decisions(random);
        let count = decisions.numbers.len();
        let mut owns = vec![false; count];
        let mut all = Vec::new();
        for slot in 0..count {
            // Two and two stand side by side, and may collide.
            let x = 20.0 + 12.0 * (slot / 2) as f64 + if slot % 2 == 0 { 0.0 } else { 4.0 };
            let vx = if slot % 2 == 0 { 2.5 } else { -2.5 };
            all.push(Disc::new(x, 50.0 + random.between(-0.3, 0.3), vx, random.between(-1.0, 1.0)));
            owns[slot] = !decisions.reach[slot].is_shared() || random.below(2) == 0;
        }
        for slot in (0..count - 1).step_by(2) {
            match random.below(3) {
                0 => {
                    let hit = Hit::Pair(decisions.numbers[slot], decisions.numbers[slot + 1]);
                    decisions.taken.push(Candidate { time: 0.4, hit });
                    decisions.free[slot] = false;
                    decisions.free[slot + 1] = false;
                }
                1 => decisions.free[slot] = false,
                _ => {}
            }
        }
        let moved = move_on(&mut all, &owns, &decisions, square);
        let moved: Vec<f64> = moved
            .iter()
            .flat_map(|wire| [&[wire.number as f64][..], &state(&wire.into())].concat())
            .collect();
        let question =
            format!("round {round}: number x y vx vy and collisions of the discs moved here");
        answers.exact(&question, &moved);
    }
}

/// A shot through all strips, which hits a disc in the last.
fn shot(random: &mut Random) -> Scene {
    let mut discs = vec![
        Disc::new(50.0, 5.0, 0.0, 85.0),
        Disc::new(50.0 + random.between(-0.5, 0.5), 85.0, 0.0, 0.0),
    ];
    for k in 0..36 {
        let (column, row) = (f64::from(k % 4), f64::from(k / 4));
        let x = if column < 2.0 { 10.0 + 15.0 * column } else { 45.0 + 15.0 * column };
        let mut slow = || random.between(-1.0, 1.0);
        discs.push(Disc::new(x, 10.0 + 10.0 * row, slow(), slow()));
    }
    Scene::new(100.0, 1.0, discs).expect("all are inside")
}

/// Whole steps, which take all tasks from 8.8 on.
pub fn steps(random: &mut Random, answers: &mut Answers) {
    ranks::each(&[1, 2, 4], |world| {
        let scenes = [
            ("a tower", tower(random.between(7.0, 9.0))),
            ("a shot through all strips", shot(random)),
            ("60 discs", discs(random, 60, 0.4)),
            ("90 discs", discs(random, 90, 0.2)),
        ];
        tell_run(world, answers, "spatial-cuts", &[], &scenes);
        if world.size() == 4 {
            tell_run(world, answers, "spatial-cuts", &[("recut", 1.0)], &scenes);
        }
    });
}
