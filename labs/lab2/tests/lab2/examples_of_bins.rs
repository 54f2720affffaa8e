//! The worked examples of tasks 2.1 to 2.5: a few particles and bins that can be checked by hand,
//! and the lab's results.

use common::soft::{CUTOFF, Particle};
use lab2::{Grid, VecBins, take_leavers};
use oracle::{Ask, Count, Random, Table, ascending, spaced};

use super::particles::numbered;

pub(crate) fn bins_table(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let mut table = Table::new([
            "side of the box",
            "least side",
            "particles",
            "bins along a wall",
            "their side",
        ]);
        for (size, least, n) in [
            (4.5, 1.0, 100),
            (4.0, 1.0, 100),
            (4.0, 2.5, 100),
            (0.5, 1.0, 100),
            (1000.0, 1.0, 2),
            (1000.0, 1.0, 3),
            (1000.0, 1.0, 0),
        ] {
            let grid = Grid::new(size, least, n);
            table.row([&size, &least, &n, &grid.rows(), &format!("{:.4}", grid.bin_side())]);
        }
        table.to_string()
    });
}

pub(crate) fn columns_table(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let grid = Grid::with_bins_along(4.0, 4);
        let mut table = Table::new(["x", "y", "column", "row", "bin"]);
        for (x, y) in
            [(0.0, 0.0), (0.5, 0.5), (3.5, 0.5), (0.5, 1.5), (2.2, 1.9), (2.5, 4.0), (4.0, 4.0)]
        {
            let bin = grid.bin(&numbered(0, x, y));
            table.row([&x, &y, &grid.column(x), &grid.row(y), &bin]);
        }
        table.to_string()
    });
}

pub(crate) fn near_table(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let mut table = Table::new(["rows", "row", "rows next to it, itself among them"]);
        for along in [1, 2, 5] {
            let grid = Grid::with_bins_along(1.0, along);
            for row in 0..along {
                table.row([&along, &row, &spaced(grid.near(row))]);
            }
        }
        table.to_string()
    });
}

pub(crate) fn refill_table(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let places = [(0.5, 0.5), (1.5, 0.2), (0.3, 1.7), (0.8, 0.1), (1.2, 1.9)];
        let all: Vec<Particle> =
            places.into_iter().enumerate().map(|(id, (x, y))| numbered(id, x, y)).collect();
        let mut places = Table::new(["particle", "x", "y"]);
        for p in &all {
            places.row([&p.id, &p.x, &p.y]);
        }
        let mut table = Table::new(["four bins of side 1", "bin 0", "bin 1", "bin 2", "bin 3"]);
        let mut row = |what: &str, bins: &VecBins| {
            let [a, b, c, d] =
                [0, 1, 2, 3].map(|bin| ascending(bins.bins()[bin].iter().map(|p| p.id)));
            table.row([&what, &a, &b, &c, &d]);
        };
        let mut bins = VecBins::new(Grid::with_bins_along(2.0, 2));
        bins.refill(&all[..4]);
        row("filled with 0 1 2 3", &bins);
        bins.put(all[4]);
        row("4 is put in", &bins);
        bins.refill(&all[1..3]);
        row("filled with 1 2", &bins);
        bins.refill(&[]);
        row("filled with none", &bins);
        format!("{places}\n{table}")
    });
}

pub(crate) fn nine_bins_table(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let mut table =
            Table::new(["row", "column", "dx / cutoff", "dy / cutoff", "ax", "ay", "looked at"]);
        let grid = Grid::with_bins_along(5.0 * CUTOFF, 5);
        let p = numbered(0, 2.5 * CUTOFF, 2.5 * CUTOFF);
        for (dx, dy) in AROUND {
            let q = numbered(1, p.x + dx * CUTOFF, p.y + dy * CUTOFF);
            let row = (2.5 + dy) as usize;
            let column = (2.5 + dx) as usize;
            let mut bins = VecBins::new(grid);
            bins.bins_mut()[2 * 5 + 2].push(p);
            bins.bins_mut()[row * 5 + column].push(q);
            let mut count = Count::default();
            let a = bins.acceleration(&p, &mut count);
            // Negative zero becomes zero.
            let [ax, ay] = [a.x, a.y].map(|a| format!("{:.1}", a + 0.0));
            table.row([&row, &column, &dx, &dy, &ax, &ay, &count.tested]);
        }
        table.to_string()
    });
}

/// Positions of a neighbour, in cutoffs: in each of nine bins, and beyond them.
const AROUND: [(f64, f64); 11] = [
    (-0.6, -0.6),
    (0.0, -0.6),
    (0.6, -0.6),
    (-0.6, 0.0),
    (0.3, 0.0),
    (0.6, 0.0),
    (-0.6, 0.6),
    (0.0, 0.6),
    (0.6, 0.6),
    (1.6, 0.0),
    (0.0, -1.6),
];

pub(crate) fn leavers_table(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let places =
            [(0.5, 0.5), (1.2, 0.5), (0.1, 0.9), (0.5, 1.1), (1.5, 1.5), (0.8, 0.2), (1.1, 0.1)];
        let all = places.into_iter().enumerate().map(|(id, (x, y))| numbered(id, x, y));
        let mut inside: Vec<Particle> = all.clone().collect();
        let mut changed = vec![numbered(9, 1.9, 1.9)];
        take_leavers(&Grid::with_bins_along(2.0, 2), 0, &mut inside, &mut changed);
        let mut table = Table::new(["particle", "x", "y", "in the list of bin 0", "in `changed`"]);
        let has = |list: &[Particle], id: u32| list.iter().filter(|p| p.id == id).count();
        for p in all.chain([numbered(9, 1.9, 1.9)]) {
            table.row([&p.id, &p.x, &p.y, &has(&inside, p.id), &has(&changed, p.id)]);
        }
        table.to_string()
    });
}
