//! Questions about the tasks of one worker, and about the loops over all workers.

use std::ops::Range;

use common::Vec2;
use common::soft::{CUTOFF, NoStatistics, Observer, Particle};
use lab3::{Worker, pool, sum_and_move};
use oracle::scenes::anywhere;
use oracle::{Ask, Model, Random, integers, truth};
use solution1::{Tally, advance};
use solution2::{Gather, Grid, VecBins};

use super::bins::states;

/// Draws a range of a grid's rows, sometimes empty.
pub(crate) fn some_rows(random: &mut Random, along: usize) -> Range<usize> {
    let start = random.below(along);
    start..start + random.below(3).min(1) * (1 + random.below(along - start))
}

/// Particles in a box, and a worker's rows.
struct Case {
    grid: Grid,
    particles: Vec<Particle>,
    rows: Range<usize>,
}

impl Case {
    /// Draws bins a little wider than a cutoff, and `n` particles close together, at a wall or
    /// anywhere.
    fn drawn(random: &mut Random, along: usize, n: usize) -> Self {
        let size = 1.02 * along as f64 * CUTOFF;
        let extent = size.min(CUTOFF * (n as f64 / random.magnitude(0.3, 10.0)).sqrt().max(1.0));
        // The last bins of a wide box have large numbers.
        let corners =
            [n % 2, n % 3].map(|at| (size - extent) * [0.0, random.between(0.0, 1.0), 1.0][at]);
        let mut particle = |id| {
            let [x, y] = corners.map(|low| random.between(low, (low + extent).min(size)));
            Particle { x, y, id, ..Particle::default() }
        };
        let particles: Vec<Particle> = (0..n as u32).map(&mut particle).collect();
        let grid = Grid::with_bins_along(size, along);
        let rows = match particles.iter().map(|p| grid.row(p.y)).min() {
            Some(lowest) if n % 3 == 2 => lowest..along,
            _ => some_rows(random, along),
        };
        Self { grid, particles, rows }
    }

    fn bins(&self) -> VecBins {
        let mut bins = VecBins::new(self.grid);
        bins.refill(&self.particles);
        bins
    }

    /// Returns the particles of a row, in the order of bins.
    fn row(bins: &VecBins, row: usize) -> impl Iterator<Item = &Particle> {
        let columns = bins.grid().columns();
        bins.bins()[row * columns..][..columns].iter().flatten()
    }

    /// Returns the accelerations of the worker's particles.
    fn felt(&self, bins: &VecBins) -> Vec<f64> {
        let mut model = Model::from_state(self.grid.size(), self.particles.clone());
        model.step();
        let own = self.rows.clone().flat_map(|row| Self::row(bins, row));
        own.map(|p| model.accelerations[p.id as usize]).flat_map(|a| [a.x, a.y]).collect()
    }

    /// Returns for each row the number of pairs within the cutoff, and the number of pairs of
    /// particles whose bins touch.
    fn seen(&self, bins: &VecBins) -> Vec<f64> {
        let grid = &self.grid;
        let mut counts = Vec::new();
        let Range { start, end } = self.rows;
        for row in start..end {
            let mut count = [0; 2];
            for (p, q) in
                Self::row(bins, row).flat_map(|p| self.particles.iter().map(move |q| (p, q)))
            {
                let apart = p.to(q).norm_squared();
                count[0] += usize::from(apart > 0.0 && apart <= CUTOFF * CUTOFF);
                let columns = grid.column(p.x).abs_diff(grid.column(q.x));
                count[1] += usize::from(columns.max(row.abs_diff(grid.row(q.y))) <= 1);
            }
            counts.extend(count);
        }
        integers(counts)
    }

    fn name(&self) -> String {
        let n = self.particles.len();
        let along = self.grid.rows();
        format!("{n} particles in {along} rows of bins, a worker with rows {:?}", self.rows)
    }
}

/// Returns the pairs within the cutoff and the pair tests of each tally.
pub(crate) fn counts(seen: &[Tally]) -> Vec<f64> {
    let seen = seen.iter().map(|tally| tally.statistics().expect("a tally returns statistics"));
    integers(seen.flat_map(|s| [s.navg as usize, s.pair_tests as usize]))
}

