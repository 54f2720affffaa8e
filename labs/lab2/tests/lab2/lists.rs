//! Questions about linked lists and pairs that are tested once, tasks 2.6 and 2.7.

use common::soft::{CUTOFF, Particle, Scene, Simulation};
use lab2::{BinLists, Grid, LinkedList, forward};
use oracle::{Ask, Count, Random, integers};

use super::particles::{binned, in_any_order};

/// Asks about lists that are cleared and refilled in any order. The particle that was inserted last
/// comes first.
pub(crate) fn lists(random: &mut Random, ask: &mut impl Ask) {
    let sizes = [random.sizes(4097), vec![70_000]].concat();
    for n in sizes.into_iter().filter(|&n| n > 0) {
        // A bin has some 256 particles at most, so that the answers fit into the grader's file.
        let bins = 1 + n / 256 + random.size(300);
        let mut lists = BinLists::new(bins, n);
        for round in 0..3 {
            // The first round inserts all particles.
            let some = if round == 0 { n } else { random.below(n + 1) };
            let filled = Filled::drawn(random, bins, n, some);
            filled.ask(&mut lists, &format!("round {round}, {n} particles in {bins} bins"), ask);
        }
    }
}

/// Particles inserted into lists, in this order.
struct Filled {
    bins: usize,
    inserts: Vec<Insert>,
}

#[derive(Clone, Copy)]
struct Insert {
    bin: usize,
    particle: usize,
}

impl Filled {
    fn drawn(random: &mut Random, bins: usize, n: usize, some: usize) -> Self {
        let mut order: Vec<usize> = (0..n).collect();
        random.shuffle(&mut order);
        let insert = |particle: usize| Insert { bin: random.below(bins), particle };
        Self { bins, inserts: order.into_iter().take(some).map(insert).collect() }
    }

    fn ask(&self, lists: &mut BinLists, name: &str, ask: &mut impl Ask) {
        lists.clear();
        for insert in &self.inserts {
            lists.insert(insert.bin, insert.particle);
        }
        // The limit ends a list that leads back to itself.
        let most = self.inserts.len() + 1;
        for bin in 0..self.bins {
            let question = format!("{name}: particles in the list of bin {bin}");
            ask.exact(
                &question,
                || integers(lists.bin(bin).take(most)),
                || integers(self.list(bin)),
            );
        }
        for one in self.inserts.iter().step_by(1 + self.inserts.len() / 300) {
            let question =
                format!("{name}: particles that come after particle {} in its list", one.particle);
            let found = || integers(lists.after(one.particle).take(most));
            ask.exact(&question, found, || {
                integers(self.list(one.bin).skip_while(|&p| p != one.particle).skip(1))
            });
        }
    }

    /// Returns the particles of a bin, the last inserted particle first.
    fn list(&self, bin: usize) -> impl Iterator<Item = usize> {
        let own = self.inserts.iter().rev().filter(move |insert| insert.bin == bin);
        own.map(|insert| insert.particle)
    }
}

/// Asks for the bins that come after a given bin, at walls, in corners and anywhere.
pub(crate) fn forwards(random: &mut Random, ask: &mut impl Ask) {
    for along in [1, 2, 3, 4, 256, 300, 70_000, 1 << 30] {
        let grid = Grid::with_bins_along(1.0, along);
        for _ in 0..40 {
            let row = any_index(random, along);
            let column = any_index(random, along);
            let question = format!(
                "the bin in row {row}, column {column} of {along} rows: neighbouring bins that come after this bin, \
                 in ascending order"
            );
            let found = || {
                let mut bins = [0; 4];
                let count = forward(&grid, row, column, &mut bins).min(4);
                in_any_order(integers(bins[..count].to_vec()))
            };
            ask.exact(&question, found, || bins_after(along, row, column));
        }
    }
}

/// Draws the first index, the last, or a random index.
fn any_index(random: &mut Random, along: usize) -> usize {
    [0, along - 1, random.below(along)][random.below(3)]
}

fn bins_after(along: usize, row: usize, column: usize) -> Vec<f64> {
    let ahead = [(0, column + 1), (1, column.wrapping_sub(1)), (1, column), (1, column + 1)];
    let there = ahead.into_iter().filter(|&(up, to)| row + up < along && to < along);
    integers(there.map(|(up, to)| (row + up) * along + to))
}

/// Asks about boxes of one bin, or of four bins that all touch, where each pair is tested once.
pub(crate) fn looks(random: &mut Random, ask: &mut impl Ask) {
    forward(&Grid::with_bins_along(1.0, 1), 0, 0, &mut [0; 4]);
    let sizes = random.sizes(4097).into_iter().filter(|&n| n > 0);
    for (n, along) in sizes.flat_map(|n| [(n, 1), (n, 2)]) {
        let size = 1.1 * along as f64 * CUTOFF;
        let all = binned(random, along, &(0..along), n).into_iter().map(|one| one.particle);
        let particles = all.map(|p| Particle { x: p.x * size, y: p.y * size, ..p }).collect();
        let mut engine = LinkedList::<Count>::new(1.0);
        engine.load(&Scene::new(size, particles).expect("all particles are in the box"));
        engine.step();
        let reported = engine.statistics().map_or(0, |seen| seen.pair_tests);
        let question = format!(
            "{n} particles in {along} rows of bins, in which every bin touches every other bin: number of pair tests"
        );
        ask.exact(&question, || integers([reported as usize]), || integers([n * (n - 1) / 2]));
    }
}
