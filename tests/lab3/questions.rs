//! What tests and probe ask alike, with drawn inputs and what a plain model says.

use std::ops::Range;
use std::sync::Arc;

use common::Vec2;
use common::soft::{CUTOFF, NoStatistics, Observer, Particle, Simulation, Statistics};
use lab3::{
    Atomic, AtomicStatistics, BLOCK, Memory, Notice, Vanilla, Worker, own_rows, pool, rebin_by_one,
    sum_and_move, take_arrivals, take_posted,
};
use parking_lot::Mutex;
use solution1::{Tally, advance};
use solution2::{Gather, Grid, SortedBins, VecBins};

use super::ask::{Ask, rounded, whole};
use super::{Model, anywhere, on_edges};
use crate::Random;

/// id x y vx vy of particles, in the order of ids.
fn states<'a>(particles: impl IntoIterator<Item = &'a Particle>) -> Vec<f64> {
    let mut all: Vec<&Particle> = particles.into_iter().collect();
    all.sort_by_key(|p| p.id);
    all.iter().flat_map(|p| [f64::from(p.id), p.x + 0.0, p.y + 0.0, p.vx, p.vy]).collect()
}

/// A step of any number of particles on some threads, and then of a few; and what was looked at.
pub(super) fn all_pairs(random: &mut Random, ask: Ask<'_>) {
    for threads in [1, 2, 3, 7] {
        let mut engine = Vanilla::<Tally>::new(threads);
        let sizes = [random.sizes(1025), vec![3, 1]].concat();
        for n in sizes.into_iter().filter(|&n| n > 0) {
            let crowd = random.magnitude(0.3, 10.0);
            let scene = anywhere(random, n, CUTOFF * (n as f64 / crowd).sqrt().max(1.0), 1.0);
            let mut model = Model::new(&scene);
            model.step();
            engine.load(&scene);
            // The sum of the step begins anew.
            engine.sum_forces();
            engine.step();
            let mut found = vec![Particle::default(); n];
            engine.read(0, &mut found);
            let name = format!("a step of {n} particles on {threads} threads");
            let question = format!("{name}: id x y vx vy of each");
            ask(&question, states(&found), states(&model.particles));
            let told = Simulation::statistics(&engine).map_or(0, |s| s.pair_tests) as usize;
            let question = format!("{name}: how many pairs the observers were told of");
            ask(&question, whole([told]), whole([n * n]));
        }
    }
}

/// One part after the other: counts of any size, least distances and sums of any magnitude.
pub(super) fn atomics(random: &mut Random, ask: Ask<'_>) {
    for case in 0..200 {
        let total = AtomicStatistics::default();
        let mut right = Statistics::default();
        for _ in 0..random.below(9) {
            let mut count = || random.bits() >> (12 + random.below(50));
            let (navg, pair_tests) = (count(), count());
            let (dmin, davg) = (random.magnitude(1e-12, 1.0), random.magnitude(1e-9, 1e9));
            total.add(&Statistics { dmin, davg, navg, pair_tests });
            right.dmin = right.dmin.min(dmin);
            right.davg += davg;
            right.navg += navg;
            right.pair_tests += pair_tests;
        }
        let found = total.sum();
        let counts = |s: Statistics| whole([s.navg as usize, s.pair_tests as usize]);
        ask(&format!("sum {case}: navg and pair tests"), counts(found), counts(right));
        let reals = |s: Statistics| vec![s.dmin, s.davg];
        ask(&format!("sum {case}: dmin and davg"), reals(found), reals(right));
    }
}

/// Statistics whose sum depends, in its last digits, on the order in which they are added.
pub(super) fn parts(count: usize) -> Vec<Tally> {
    let part = |i: usize| {
        let mut tally = Tally::default();
        tally.tested(i as u64);
        tally.seen(CUTOFF * CUTOFF * (0.02 + 0.9 * (i as f64 * 0.618).fract()));
        tally
    };
    (0..count).map(part).collect()
}

pub(super) fn statistics(tally: &Tally) -> Statistics {
    tally.statistics().expect("a tally has statistics")
}

