//! The worked examples of ranks with strips.

use common::hard::{Disc, Scene, Simulation};
use common_mpi::Clock;
use hard_disc_ranks::{Decisions, DiscWire, Reach, SpatialCuts, Strips, UNKNOWN};
use lab8::{Lab8, ghosts_for, looks_at, move_on, reached, take_certain};
use oracle::{Ask, Random, Table, spaced};
use oracle_mpi::on_each;
use solution6::Cuts;
use solution7::{Candidate, Hit, Square};

use super::candidates::{Found, pair, sorted, words};

/// Returns three strips of height 10.
fn three_strips() -> Strips {
    Strips { bottom: 0.0, height: 10.0, cuts: Cuts { starts: vec![0, 1, 2, 3] } }
}

/// Returns discs at these heights with these velocities along y, numbered from 0.
fn flying(all: &[(f64, f64)]) -> Vec<DiscWire> {
    let disc = |(number, &(y, vy)): (usize, &(f64, f64))| {
        DiscWire::new(number, &Disc::new(5.0, y, 0.0, vy))
    };
    all.iter().enumerate().map(disc).collect()
}

/// Formats the extent along y of the box of a disc of radius 1.
fn box_of(disc: &DiscWire) -> String {
    let end = disc.y + disc.vy;
    format!("{} to {}", disc.y.min(end) - 1.0, disc.y.max(end) + 1.0)
}

pub(crate) fn table_of_boxes(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let discs =
            flying(&[(5.0, 2.0), (8.0, 3.0), (12.0, -3.0), (9.0, 0.0), (25.0, -17.0), (15.0, 0.0)]);
        let all: Vec<Reach> =
            discs.iter().map(|disc| reached(&three_strips(), disc, 1.0)).collect();
        let of = |reach: &Reach| spaced(reach.first..=reach.last);
        let mut boxes = Table::new(["disc", "y", "vy", "its box along y", "strips it reaches"]);
        for (disc, reach) in discs.iter().zip(&all) {
            boxes.row([&disc.number, &disc.y, &disc.vy, &box_of(disc), &of(reach)]);
        }
        let mut pairs = Table::new(["pair", "strips of the first", "of the second", "looks at it"]);
        for (a, b) in [(0, 1), (1, 2), (0, 4), (4, 5), (0, 5)] {
            let looks = (0..3).filter(|&rank| looks_at(rank, all[a], all[b]));
            let looks = looks.map(|rank| format!("rank {rank}"));
            pairs.row([&format!("{a}+{b}"), &of(&all[a]), &of(&all[b]), &spaced(looks)]);
        }
        format!("{boxes}\n{pairs}")
    });
}

pub(crate) fn table_of_ghosts(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let own = flying(&[(12.0, -3.0), (15.0, 2.0), (18.0, 4.0), (14.0, -14.0), (11.0, 12.0)]);
        let lists = ghosts_for(&[0, 2], &own, &three_strips(), 1.0);
        let mut table = Table::new([
            "disc of rank 1",
            "y",
            "vy",
            "its box along y",
            "copy for rank 0",
            "for rank 2",
        ]);
        for disc in &own {
            let in_list = |list: &Vec<DiscWire>| if list.contains(disc) { "yes" } else { "-" };
            let [low, high] = [0, 1].map(|k| lists.get(k).map_or("no list", in_list));
            table.row([&disc.number, &disc.y, &disc.vy, &box_of(disc), &low, &high]);
        }
        table.to_string()
    });
}

pub(crate) fn table_of_ends(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let shared = Reach { first: 0, last: 1 };
        let own = Reach { first: 1, last: 1 };
        let found = Found {
            numbers: (0..6).collect(),
            reach: vec![own, own, own, shared, shared, own],
            candidates: vec![
                pair(0.125, 0, 1),
                pair(0.25, 1, 2),
                pair(0.375, 2, 3),
                Candidate { time: 0.5, hit: Hit::WallX(2) },
                pair(0.625, 4, 5),
            ],
        };
        let mut decisions = found.decisions();
        decisions.rivals[3] = Some(pair(0.25, 3, 7));
        let rivals = decisions.rivals.clone();
        take_certain(&mut decisions);
        let mut discs = Table::new(["disc", "strips that it reaches", "rival", "afterwards"]);
        for (slot, rival) in rivals.iter().enumerate() {
            let strips = spaced(found.reach[slot].first..=found.reach[slot].last);
            let free = if decisions.free[slot] { "free" } else { "not free" };
            discs.row([&slot, &strips, &rival_words(rival.as_ref()), &free]);
        }
        let mut ends = Table::new(["candidate of rank 1", "its end"]);
        for candidate in &found.candidates {
            ends.row([&words(candidate), &end_of(&decisions, candidate)]);
        }
        format!("{discs}\n{ends}")
    });
}