/// Asks for the forces on the particles of some rows. One worker repeats this several times,
/// finally with fewer particles.
pub(crate) fn forces(random: &mut Random, ask: &mut impl Ask) {
    for (along, most) in [(5, 1025), (300, 257)] {
        let mut worker = Worker::<Tally>::new(0..0);
        for n in random.sizes(most).into_iter().chain([9, 0, 1]) {
            let case = Case::drawn(random, along, n);
            let bins = case.bins();
            worker.rows = case.rows.clone();
            worker.sum_forces(&bins);
            let found = || worker.accelerations.iter().flat_map(|a| [a.x, a.y]).collect();
            let question = format!("{}: ax, ay of each of the worker's particles", case.name());
            ask.exact(&question, found, || case.felt(&bins));
            let question = format!(
                "{}: for each row of the worker, (1) the pairs within the cutoff, (2) the pair tests that the row \
                 reports",
                case.name()
            );
            ask.exact(&question, || counts(&worker.seen), || case.seen(&bins));
        }
    }
    let mut worker = Worker::<Tally>::new(0..1);
    let mut bins = VecBins::new(Grid::with_bins_along(2.0 * CUTOFF, 1));
    bins.refill(&[0.0, 0.5].map(|x| Particle { x: x * CUTOFF, ..Particle::default() }));
    bins.bins_mut()[0][1].id = 1;
    worker.sum_forces(&bins);
    // `gather` remembers the neighbours of the last particle.
    let is_used = format!("{:?}", worker.gather) != format!("{:?}", Gather::default());
    let question = "two particles within the cutoff: 1 if the worker's own `gather` has summed their forces, 0 if not";
    ask.exact(question, || vec![truth(is_used)], || vec![1.0]);
}

/// The bins of a worker's rows, and an acceleration for each particle in them.
struct Moving {
    grid: Grid,
    rows: Range<usize>,
    own: Vec<Vec<Particle>>,
    accelerations: Vec<Vec2>,
}

impl Moving {
    fn drawn(random: &mut Random, along: usize, n: usize) -> Self {
        let Case { grid, particles, rows } = Case::drawn(random, along, n);
        let first = rows.start * along;
        let mut own = vec![Vec::new(); rows.len() * along];
        for p in particles.into_iter().filter(|p| rows.contains(&grid.row(p.y))) {
            let [vx, vy] = [(); 2].map(|()| random.between(-15.0, 15.0));
            own[grid.bin(&p) - first].push(Particle { vx, vy, ..p });
        }
        let mut push = |_| Vec2::new(random.between(-99.0, 99.0), random.between(-99.0, 99.0));
        let accelerations = own.iter().flatten().map(&mut push).collect();
        Self { grid, rows, own, accelerations }
    }

    fn name(&self) -> String {
        let n = self.accelerations.len();
        let along = self.grid.rows();
        format!("{n} particles in rows {:?} of {along}", self.rows)
    }

    /// Returns the particles that stay in their bins after the move, or the particles that leave
    /// them.
    fn moved(&self, stay: bool) -> Vec<f64> {
        let mut all = Vec::new();
        for (p, a) in self.own.iter().flatten().zip(&self.accelerations) {
            let mut moved = *p;
            advance(&mut moved, *a, self.grid.size());
            if (self.grid.bin(&moved) == self.grid.bin(p)) == stay {
                all.push(moved);
            }
        }
        states(&all)
    }
}

/// Asks for the moves of the particles of some rows. One worker repeats this several times, finally
/// with fewer particles.
pub(crate) fn moves(random: &mut Random, ask: &mut impl Ask) {
    for (along, most) in [(5, 1025), (300, 257)] {
        let mut worker = Worker::<NoStatistics>::new(0..0);
        for n in random.sizes(most).into_iter().chain([9, 0, 1]) {
            let case = Moving::drawn(random, along, n);
            let mut own = case.own.clone();
            worker.rows = case.rows.clone();
            worker.accelerations.clone_from(&case.accelerations);
            worker.changed.push(Particle { id: 7777, ..Particle::default() });
            worker.move_particles(&case.grid, &mut own);
            let question =
                format!("{}: id x y vx vy of each particle that stays in its bin", case.name());
            ask.exact(&question, || states(own.iter().flatten()), || case.moved(true));
            let question = format!(
                "{}: id x y vx vy of each particle in the change buffer, which contained particle 7777 before this \
                 step",
                case.name()
            );
            ask.exact(&question, || states(&worker.changed), || case.moved(false));
        }
    }
}

/// Asks about both loops over few and many workers, some without rows.
pub(crate) fn loops(random: &mut Random, ask: &mut impl Ask) {
    for count in [1, 2, 3, 9, 33, 257] {
        let scene = anywhere(random, 300, 9.2 * CUTOFF, 15.0);
        let mut bins = VecBins::of_scene(&scene, 1.0);
        bins.refill(scene.particles());
        let cut = |k: usize| k * bins.grid().rows() / count;
        let workers = (0..count).map(|k| Box::new(Worker::<NoStatistics>::new(cut(k)..cut(k + 1))));
        let mut workers: Vec<_> = workers.collect();
        pool(3).install(|| sum_and_move(&mut workers, &mut bins));
        let question = format!(
            "300 particles and {count} workers: id x y vx vy of each particle in bins and buffers after both loops"
        );
        let changed = workers.iter().flat_map(|worker| &worker.changed);
        ask.exact(
            &question,
            || states(bins.particles().chain(changed)),
            || {
                let mut model = Model::new(&scene);
                model.step();
                states(&model.particles)
            },
        );
    }
}