/// The sum of few and many parts on few and many threads: by blocks to the bit, or in any order.
pub(super) fn reductions(how: &str, ask: Ask<'_>, reduce: impl Fn(&[Tally]) -> Statistics + Sync) {
    for count in [0, 1, BLOCK - 1, BLOCK, BLOCK + 1, 1000, 70_000] {
        let parts = parts(count);
        let sum = |sum: Tally, part: &Tally| {
            let mut sum = sum;
            sum.merge(part);
            sum
        };
        let blocks = parts.chunks(BLOCK).map(|block| block.iter().fold(Tally::default(), sum));
        let right = statistics(&blocks.fold(Tally::default(), |all, block| sum(all, &block)));
        for threads in [1, 2, 3, 4, 8] {
            let found = pool(threads).install(|| reduce(&parts));
            let davg = match how {
                "in order" => found.davg,
                _ => rounded(found.davg, right.davg, right.davg),
            };
            let told = |s: Statistics, davg| vec![s.dmin, davg, s.navg as f64, s.pair_tests as f64];
            let question = format!(
                "{count} parts {how}, in blocks of {BLOCK}, on {threads} threads: dmin, davg, navg, pair tests"
            );
            ask(&question, told(found, davg), told(right, right.davg));
        }
    }
}

/// Any rows of a grid, now and then none.
fn some_rows(random: &mut Random, along: usize) -> Range<usize> {
    let start = random.below(along);
    start..start + random.below(3).min(1) * (1 + random.below(along - start))
}

/// A grid of bins a little wider than a cutoff, and `n` particles in a corner, in the middle or anywhere in it.
fn in_a_grid(random: &mut Random, along: usize, n: usize) -> (Grid, Vec<Particle>) {
    let size = 1.02 * along as f64 * CUTOFF;
    let extent = size.min(CUTOFF * (n as f64 / random.magnitude(0.3, 10.0)).sqrt().max(1.0));
    let mut corner = || (size - extent) * [0.0, random.between(0.0, 1.0), 1.0][random.below(3)];
    let (left, low) = (corner(), corner());
    let mut at = |low: f64| random.between(low, (low + extent).min(size));
    let particle = |id| Particle { x: at(left), y: at(low), id, ..Particle::default() };
    (Grid::with_bins_along(size, along), (0..n as u32).map(particle).collect())
}

/// The forces on the particles of some rows, by one worker again and again, at last with less.
pub(super) fn forces(random: &mut Random, ask: Ask<'_>) {
    for (along, most) in [(5, 1025), (300, 257)] {
        let mut worker = Worker::<Tally>::new(0..0);
        for n in random.sizes(most).into_iter().chain([9, 0, 1]) {
            let (grid, particles) = in_a_grid(random, along, n);
            let mut bins = VecBins::new(grid);
            bins.refill(&particles);
            worker.rows = some_rows(random, along);
            worker.sum_forces(&bins);
            let (mut right, mut seen, mut gather) = (Vec::new(), Vec::new(), Gather::default());
            for row in worker.rows.clone() {
                let mut tally = Tally::default();
                for p in bins.bins()[row * along..(row + 1) * along].iter().flatten() {
                    let a = gather.acceleration(p, bins.around(p), &mut tally);
                    right.extend([a.x, a.y]);
                }
                seen.push(tally);
            }
            let name = format!("{n} particles in {along} rows, a worker with {:?}", worker.rows);
            let found = worker.accelerations.iter().flat_map(|a| [a.x, a.y]).collect();
            ask(&format!("{name}: the accelerations of its particles"), found, right);
            let told = |seen: &[Tally]| {
                let seen = seen.iter().map(|tally| tally.statistics().expect("it counts"));
                whole(seen.flat_map(|s| [s.navg as usize, s.pair_tests as usize]))
            };
            let question = format!("{name}: pairs within the cutoff and looked at, of each row");
            ask(&question, told(&worker.seen), told(&seen));
        }
    }
}

