//! The worked examples of ranks with strips.

use std::slice;

use common::hard::{Disc, Scene, Simulation};
use common_mpi::Clock;
use hard_disc_ranks::{CandidateWire, Decisions, DiscWire, Reach, SpatialCuts, Strips, UNKNOWN};
use lab8::{ghosts_for, hear, looks_at, move_on, news_for, reached, take_certain, Lab8};
use oracle::{spaced, Ask, Columns, Random, Table};
use oracle_mpi::on_each;
use solution6::Cuts;
use solution7::{Candidate, Hit, Lab7, Square};

use super::candidates::{meeting, pair, sorted, words, Found};

/// Three strips of height 10.
fn three_strips() -> Strips {
    Strips { bottom: 0.0, height: 10.0, cuts: Cuts { starts: vec![0, 1, 2, 3] } }
}

/// Discs at these heights with these velocities along y, numbered from 0.
fn flying(all: &[(f64, f64)]) -> Vec<DiscWire> {
    let disc = |(number, &(y, vy)): (usize, &(f64, f64))| {
        DiscWire::new(number, &Disc::new(5.0, y, 0.0, vy))
    };
    all.iter().enumerate().map(disc).collect()
}

/// From where to where the box of a disc of radius 1 goes along y.
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
        Some(rival) if *rival == UNKNOWN => "not told yet".into(),
        Some(rival) => words(rival),
    }
}

/// What became of a candidate.
fn end_of(decisions: &Decisions, candidate: &Candidate) -> &'static str {
    let is_free = decisions.slots(candidate).all(|slot| decisions.free[slot]);
    if decisions.taken.contains(candidate) {
        "taken"
    } else if decisions.front.contains(candidate) {
        "open, in the front"
    } else if is_free {
        "open, behind another one"
    } else {
        "dropped"
    }
}

/// A tower of eight discs on three ranks. Discs 2 and 5 are at the cuts, and known on both sides.
pub(crate) fn table_of_news(_: &mut Random, ask: &mut impl Ask) {
    // On a fresh starter this task's todo comes first.
    news_for(&Decisions::default(), 0);
    ask.example(|| {
        let found = [
            vec![pair(0.25, 0, 1), pair(0.75, 1, 2)],
            vec![pair(0.5, 2, 3), pair(0.375, 3, 4), pair(0.25, 4, 5)],
            vec![pair(0.125, 5, 6), pair(0.5, 6, 7)],
        ];
        let mut all: Vec<Decisions> = (0..3).map(|rank| of_tower(rank, &found[rank])).collect();
        let mut table = Columns::new((0..3).map(|rank| format!("rank {rank}")));
        table.row(
            "finds",
            found.map(|found| found.iter().map(words).collect::<Vec<_>>().join(", ")),
        );
        for round in 1..=3 {
            all.iter_mut().for_each(take_certain);
            let taken = |d: &Decisions| meetings(&d.taken[d.told..]);
            table.row(format!("round {round}: takes"), all.iter().map(taken));
            table.row("  leaves open", all.iter().map(|d| meetings(&d.front)));
            tell(&mut all, &mut table);
        }
        table.to_string()
    });
}

/// What a rank knows before the first round.
fn of_tower(rank: usize, found: &[Candidate]) -> Decisions {
    let reach = [(0, 0), (0, 0), (0, 1), (1, 1), (1, 1), (1, 2), (2, 2), (2, 2)];
    let reach = reach.map(|(first, last)| Reach { first, last });
    let here: Vec<u32> = (0..8).filter(|&disc| reach[disc as usize].contains(rank)).collect();
    let reach: Vec<Reach> = here.iter().map(|&disc| reach[disc as usize]).collect();
    let mut decisions = Decisions::default();
    decisions.start::<Lab7>(&here, &reach, found);
    decisions
}

/// The ranks tell each other their news, row by row, and hear them.
fn tell(all: &mut [Decisions], table: &mut Columns) {
    let mut mail: Vec<Vec<CandidateWire>> = Vec::new();
    for partner in 0..all.len() {
        let tells: Vec<Vec<CandidateWire>> = (0..all.len())
            .map(|rank| if rank == partner { Vec::new() } else { news_for(&all[rank], partner) })
            .collect();
        table.row(format!("  tells rank {partner}"), tells.iter().map(|news| told(news)));
        mail.push(tells.concat());
    }
    for (decisions, mail) in all.iter_mut().zip(&mail) {
        decisions.told = decisions.taken.len();
        hear(decisions, mail);
    }
}

fn told(news: &[CandidateWire]) -> String {
    let told = news.iter().map(|wire| {
        let end = if wire.is_taken() { "taken" } else { "open" };
        format!("{} {end}", meetings(slice::from_ref(&Candidate::from(wire))))
    });
    told.collect::<Vec<_>>().join(", ")
}

/// Which discs meet.
fn meetings(candidates: &[Candidate]) -> String {
    spaced(sorted(candidates.to_vec()).iter().map(meeting))
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

/// Six discs in a tower on three ranks: two in each strip.
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
    let scene = Scene::new(30.0, 1.0, discs.to_vec()).expect("all are inside");
    let world = common_mpi::world().expect("this is a rank");
    let mut engine = SpatialCuts::<Lab8>::new(world, 0, Clock::new(false));
    engine.load(&scene);
    let heights = |own: &[DiscWire]| {
        let disc = |wire: &DiscWire| format!("{} at {}", wire.number, wire.y);
        let words: Vec<String> = own.iter().map(disc).collect();
        if words.is_empty() {
            "-".into()
        } else {
            words.join(", ")
        }
    };
    let mut rows = vec![("own discs, y", heights(&engine.own))];
    engine.step();
    let ghosts = (0..engine.seen.numbers.len()).filter(|&slot| !engine.seen.owns[slot]);
    rows.push(("ghosts", spaced(ghosts.map(|slot| engine.seen.numbers[slot]))));
    let taken = sorted(engine.decisions.taken.clone());
    rows.push(("takes", spaced(taken.iter().map(words))));
    rows.push(("own discs afterwards, y", heights(&engine.own)));
    rows
}
