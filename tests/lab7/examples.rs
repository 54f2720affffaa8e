//! The worked examples of tasks 7.1 to 7.7: a few discs that can be checked by hand. All have
//! radius 1.

use common::hard::{Disc, Scene};
use hard_discs::{Candidate, Hit, Square};
use lab7::{VARIANTS, bounce, collide, order, pair_time, stop_at_wall, take_in_order, wall_hit};
use oracle::{Ask, Random, Table};

/// Describes the obstacle of a collision in words.
fn words(hit: Hit) -> String {
    match hit {
        Hit::Corner(a) => format!("{a} at corner"),
        Hit::WallX(a) => format!("{a} at x wall"),
        Hit::WallY(a) => format!("{a} at y wall"),
        Hit::Pair(a, b) => format!("{a} and {b}"),
    }
}

/// Formats a number with at most four decimals. Negative zero becomes zero.
fn number(value: f64) -> String {
    let rounded = (value * 1e4).round() / 1e4;
    (rounded + 0.0).to_string()
}

pub(crate) fn wall_table(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let mut table = Table::new(["x", "y", "vx", "vy", "λ", "it hits", ""]);
        for (disc, what) in [
            (Disc::new(5.0, 5.0, 2.0, 1.0), "it stays inside"),
            (Disc::new(2.0, 5.0, -2.0, 0.0), "it would end at x = 0"),
            (Disc::new(5.0, 8.0, 0.0, 4.0), "it would end at y = 12"),
            (Disc::new(2.0, 3.0, -4.0, -4.0), "x at 1/4, y at 1/2: the earlier"),
            (Disc::new(7.0, 7.0, 4.0, 4.0), "both at 1/2"),
            (Disc::new(2.0, 5.0, -1.0, 0.0), "it ends on the wall, not beyond"),
        ] {
            let hit = wall_hit(0, &disc, Square { side: 10.0, radius: 1.0 });
            let time = hit.map_or("none".into(), |hit| number(hit.time));
            let hit = hit.map_or("-".into(), |hit| words(hit.hit));
            let numbers = [disc.x, disc.y, disc.vx, disc.vy].map(number);
            let [x, y, vx, vy] = &numbers;
            table.row([x, y, vx, vy, &time, &hit, &what]);
        }
        table.to_string()
    });
}

pub(crate) fn touch_table(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let mut table = Table::new(["dx", "dy", "Dx", "Dy", "λ", ""]);
        for (d, v, what) in [
            ((5.0, 0.0), (-6.0, 0.0), "head on: a gap of 3, at 6 a step"),
            ((5.0, 0.0), (-3.0, 0.0), "they touch at λ = 1, when the step is over"),
            ((5.0, 0.0), (6.0, 0.0), "they fly apart"),
            ((5.0, 0.0), (0.0, 0.0), "at rest, seen from each other"),
            ((6.0, 1.2), (-8.8, 0.0), "off centre: in contact at d = (1.6, 1.2)"),
            ((4.0, 2.0), (-8.0, 0.0), "they only graze: Δ = 0"),
            ((4.0, 3.0), (-8.0, 0.0), "they pass: Δ < 0"),
            ((2.0, 0.0), (-1.0, 0.0), "in contact already"),
            ((1.0, 0.0), (-1.0, 2.0), "they overlap"),
            ((1.0, 0.0), (1.0, 2.0), "they overlap, and fly apart"),
            ((0.0, 0.0), (1.0, 0.0), "at one position: s = 0"),
        ] {
            let a = Disc::new(20.0, 20.0, 1.0, 1.0);
            let b = Disc::new(a.x + d.0, a.y + d.1, a.vx + v.0, a.vy + v.1);
            let time = pair_time(&a, &b, 1.0).map_or("none".into(), number);
            table.row([&d.0, &d.1, &v.0, &v.1, &time, &what]);
        }
        table.to_string()
    });
}

pub(crate) fn order_table(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let mut table = Table::new(["λ", "first", "λ", "second", "first is", ""]);
        for (one, another, what) in [
            ((0.25, Hit::Pair(3, 4)), (0.5, Hit::WallX(0)), "the earlier"),
            ((0.500_000_000_01, Hit::Pair(0, 1)), (0.5, Hit::Pair(2, 3)), "earlier by a digit"),
            ((0.5, Hit::Pair(0, 1)), (0.5, Hit::WallY(2)), "walls before pairs"),
            ((0.5, Hit::WallX(0)), (0.5, Hit::Corner(3)), "corners before walls"),
            ((0.5, Hit::WallX(3)), (0.5, Hit::WallY(2)), "x before y"),
            ((0.5, Hit::Pair(1, 2)), (0.5, Hit::Pair(0, 4)), "lower first disc"),
            ((0.5, Hit::Pair(1, 2)), (0.5, Hit::Pair(1, 4)), "lower second disc"),
            ((-0.0, Hit::Pair(0, 1)), (0.0, Hit::WallX(2)), "two zeros are equal"),
        ] {
            let [a, b] = [one, another].map(|(time, hit)| Candidate { time, hit });
            let comes = ["before", "the same", "after"][(order(&a, &b) as i8 + 1) as usize];
            table.row([&a.time, &words(a.hit), &b.time, &words(b.hit), &comes, &what]);
        }
        table.to_string()
    });
}