/// Particles of some rows move and leave their bins or not, by one worker again and again, at last with less.
pub(super) fn moves(random: &mut Random, ask: Ask<'_>) {
    for (along, most) in [(5, 1025), (300, 257)] {
        let mut worker = Worker::<NoStatistics>::new(0..0);
        for n in random.sizes(most).into_iter().chain([9, 0, 1]) {
            let (grid, mut particles) = in_a_grid(random, along, n);
            let rows = some_rows(random, along);
            let first = rows.start * along;
            let mut own = vec![Vec::new(); rows.len() * along];
            particles.retain(|p| rows.contains(&grid.row(p.y)));
            for p in &mut particles {
                (p.vx, p.vy) = (random.between(-15.0, 15.0), random.between(-15.0, 15.0));
                own[grid.bin(p) - first].push(*p);
            }
            let mut any = || random.between(-99.0, 99.0);
            let push = |_: &Particle| Vec2::new(any(), any());
            let accelerations: Vec<Vec2> = own.iter().flatten().map(push).collect();
            let (mut stay, mut left) = (Vec::new(), Vec::new());
            for (p, a) in own.iter().flatten().zip(&accelerations) {
                let mut moved = *p;
                advance(&mut moved, *a, grid.size());
                if grid.bin(&moved) == grid.bin(p) { &mut stay } else { &mut left }.push(moved);
            }
            (worker.rows, worker.accelerations) = (rows, accelerations);
            worker.changed.push(Particle { id: 7777, ..Particle::default() });
            worker.move_particles(&grid, &mut own);
            let name =
                format!("{} particles in rows {:?} of {along}", particles.len(), worker.rows);
            let question = format!("{name}: id x y vx vy of those that stay in their bins");
            ask(&question, states(own.iter().flatten()), states(&stay));
            let question = format!("{name}: id x y vx vy in the change buffer, 7777 from before");
            ask(&question, states(&worker.changed), states(&left));
        }
    }
}

/// A step of few workers and of many, some of them without rows.
pub(super) fn loops(random: &mut Random, ask: Ask<'_>) {
    for count in [1, 2, 3, 9, 33, 257] {
        let scene = anywhere(random, 300, 9.2 * CUTOFF, 15.0);
        let mut model = Model::new(&scene);
        model.step();
        let mut bins = VecBins::of_scene(&scene, 1.0);
        bins.refill(scene.particles());
        let cut = |k: usize| k * bins.grid().rows() / count;
        let new = |k| Box::new(Worker::<NoStatistics>::new(cut(k)..cut(k + 1)));
        let mut workers: Vec<_> = (0..count).map(new).collect();
        pool(3).install(|| sum_and_move(&mut workers, &mut bins));
        let found = bins.particles().chain(workers.iter().flat_map(|worker| &worker.changed));
        let question = format!("a step of {count} workers: id x y vx vy in bins and buffers");
        ask(&question, states(found), states(&model.particles));
    }
}

/// Mail to a member by any number of others, some of which have none.
pub(super) fn mail(random: &mut Random, ask: Ask<'_>) {
    for case in 0..60 {
        let along = [6, 300][case % 2];
        let rows = some_rows(random, along - 1);
        let rows = rows.start..rows.end + 1;
        let grid = Grid::with_bins_along(1.0, along);
        let (members, mut id) = (1 + random.size(40), 0);
        let number = random.below(members);
        let mut letter = |random: &mut Random| {
            id += 1;
            let row = rows.start + random.below(rows.len());
            let y = (row as f64 + random.between(0.05, 0.95)) / along as f64;
            Particle { x: random.between(0.0, 1.0), y, id, ..Particle::default() }
        };
        let mut bins = SortedBins::new(grid, rows.clone());
        let own = random.size(33);
        bins.refill((0..own).map(|_| letter(random)));
        // They have moved within the rows.
        bins.particles_mut().iter_mut().for_each(|p| *p = Particle { id: p.id, ..letter(random) });
        let mut mail: Vec<Vec<Mutex<Vec<Particle>>>> = Vec::new();
        for _ in 0..members {
            let count = random.below(2) * random.size(if members < 4 { 4097 } else { 9 });
            let mut to: Vec<_> = (0..members).map(|_| Mutex::new(vec![letter(random)])).collect();
            to[number] = Mutex::new((0..count).map(|_| letter(random)).collect());
            mail.push(to);
        }
        let posted = mail.iter().flat_map(|to| to[number].lock().clone()).collect::<Vec<_>>();
        let right = states(bins.particles().iter().chain(&posted));
        take_posted(&mut bins, number, &mail);
        let name = format!(
            "{own} own particles and {} posted by {members} members, some by none",
            posted.len()
        );
        let question = format!("{name}: id x y vx vy of all");
        ask(&question, states(bins.particles()), right);
        let (mut astray, mut held) = (0, 0);
        for (row, column) in rows.flat_map(|row| (0..along).map(move |column| (row, column))) {
            let is_here = |p: &&Particle| (grid.row(p.y), grid.column(p.x)) == (row, column);
            astray += bins.bin(row, column).iter().filter(|p| !is_here(p)).count();
            held += bins.bin(row, column).len();
        }
        let all = own + posted.len();
        ask(&format!("{name}: particles that the bins hold"), whole([held]), whole([all]));
        ask(&format!("{name}: those that are not in their bin"), whole([astray]), whole([0]));
        let left = mail.iter().map(|to| to[number].lock().len()).sum();
        ask(&format!("{name}: letters left in the boxes"), whole([left]), whole([0]));
        let others: usize = mail.iter().flatten().map(|letters| letters.lock().len()).sum();
        let question = format!("{name}: letters to others, which are left alone");
        ask(&question, whole([others]), whole([members * (members - 1)]));
    }
}