fn rival_words(rival: Option<&Candidate>) -> String {
    match rival {
        None => "-".into(),
        Some(rival) if *rival == UNKNOWN => "not known yet".into(),
        Some(rival) => words(rival),
    }
}

/// Names the outcome of a candidate.
fn end_of(decisions: &Decisions, candidate: &Candidate) -> &'static str {
    let is_free = decisions.slots(candidate).all(|slot| decisions.free[slot]);
    if decisions.taken.contains(candidate) {
        "taken"
    } else if decisions.front.contains(candidate) {
        "open, in the front"
    } else if is_free {
        "open, behind an earlier one"
    } else {
        "dropped"
    }
}

pub(crate) fn table_of_moves(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let found = Found {
            numbers: (0..6).collect(),
            reach: vec![Reach { first: 0, last: 1 }; 6],
            candidates: Vec::new(),
        };
        let mut decisions = found.decisions();
        decisions.taken = vec![pair(0.5, 0, 1)];
        decisions.free = vec![false, false, true, true, false, false];
        let owns = [true, false, true, false, true, false];
        let discs = [(10.0, 2.0), (14.0, -2.0), (20.0, 1.0), (30.0, 1.0), (40.0, 1.0), (50.0, 1.0)];
        let mut discs = discs.map(|(x, vx)| Disc::new(x, 50.0, vx, 0.0));
        let before = discs;
        let moved = move_on(&mut discs, &owns, &decisions, Square { side: 100.0, radius: 1.0 });
        let ends = [
            "0+1 taken here",
            "0+1 taken here",
            "free",
            "free",
            "taken elsewhere",
            "taken elsewhere",
        ];
        let mut table = Table::new([
            "disc",
            "here",
            "in the step",
            "x, vx before",
            "moved by this rank: x, vx",
        ]);
        for (k, disc) in before.iter().enumerate() {
            let own = if owns[k] { "own" } else { "ghost" };
            let after = moved.iter().find(|wire| wire.index() == k);
            let after = after.map_or("-".into(), |wire| format!("{} {}", wire.x, wire.vx));
            table.row([&k, &own, &ends[k], &format!("{} {}", disc.x, disc.vx), &after]);
        }
        table.to_string()
    });
}

/// Shows a step of six discs in a tower on three ranks, two discs in each strip.
pub(crate) fn one_step(random: &mut Random, ask: &mut impl Ask) {
    on_each(ask, "8.13", &[3], random, |rank, _, ask| {
        let rows = rank.call("a step", |_| rows_of_a_step());
        let table = rank.columns(&rows);
        if rank.is_root() {
            ask.example(|| table);
        }
    });
}

fn rows_of_a_step() -> Vec<(&'static str, String)> {
    let tower = [(5.0, 0.0), (7.5, 0.0), (10.0, 5.0), (12.5, 4.0), (15.0, 2.0), (17.5, -2.0)];
    let discs = tower.map(|(y, vy)| Disc::new(15.0, y, 0.0, vy));
    let scene = Scene::new(30.0, 1.0, discs.to_vec()).expect("all discs are inside the square");
    let world = common_mpi::world().expect("this is a rank");
    let mut engine = SpatialCuts::<Lab8>::new(world, 0, Clock::new(false));
    engine.load(&scene);
    let mut rows = vec![("own discs, y", heights(&engine.own))];
    engine.step();
    let ghosts = (0..engine.seen.numbers.len()).filter(|&slot| !engine.seen.owns[slot]);
    rows.push(("ghosts", spaced(ghosts.map(|slot| engine.seen.numbers[slot]))));
    let taken = sorted(engine.decisions.taken.clone());
    rows.push(("takes", spaced(taken.iter().map(words))));
    rows.push(("own discs afterwards, y", heights(&engine.own)));
    rows
}

/// Lists the discs of a rank, each with its height.
fn heights(own: &[DiscWire]) -> String {
    let words: Vec<String> =
        own.iter().map(|disc| format!("{} at {}", disc.number, disc.y)).collect();
    if words.is_empty() { "-".into() } else { words.join(", ") }
}
