//! The worked examples of functions that do not need other ranks.

use std::f64::consts::PI;

use common::soft::CUTOFF;
use lab13::{
    best_depth, best_steps, deep_width, ghost_width, load, partners, right_steps, weigh_rows,
};
use oracle::{Ask, Random, Table, spaced};
use strips::{Outlook, Scenery, Strips};

/// Displacements of the fastest particle in a step, in cutoffs, in two tables.
const SPEEDS: [f64; 5] = [0.01, 0.05, 0.1, 1.0, 45.0];

/// Returns strips with these inner edges. The first and the last strip have no outer edge.
fn strips(between: &[f64]) -> Strips {
    Strips { edges: [&[f64::NEG_INFINITY][..], between, &[f64::INFINITY]].concat() }
}

/// Formats a length in cutoffs.
fn cutoffs(length: f64) -> String {
    format!("{:.2}", length / CUTOFF)
}

pub(crate) fn widths_of_ghosts(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| by_hand("width", ghost_width));
}

pub(crate) fn depths_of_ghosts(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| by_hand("depth", deep_width));
}

/// Shows the width or depth of ghosts for a few steps.
fn by_hand(what: &str, width: fn(f64, u32) -> f64) -> String {
    let mut table =
        Table::new(["fastest in a step / cutoff", "steps", &format!("{what} / cutoff")]);
    for (fastest, steps) in [(0.1, 1), (0.1, 2), (0.1, 3), (0.1, 11), (0.0, 11), (2.0, 4)] {
        table.row([&fastest, &steps, &cutoffs(width(fastest * CUTOFF, steps))]);
    }
    table.to_string()
}

pub(crate) fn table_of_widths(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let mut table =
            String::from("for how many steps ghosts are chosen, and how wide, in cutoffs\n\n");
        table += "strip  neighbours   cutoffs that the fastest goes in a step\n";
        let columns = SPEEDS.map(|speed| format!("{speed:>14}")).concat();
        table += &format!("     if at random {columns}\n");
        for (height, neighbours) in [(3.0, 0.6), (3.0, 5.0), (100.0, 0.6), (100.0, 5.0), (1e4, 0.6)]
        {
            table += &format!("{height:>5}  {neighbours:>10} ");
            for speed in SPEEDS {
                let steps = best_steps(Scenery {
                    fastest: speed * CUTOFF,
                    density: neighbours / (PI * CUTOFF * CUTOFF),
                    height: height * CUTOFF,
                    most: 20,
                });
                let width = ghost_width(speed * CUTOFF, steps) / CUTOFF;
                table += &format!("{steps:>7}{width:>7.2}");
            }
            table += "\n";
        }
        table
    });
}

pub(crate) fn table_of_depths(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let mut table =
            String::from("for how many steps ghosts are chosen, and how deep, in cutoffs\n\n");
        table += "strip  particles   cutoffs that the fastest goes in a step\n";
        let columns = SPEEDS.map(|speed| format!("{speed:>15}")).concat();
        table += &format!("                {columns}\n");
        for (height, particles) in [(3.0, 20.0), (35.0, 500.0), (112.0, 5e3), (1118.0, 5e5)] {
            table += &format!("{height:>5}  {particles:>9} ");
            for speed in SPEEDS {
                let fastest = speed * CUTOFF;
                let outlook = Outlook { fastest, height: height * CUTOFF, particles, most: 20 };
                let steps = best_depth(outlook);
                let depth = deep_width(fastest, steps) / CUTOFF;
                table += &format!("{steps:>8}{depth:>7.2}");
            }
            table += "\n";
        }
        table
    });
}

pub(crate) fn table_of_partners(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let mut table = Table::new(["edges between strips", "width", "partners of each rank"]);
        for (between, width) in [
            (&[2.0, 4.0][..], 1.5),
            (&[2.0, 4.0], 2.0),
            (&[2.0, 3.0, 3.0, 7.0], 0.5),
            (&[2.0, 3.0, 3.0, 7.0], 1.5),
            (&[2.0, 3.0, 3.0, 7.0], 5.0),
        ] {
            let strips = strips(between);
            let all = (0..strips.ranks()).map(|rank| spaced(partners(&strips, rank, width)));
            table.row([&spaced(between), &width, &all.collect::<Vec<_>>().join("|")]);
        }
        table.to_string()
    });
}

pub(crate) fn table_of_loads(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let headings =
            ["particles in each row", "listed pairs", "load [ns]", "share of each row [ns]"];
        let mut table = Table::new(headings);
        for (counts, pairs) in [
            (vec![2, 2], 0),
            (vec![2, 2], 1),
            (vec![4, 3, 1, 0], 4),
            (vec![0, 0, 9, 1], 20),
            (vec![0, 0], 0),
        ] {
            let particles: u64 = counts.iter().sum();
            let load = load(particles as usize, pairs);
            table.row([&spaced(&counts), &pairs, &load, &spaced(weigh_rows(&counts, load))]);
        }
        table.to_string()
    });
}

pub(crate) fn table_of_right_steps(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let headings =
            ["furthest in each step / cutoff", "depth / cutoff", "steps taken", "steps right"];
        let mut table = Table::new(headings);
        for (moves, depth) in [
            (vec![0.1, 0.1, 0.1], 3.5),
            (vec![0.1, 0.1, 9.0], 3.5),
            (vec![0.1, 0.6, 0.1], 3.5),
            (vec![2.0, 0.1, 0.1], 3.5),
            (vec![0.0, 0.0, 0.0, 0.0], 3.5),
            (vec![5.0], 1.5),
        ] {
            let lengths: Vec<f64> = moves.iter().map(|far| far * CUTOFF).collect();
            let right = right_steps(&lengths, depth * CUTOFF);
            table.row([&spaced(&moves), &depth, &moves.len(), &right]);
        }
        table.to_string()
    });
}