/// Every row has one owner, in order, and no owner has more than a row more than another.
pub(super) fn rows(random: &mut Random, ask: Ask<'_>) {
    let few = (1..=64).flat_map(|workers| {
        [1, workers - 1, 61, 5 * workers, 9 * workers].map(|rows| (rows, workers))
    });
    // Many of both, and rows without end.
    let mut drawn = |most: usize| {
        let rows = if most == 300 { random.below(1 << 40) } else { random.size(most) };
        (rows, 1 + random.size(most))
    };
    let drawn: Vec<_> = (0..120).map(|case| drawn([70_000, 40, 300][case % 3])).collect();
    for (rows, workers) in few.chain(drawn) {
        let (mut next, mut sizes) = (0, Vec::new());
        let name = format!("{rows} rows among {workers} workers");
        for worker in 0..workers {
            let own = own_rows(worker, workers, rows);
            // Asked only where it is wrong, or the answers would be more than a page.
            if own.start != next {
                ask(&format!("{name}: worker {worker} begins"), whole([own.start]), whole([next]));
            }
            next = own.end;
            sizes.push(own.len());
        }
        ask(&format!("{name}: the end of the last one's"), whole([next]), whole([rows]));
        let uneven = sizes.iter().max().unwrap_or(&0) - sizes.iter().min().unwrap_or(&0);
        let question = format!("{name}: rows that one has more than another, beyond 1");
        ask(&question, whole([uneven.saturating_sub(1)]), whole([0]));
    }
}

/// A few particles on walls and edges of many bins, or many in a single bin, in many buffers or a few; and rows of
/// bins, in the first of which there is a particle before they come.
struct Leavers {
    grid: Grid,
    rows: Range<usize>,
    leavers: Vec<Particle>,
    resident: Particle,
    /// Where buffers end; some are empty.
    ends: Vec<usize>,
}

impl Leavers {
    fn drawn(random: &mut Random, case: usize) -> Self {
        let many = case % 10 == 9;
        let along = if many { 1 } else { [1 + random.size(40), 300][case % 2] };
        let n = if many { 65_537 } else { random.size(600) };
        let size = random.between(0.1, 9.0);
        let start = random.below(along);
        let rows = start..start + 1 + random.below(along - start);
        let leavers = on_edges(random, n, size, along);
        let middle = |bin: usize| (bin as f64 + 0.5) * (size / along as f64);
        let (x, y) = (middle(0), middle(rows.start));
        let resident = Particle { x, y, id: n as u32, ..Particle::default() };
        let grid = Grid::with_bins_along(size, along);
        // Many buffers or few; the first or the last is empty.
        let end = n * random.below(2);
        let most = [40, 1025][random.below(2)];
        let mut ends: Vec<usize> = (0..random.size(most)).map(|_| random.below(n + 1)).collect();
        ends.extend([0, n, end]);
        ends.sort_unstable();
        Self { grid, rows, leavers, resident, ends }
    }

    fn buffers(&self) -> impl Iterator<Item = &[Particle]> {
        self.ends.windows(2).map(|ends| &self.leavers[ends[0]..ends[1]])
    }

    fn name(&self) -> String {
        let (along, n, count) = (self.grid.rows(), self.leavers.len(), self.buffers().count());
        let size = self.grid.size();
        format!(
            "particles 0 to {n}, the last in its bin, the others in {count} buffers, some of them empty, {along} bins along {size:?}"
        )
    }

