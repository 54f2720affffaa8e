//! The worked examples: cases that can be checked by hand, and the lab's results.

use std::fmt::Display;

use lab11::{Tasks, closest_squared, fly, join, meets_wall, root, too_far_off, window_length};
use neighbour_list::Bodies;
use oracle::{Ask, Random, Table};
use windows::{Span, plan};

pub(crate) fn flown_steps(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let mut table = Table::new(["x", "v", "after 1 step", "after 3 steps", "after 10 steps"]);
        let [start, v] = [[0.0, 1.25, 1.0], [1.0, -0.5, 0.0]];
        let after = |steps| {
            let mut x = start;
            fly(&mut x, &v, steps, 0.1);
            x
        };
        let [one, three, ten] = [1, 3, 10].map(after);
        for k in 0..3 {
            table.row([&start[k], &v[k], &one[k], &three[k], &ten[k]]);
        }
        table.to_string()
    });
}

pub(crate) fn closest_approaches(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let mut table = Table::new(["d", "w", "within 0", "1", "2", "4", "8", ""]);
        for ((dx, dy), (wx, wy), what) in [
            ((3.0, 4.0), (0.0, 0.0), "at rest to each other"),
            ((3.0, 0.0), (-1.0, 0.0), "head on"),
            ((3.0, 1.0), (-1.0, 0.0), "past each other"),
            ((3.0, 1.0), (-0.25, 0.0), "too slow to meet by then"),
            ((3.0, 1.0), (1.0, 0.0), "apart"),
            ((0.0, 1.2), (0.5, 0.0), "side by side"),
            ((0.0, 0.0), (1.0, 1.0), "at one position"),
        ] {
            let [d, w] = [(dx, dy), (wx, wy)].map(|(x, y)| format!("({x}, {y})"));
            let least = |span| format!("{:.3}", closest_squared(dx, dy, wx, wy, span).sqrt());
            let [now, one, two, four, eight] = [0.0, 1.0, 2.0, 4.0, 8.0].map(least);
            table.row([&d, &w, &now, &one, &two, &four, &eight, &what]);
        }
        table.to_string()
    });
}

pub(crate) fn joined_pairs(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let mut table = format!("pair  the root of each particle\n      {}\n", line(0..11));
        let mut parent: Vec<u32> = (0..11).collect();
        for [a, b] in [[4, 7], [2, 9], [7, 9], [1, 5], [9, 4], [3, 8], [8, 5]] {
            join(&mut parent, a, b);
            let roots: Vec<u32> = (0..11).map(|k| root(&mut parent, k)).collect();
            table += &format!("{a}, {b}  {}\n", line(roots));
        }
        table
    });
}

/// Formats items in one line.
fn line<T: Display>(items: impl IntoIterator<Item = T>) -> String {
    items.into_iter().map(|item| format!("{item:>3}")).collect()
}

pub(crate) fn deviations(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let mut table = Table::new(["deviation / cutoff", "too far off"]);
        for deviation in [0.0, 0.02, 0.025, 0.026, 1.0] {
            let answer = if too_far_off(deviation, 0.05) { "yes" } else { "no" };
            table.row([&deviation, &answer]);
        }
        table.to_string()
    });
}

pub(crate) fn walls_ahead(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let span = Span { steps: 4, dt: 0.125, size: 1.0 };
        let mut table = Table::new(["x", "y", "vx", "vy", "a wall", ""]);
        for (x, y, vx, vy, what) in [
            (0.5, 0.5, 0.0, 0.0, "rests in the middle"),
            (0.5, 0.5, 0.5, 0.0, "ends at x = 0.75"),
            (0.5, 0.5, 1.0, 0.0, "ends on the wall"),
            (0.5, 0.5, 0.0, -2.0, "would end at y = -0.5"),
            (1.0, 0.5, -0.5, 0.0, "begins on a wall and leaves it"),
            (0.25, 0.25, -0.4, -0.6, "would end at y = -0.05"),
        ] {
            let answer = if meets_wall(&span, x, y, vx, vy) { "yes" } else { "no" };
            table.row([&x, &y, &vx, &vy, &answer, &what]);
        }
        table.to_string()
    });
}

pub(crate) fn window_lengths(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let mut table = Table::new(["particles per area", "mean speed", "steps", ""]);
        for (density, speed, what) in [
            (2000.0, 0.5, "the density of the official scene"),
            (2000.0, 1.0, "twice as fast"),
            (4000.0, 1.0, "twice as dense"),
            (200_000.0, 1.0, "at least one step"),
            (200.0, 0.5, "at most 48 steps"),
            (2000.0, 0.0, "nobody moves"),
            (0.0, 0.0, "an empty box"),
        ] {
            table.row([&density, &speed, &window_length(density, speed), &what]);
        }
        table.to_string()
    });
}

pub(crate) fn plans(_: &mut Random, ask: &mut impl Ask) {
    // Calls task 11.6 first, so that an unsolved starter stops at the `todo!` of task 11.6.
    window_length(2000.0, 0.0);
    ask.example(|| {
        let official = common::soft::Scene::official(2000, 1).expect("the scene is valid");
        let mut table = Table::new(["neighbours", "planned", "substep"]);
        for neighbours in [0.01_f64, 0.03, 0.06, 0.1, 0.2, 0.6, 1.2, 5.0] {
            // In the official scene there are 0.63 neighbours within the cutoff.
            let stretch = (0.63 / neighbours).sqrt();
            let mut bodies = Bodies::of(&official);
            bodies.x.iter_mut().chain(&mut bodies.y).for_each(|x| *x *= stretch);
            let strategy = |divide| format!("{:?}", plan::<Tasks>(&bodies, 0, divide).strategy);
            table.row([&neighbours, &strategy(1), &strategy(10)]);
        }
        table.to_string()
    });
}
