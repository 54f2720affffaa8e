//! The worked examples of tasks 2.6 to 2.9: lists, pairs and sums in an order that can be checked
//! by hand.

use common::soft::{CUTOFF, Observer, Particle, Scene, Simulation, Statistics};
use lab2::{BinLists, Gather, Grid, LinkedList, SortedBins, forward};
use oracle::{Ask, Count, Random, Table, ascending, spaced};

use super::particles::numbered;

pub(crate) fn lists_table(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let mut lists = BinLists::new(2, 5);
        let mut table = Table::new(["", "bin 0", "bin 1"]);
        let mut row = |what: &str, lists: &BinLists| {
            // The limit ends a list that leads back to itself.
            let [zero, one] = [0, 1].map(|bin| spaced(lists.bin(bin).take(6)));
            table.row([&what, &zero, &one]);
        };
        lists.clear();
        row("cleared", &lists);
        for (particle, bin) in [(3, 1), (0, 1), (4, 0), (1, 1)] {
            lists.insert(bin, particle);
            row(&format!("{particle} into bin {bin}"), &lists);
        }
        lists.clear();
        row("cleared", &lists);
        lists.insert(0, 0);
        row("0 into bin 0", &lists);
        table.to_string()
    });
}

pub(crate) fn forward_table(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let mut table = Table::new(["bins along", "bin", "row", "column", "bins after it"]);
        for along in 1..=3 {
            let grid = Grid::with_bins_along(1.0, along);
            for bin in 0..along * along {
                let mut bins = [0; 4];
                let count = forward(&grid, bin / along, bin % along, &mut bins);
                let after = ascending(bins[..count].iter().copied());
                table.row([&along, &bin, &(bin / along), &(bin % along), &after]);
            }
        }
        table.to_string()
    });
}

/// Shows the pairs of four particles: 0 and 1 are in one bin, 2 in the next row; 3 is alone.
pub(crate) fn pairs_table(_: &mut Random, ask: &mut impl Ask) {
    forward(&Grid::with_bins_along(1.0, 1), 0, 0, &mut [0; 4]);
    ask.example(|| {
        let at = |id: usize, x: f64, y: f64| numbered(id, x * CUTOFF, y * CUTOFF);
        let particles = vec![at(0, 1.7, 0.5), at(1, 1.2, 0.5), at(2, 1.7, 1.2), at(3, 3.5, 3.5)];
        let scene = Scene::new(4.4 * CUTOFF, particles).expect("all particles are in the box");
        let mut engine = LinkedList::<Count>::new(1.0);
        engine.load(&scene);
        engine.step();
        let mut after = scene.particles().to_vec();
        engine.read(0, &mut after);
        let mut table = Table::new(["particle", "x / cutoff", "y / cutoff", "vx", "vy"]);
        for (p, after) in scene.particles().iter().zip(&after) {
            let [x, y] = [p.x, p.y].map(|x| format!("{:.1}", x / CUTOFF));
            // Negative zero becomes zero.
            let [vx, vy] = [after.vx, after.vy].map(|v| format!("{:.3}", v + 0.0));
            table.row([&p.id, &x, &y, &vx, &vy]);
        }
        let seen = engine.statistics().expect("the engine was built with statistics");
        format!(
            "{table}\npair tests: {}\npairs within the cutoff, each counted twice: {}\n",
            seen.pair_tests, seen.navg
        )
    });
}

pub(crate) fn sort_table(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let mut bins = SortedBins::new(Grid::with_bins_along(3.0, 3), 0..1);
        let columns = [2, 0, 2, 1, 0];
        let particles = columns.map(|column| f64::from(column) + 0.5).into_iter().enumerate();
        bins.refill(particles.map(|(id, x)| numbered(id, x, 0.5)));
        let mut table = Table::new(["index", "particle before", "its bin", "particle after"]);
        for (index, column) in columns.into_iter().enumerate() {
            table.row([&index, &index, &column, &bins.particles()[index].id]);
        }
        let mut spans = Table::new(["bin", "begins at index", "ends before index"]);
        for column in 0..3 {
            let span = bins.span(0, column..column + 1);
            spans.row([&column, &span.start, &span.end]);
        }
        format!("{table}\n{spans}")
    });
}

/// An observer that records the order of the terms of a sum.
#[derive(Clone, Default)]
struct Order {
    looked_at: u64,
    cutoffs: Vec<String>,
}

impl Observer for Order {
    fn tested(&mut self, pairs: u64) {
        self.looked_at += pairs;
    }

    fn seen(&mut self, r2: f64) {
        // The particle itself, at distance 0, is not counted.
        if r2 > 0.0 {
            self.cutoffs.push(format!("{:.1}", r2.sqrt() / CUTOFF));
        }
    }

    fn merge(&mut self, _: &Self) {}

    fn statistics(&self) -> Option<Statistics> {
        None
    }
}

pub(crate) fn gather_table(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let p = numbered(5, 0.5, 0.5);
        let at = |id: usize, r: f64| numbered(id, p.x + r * CUTOFF, p.y);
        let [near, other, far] = [at(3, 0.5), at(7, -0.8), at(1, 1.5)];
        let last = at(4, 0.9);
        let slices: [(&str, [&[Particle]; 2]); 4] = [
            ("7 5 | 4 3", [&[other, p], &[last, near]]),
            ("3 4 | 5 7", [&[near, last], &[p, other]]),
            ("5 1 | 3", [&[p, far], &[near]]),
            ("5 | -", [&[p], &[]]),
        ];
        let mut table = Table::new(["candidates", "looked at", "r / cutoff, as summed", "ax"]);
        let mut gather = Gather::default();
        for (candidates, slices) in slices {
            let mut order = Order::default();
            let a = gather.acceleration(&p, slices, &mut order);
            let ax = format!("{:.3}", a.x + 0.0);
            table.row([&candidates, &order.looked_at, &spaced(order.cutoffs), &ax]);
        }
        table.to_string()
    });
}