    /// Asks for the bins that each particle is in, of `bins`, which begin with the first of `rows`.
    fn ask(&self, rows: &Range<usize>, bins: &[Vec<Particle>], ask: Ask<'_>) {
        let first = rows.start * self.grid.columns();
        let mut found = vec![Vec::new(); self.leavers.len() + 1];
        for (bin, inside) in (first..).zip(bins) {
            inside.iter().for_each(|p| found[p.id as usize].push(bin));
        }
        let name = self.name();
        let mut all = [0; 2];
        for (p, found) in self.leavers.iter().chain([&self.resident]).zip(found) {
            let expected = rows.contains(&self.grid.row(p.y)).then(|| self.grid.bin(p));
            let expected: Vec<usize> = expected.into_iter().collect();
            all = [all[0] + found.len(), all[1] + expected.len()];
            if found != expected {
                let question = format!(
                    "{name}, those of rows {rows:?}: the bins that hold particle {} at ({:?}, {:?})",
                    p.id, p.x, p.y
                );
                return ask(&question, whole(found), whole(expected));
            }
        }
        ask(&format!("{name}: particles in rows {rows:?}"), whole([all[0]]), whole([all[1]]));
    }
}

/// All particles of all buffers go into their bins.
pub(super) fn by_one(random: &mut Random, ask: Ask<'_>) {
    for case in 0..60 {
        let leavers = Leavers::drawn(random, case);
        let mut bins = VecBins::new(leavers.grid);
        bins.put(leavers.resident);
        rebin_by_one(&mut bins, leavers.buffers());
        leavers.ask(&(0..leavers.grid.rows()), bins.bins(), ask);
    }
}

/// Those that lie in the own rows go into their bins.
pub(super) fn by_all(random: &mut Random, ask: Ask<'_>) {
    for case in 0..60 {
        let leavers = Leavers::drawn(random, case);
        let (grid, rows) = (leavers.grid, leavers.rows.clone());
        let mut own = vec![Vec::new(); rows.len() * grid.columns()];
        own[0].push(leavers.resident);
        take_arrivals(&grid, rows.start * grid.columns(), &mut own, leavers.buffers());
        leavers.ask(&rows, &own, ask);
    }
}

/// All that a thread may read while another one posts a notice, each with both threads' operations.
pub(super) fn readings(posted: &Statistics) -> Vec<(Option<Statistics>, String)> {
    let memory = Arc::new(Memory::default());
    let number = |name, bits| Atomic::watched(bits, &memory, name);
    let before = Statistics::default();
    let notice = Notice {
        dmin: number("dmin", before.dmin.to_bits()),
        davg: number("davg", before.davg.to_bits()),
        navg: number("navg", before.navg),
        pair_tests: number("pair_tests", before.pair_tests),
        posted: number("the flag", 0),
    };
    memory.readings(|| notice.post(posted), || notice.read())
}

/// Numbers of any size: what is posted, and what another thread may read meanwhile.
pub(super) fn notices(random: &mut Random, ask: Ask<'_>) {
    let numbers = |s: Statistics| vec![1.0, s.dmin, s.davg, s.navg as f64, s.pair_tests as f64];
    for case in 0..20 {
        let mut count = || random.bits() >> (12 + random.below(50));
        let (navg, pair_tests) = (count(), count());
        let (dmin, davg) = (random.magnitude(1e-12, 1.0), random.magnitude(1e-9, 1e9));
        let posted = Statistics { dmin, davg, navg, pair_tests };
        let notice = Notice::default();
        let nothing = notice.read().map_or(vec![0.0], numbers);
        ask(&format!("notice {case}: read before it is posted"), nothing, vec![0.0]);
        notice.post(&posted);
        let found = notice.read().map_or(vec![0.0], numbers);
        ask(&format!("notice {case}: read when it is posted"), found, numbers(posted));
        let readings = readings(&posted).into_iter();
        let mut readings: Vec<Vec<f64>> =
            readings.map(|(reading, _)| reading.map_or(vec![0.0], numbers)).collect();
        readings.sort_by(|a, b| a.partial_cmp(b).expect("numbers"));
        readings.dedup();
        let question = format!("notice {case}: all that is read while it is posted, or 0: nothing");
        ask(&question, readings.concat(), [vec![0.0], numbers(posted)].concat());
    }
}