pub(crate) fn take_table(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let all = [
            (0.75, Hit::Pair(0, 1), "disc 1 is taken already"),
            (0.5, Hit::Pair(1, 2), "disc 2 is still free"),
            (0.25, Hit::WallX(3), "the earliest whose disc is free"),
            (0.375, Hit::Pair(2, 3), "disc 3 is taken; disc 2 stays free"),
            (0.875, Hit::WallY(0), "disc 0 is still free"),
            (0.125, Hit::Pair(4, 5), "disc 5 is not free from the start"),
        ];
        let mut candidates = all.map(|(time, hit, _)| Candidate { time, hit });
        let mut free = [true, true, true, true, true, false];
        let mut taken = Vec::new();
        take_in_order(&mut candidates, &mut free, &mut taken);
        let mut table = Table::new(["λ", "candidate", "taken as number", ""]);
        for (time, hit, what) in all {
            let place = taken.iter().position(|taken| taken.hit == hit);
            let place = place.map_or("-".into(), |place| (place + 1).to_string());
            table.row([&time, &words(hit), &place, &what]);
        }
        let left = (0..free.len()).filter(|&disc| free[disc]);
        format!("{table}\nfree afterwards: {}\n", oracle::spaced(left))
    });
}

pub(crate) fn stop_table(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let mut table = Table::new(["x", "y", "vx", "vy", "waits at x", "y", ""]);
        for (disc, what) in [
            (Disc::new(5.0, 5.0, 3.0, 1.0), "inside, from 1 to 9"),
            (Disc::new(10.0, 5.0, 2.0, 1.0), "1/2 step back"),
            (Disc::new(10.0, 10.0, 2.0, 1.0), "1/2 step back for x, 1 for y"),
            (Disc::new(-1.0, 3.0, -4.0, 2.0), "the left wall"),
            (Disc::new(9.5, 5.0, 0.0, 1.0), "x does not count: vx is 0"),
            (Disc::new(9.5, 5.0, -1.0, 1.0), "x does not count: the time is -1/2"),
            (Disc::new(9.5, 5.0, 0.125, 1.0), "x does not count: the time is 4"),
        ] {
            let mut after = disc;
            stop_at_wall(&mut after, Square { side: 10.0, radius: 1.0 });
            let [x, y] = [after.x, after.y].map(number);
            table.row([&disc.x, &disc.y, &disc.vx, &disc.vy, &x, &y, &what]);
        }
        table.to_string()
    });
}

/// Headings of a table of discs before and after an event.
const DISCS: [&str; 9] = ["", "disc", "", "x", "y", "vx", "vy", "pairs", "walls"];

/// Adds a disc to a table with the headings [`DISCS`].
fn add_disc(table: &mut Table, what: &str, number_of: usize, when: &str, disc: &Disc) {
    let numbers = [disc.x, disc.y, disc.vx, disc.vy].map(number);
    let [x, y, vx, vy] = &numbers;
    let Disc { pair_collisions, wall_collisions, .. } = disc;
    table.row([&what, &number_of, &when, x, y, vx, vy, pair_collisions, wall_collisions]);
}

pub(crate) fn collision_table(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let square = Square { side: 20.0, radius: 1.0 };
        let mut table = Table::new(DISCS);
        for (what, hit, disc) in [
            ("x wall", Hit::WallX(0), Disc::new(3.0, 5.0, -4.0, 1.0)),
            ("corner", Hit::Corner(0), Disc::new(3.0, 17.0, -4.0, 4.0)),
        ] {
            let mut after = disc;
            bounce(&mut after, 0.5, hit, square);
            add_disc(&mut table, what, 0, "before", &disc);
            add_disc(&mut table, what, 0, "after", &after);
        }
        for (what, a, b) in [
            ("head on", Disc::new(10.0, 5.0, 4.0, 1.0), Disc::new(16.0, 5.0, -4.0, 1.0)),
            ("off centre", Disc::new(8.0, 8.0, 0.0, 0.0), Disc::new(13.6, 9.2, -8.0, 0.0)),
            ("near a wall", Disc::new(11.0, 9.0, 8.0, 2.0), Disc::new(17.0, 9.0, 0.0, 2.0)),
            ("n is 1 long", Disc::new(9.0, 9.0, 2.0, 0.0), Disc::new(11.0, 9.0, 0.0, 0.0)),
        ] {
            let mut after = [a, b];
            let [first, second] = &mut after;
            collide(first, second, 0.5, square);
            for (when, discs) in [("before", [a, b]), ("after", after)] {
                add_disc(&mut table, what, 0, when, &discs[0]);
                add_disc(&mut table, what, 1, when, &discs[1]);
            }
        }
        table.to_string()
    });
}

pub(crate) fn step_table(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let before = vec![
            Disc::new(4.0, 10.0, 4.0, 0.0),
            Disc::new(10.0, 10.0, -4.0, 0.0),
            Disc::new(18.0, 4.0, 2.0, 1.0),
            Disc::new(8.0, 16.0, 0.0, -6.0),
        ];
        let scene = Scene::new(20.0, 1.0, before.clone()).expect("all discs are inside the square");
        let sequential = &VARIANTS[0];
        let mut engine = (sequential.build)(&sequential.config()).expect("the engine can be built");
        engine.load(&scene);
        engine.step();
        let mut after = before.clone();
        engine.read(0, &mut after);
        let mut table = Table::new(DISCS);
        let what = ["meets 1", "meets 0", "x wall", "too late"];
        for (disc, what) in what.into_iter().enumerate() {
            for (when, discs) in [("before", &before), ("after", &after)] {
                add_disc(&mut table, what, disc, when, &discs[disc]);
            }
        }
        table.to_string()
    });
}
