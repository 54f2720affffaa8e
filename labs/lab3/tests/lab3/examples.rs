//! The worked examples: a scene that can be checked by hand, and the lab's results.

use std::ops::Range;

use common::Vec2;
use common::soft::{CUTOFF, DT, NoStatistics, Observer, Particle, Scene, Simulation, Statistics};
use lab3::{
    AtomicStatistics, Vanilla, Word, Worker, in_order, own_rows, pool, sum_and_move, under_a_lock,
    with_atomics,
};
use oracle::{Ask, Random, Table, ascending};
use solution1::Tally;
use solution2::{Grid, VecBins};

use super::bins::{at, ids, of_cutoffs, row_by_row};
use super::reductions::{add_quarter, at_first, statistics};

/// Formats a velocity or an acceleration. Negative zero becomes zero.
fn number(value: f64) -> String {
    format!("{:.1}", value + 0.0)
}

pub(crate) fn forces_of_all_pairs(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let particles = [(2.0, 5.0), (2.5, 5.0), (2.5, 5.5), (8.0, 8.0)];
        let particles = particles.map(|(x, y)| at(0, x, y)).to_vec();
        let scene = Scene::new(10.0 * CUTOFF, particles).expect("all particles are in the box");
        let mut after = scene.particles().to_vec();
        let mut counts = Table::new(["threads", "pairs within the cutoff", "pair tests"]);
        for threads in [1, 2, 3] {
            let mut engine = Vanilla::<Tally>::new(threads);
            engine.load(&scene);
            engine.step();
            engine.read(0, &mut after);
            let seen = Simulation::statistics(&engine).expect("a tally returns statistics");
            counts.row([&threads, &seen.navg, &seen.pair_tests]);
        }
        let mut table =
            Table::new(["particle", "x / cutoff", "y / cutoff", "vx after", "vy after"]);
        for (p, after) in scene.particles().iter().zip(&after) {
            let [x, y] = [p.x, p.y].map(|along| number(along / CUTOFF));
            table.row([&p.id, &x, &y, &number(after.vx), &number(after.vy)]);
        }
        format!("{table}\n{counts}")
    });
}

/// Returns a part that has tested four pairs. If `r` is given, the part has seen a pair at a
/// distance of `r` cutoffs from both sides.
fn part(r: Option<f64>) -> Tally {
    let mut tally = Tally::default();
    tally.tested(4);
    for r in r.into_iter().flat_map(|r| [r, r]) {
        tally.seen((r * CUTOFF) * (r * CUTOFF));
    }
    tally
}

pub(crate) fn sums(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let parts = [part(Some(0.5)), part(Some(0.25)), part(None)];
        let all: Vec<Statistics> = parts.iter().map(statistics).collect();
        let mut table = Table::new(["", "dmin", "davg", "navg", "pair tests"]);
        let mut row = |name: &str, s: &Statistics| {
            let [dmin, davg] = [s.dmin, s.davg].map(|distance| format!("{distance:.2}"));
            table.row([&name, &dmin, &davg, &s.navg, &s.pair_tests]);
        };
        for (number, part) in all.iter().enumerate() {
            row(&format!("part {number}"), part);
        }
        let pool = pool(2);
        row("under a lock", &statistics(&pool.install(|| under_a_lock(&parts))));
        row("with atomics", &pool.install(|| with_atomics(&all)));
        row("in order", &statistics(&pool.install(|| in_order(&parts))));
        format!("{table}\n{}", interrupted())
    });
}

/// Shows one addition to the sum of distances that another thread interrupts.
fn interrupted() -> Table {
    let mut table =
        Table::new(["davg before", "part", "times that another thread adds 0.25", "davg after"]);
    for times in [0, 1, 2, 3] {
        let total = AtomicStatistics {
            davg: Word::new(1.0_f64.to_bits()).interrupted(at_first(times, add_quarter)),
            ..AtomicStatistics::default()
        };
        total.add(&Statistics { dmin: 0.5, davg: 0.5, navg: 1, pair_tests: 4 });
        table.row([&"1.00", &"0.50", &times, &format!("{:.2}", total.sum().davg)]);
    }
    table
}

/// Returns the rows of each of `workers` workers.
fn rows_of_all(rows: usize, workers: usize) -> impl Iterator<Item = Range<usize>> {
    (0..workers).map(move |worker| own_rows(worker, workers, rows))
}

pub(crate) fn rows(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let mut even = Table::new(["rows", "workers", "own rows of each worker"]);
        for (rows, workers) in [(6, 1), (6, 2), (6, 3), (2, 2)] {
            let own: Vec<_> = rows_of_all(rows, workers).map(|own| format!("{own:?}")).collect();
            even.row([&rows, &workers, &own.join(", ")]);
        }
        let mut uneven =
            Table::new(["rows", "workers", "numbers of rows, ascending", "rows without one owner"]);
        for (rows, workers) in [(7, 2), (10, 4), (2, 5)] {
            let owners = |row| rows_of_all(rows, workers).filter(|own| own.contains(&row)).count();
            let lost = (0..rows).filter(|row| owners(*row) != 1).count();
            let counts = rows_of_all(rows, workers).map(|own| own.len());
            uneven.row([&rows, &workers, &ascending(counts), &lost]);
        }
        format!("{even}\n{uneven}")
    });
}

pub(crate) fn forces_of_workers(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let places = [(0.5, 0.5), (1.1, 0.5), (2.5, 0.8), (2.5, 1.3), (0.5, 1.9), (0.5, 2.4)];
        let particles: Vec<Particle> = (0..).zip(places).map(|(id, (x, y))| at(id, x, y)).collect();
        let mut bins = VecBins::new(of_cutoffs(3));
        bins.refill(&particles);
        let mut table =
            Table::new(["worker", "own rows", "particle", "x / cutoff", "y / cutoff", "ax", "ay"]);
        let mut counts = Table::new(["worker", "row", "pairs within the cutoff", "pair tests"]);
        for (worker_number, rows) in [0..2, 2..3].into_iter().enumerate() {
            let mut worker = Worker::<Tally>::new(rows.clone());
            worker.sum_forces(&bins);
            let own = bins.bins()[3 * rows.start..3 * rows.end].iter().flatten();
            for (p, a) in own.zip(&worker.accelerations) {
                let [x, y, ax, ay] = [p.x / CUTOFF, p.y / CUTOFF, a.x, a.y].map(number);
                table.row([&worker_number, &format!("{rows:?}"), &p.id, &x, &y, &ax, &ay]);
            }
            for (row, seen) in rows.zip(worker.seen.iter().map(statistics)) {
                counts.row([&worker_number, &row, &seen.navg, &seen.pair_tests]);
            }
        }
        format!("{table}\n{counts}")
    });
}

/// Returns two particles in each of four rows of bins. Particles 1 and 3 fly up by a row in each
/// step, and particle 4 flies down.
fn eight() -> Vec<Particle> {
    let particle = |id: u32| {
        let rows_per_step = [0.0, 1.0, 0.0, 1.0, -1.0, 0.0, 0.0, 0.0][id as usize];
        let x = 0.25 + 0.5 * f64::from(id);
        let y = f64::from(id / 2) + 0.5;
        Particle { x, y, vx: 0.0, vy: rows_per_step / DT, id }
    };
    (0..8).map(particle).collect()
}

/// Returns an acceleration that takes particle 6 into the bin to its left, and zero for the others.
fn push_6(p: &Particle) -> Vec2 {
    Vec2::new(if p.id == 6 { -1.0 / (DT * DT) } else { 0.0 }, 0.0)
}

pub(crate) fn change_buffers(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let mut bins = VecBins::new(Grid::with_bins_along(4.0, 4));
        bins.refill(&eight());
        let grid = *bins.grid();
        let headings =
            ["worker", "own rows", "bins before", "bins after", "buffer before", "buffer after"];
        let mut table = Table::new(headings);
        for (number, rows) in [0..2, 2..4].into_iter().enumerate() {
            let mut worker = Worker::<NoStatistics>::new(rows.clone());
            let own = &mut bins.bins_mut()[4 * rows.start..4 * rows.end];
            worker.accelerations = own.iter().flatten().map(push_6).collect();
            worker.changed.push(Particle { id: 9, ..Particle::default() });
            let [inside, buffer] = [row_by_row(&grid, own), ids(&worker.changed)];
            worker.move_particles(&grid, own);
            let to = |p: &Particle| format!("{} to bin {}", p.id, grid.bin(p));
            worker.changed.sort_by_key(|p| p.id);
            let left = worker.changed.iter().map(to).collect::<Vec<_>>().join(", ");
            table.row([
                &number,
                &format!("{rows:?}"),
                &inside,
                &row_by_row(&grid, own),
                &buffer,
                &left,
            ]);
        }
        table.to_string()
    });
}

pub(crate) fn both_loops(ask: &mut impl Ask) {
    ask.example(|| {
        // Particle 2 flies up by a cutoff in each step.
        let flying = Particle { vy: CUTOFF / DT, ..at(2, 2.5, 1.8) };
        let particles = [at(0, 0.8, 0.5), at(1, 1.3, 0.5), flying, at(3, 1.5, 3.5)];
        let mut bins = VecBins::new(of_cutoffs(4));
        bins.refill(&particles);
        let workers = [0..2, 2..4].map(|rows| Box::new(Worker::<NoStatistics>::new(rows)));
        let mut workers = Vec::from(workers);
        pool(2).install(|| sum_and_move(&mut workers, &mut bins));
        let mut table =
            Table::new(["particle", "", "x / cutoff", "y / cutoff", "vx", "vy", "is in"]);
        let mut row = |p: &Particle, when: &str, place: &str| {
            let [x, y] = [p.x, p.y].map(|along| format!("{:.2}", along / CUTOFF));
            table.row([&p.id, &when, &x, &y, &number(p.vx), &number(p.vy), &place]);
        };
        for before in &particles {
            row(before, "before", "its bin");
            let id = before.id;
            bins.particles().filter(|p| p.id == id).for_each(|p| row(p, "after", "its bin"));
            for (number, worker) in workers.iter().enumerate() {
                let buffer = format!("buffer of worker {number}");
                let own = worker.changed.iter().filter(|p| p.id == id);
                own.for_each(|p| row(p, "after", &buffer));
            }
        }
        table.to_string()
    });
}
