//! Questions about bins in one array and sums in the order of ids, tasks 2.8 and 2.9.

use std::f64::consts::TAU;

use common::Vec2;
use common::soft::{CUTOFF, Particle};
use lab2::{Gather, Grid, SortedBins};
use oracle::{Ask, Count, Random, acceleration_of_pair, integers};

use super::particles::{Binned, binned, ids, particles_of};

/// Asks about all or some rows of a grid, sorted repeatedly, with more particles and finally with
/// fewer.
pub(crate) fn sorts(random: &mut Random, ask: &mut impl Ask) {
    for (along, rows, most) in [
        (1, 0..1, 65_537),
        (7, 0..7, 1025),
        (7, 2..5, 257),
        (2, 1..2, 65_537),
        (300, 0..300, 257),
        (300, 250..300, 4097),
    ] {
        let mut bins = SortedBins::new(Grid::with_bins_along(1.0, along), rows.clone());
        // The particles are in random order, or in the order of their bins.
        let sizes = random.sizes(most).into_iter().chain([2, 0, 1, 0]);
        for (n, in_order) in sizes.flat_map(|n| [(n, false), (n, true)]) {
            let mut all = binned(random, along, &rows, n);
            if in_order {
                all.sort_by_key(|one| one.bin);
            }
            let order = if in_order { ", which come in the order of their bins" } else { "" };
            let name = format!("rows {rows:?} of {along} rows of bins, {n} particles{order}");
            sort(&mut bins, &all, &name, random, ask);
        }
    }
}

fn sort(
    bins: &mut SortedBins,
    all: &[Binned],
    name: &str,
    random: &mut Random,
    ask: &mut impl Ask,
) {
    bins.refill(particles_of(all));
    let question = format!(
        "{name}: particles in memory order. They must be bin by bin, and within a bin in the order in which they \
         came"
    );
    ask.exact(
        &question,
        || ids(bins.particles()),
        || {
            let mut all = all.to_vec();
            all.sort_by_key(|one| one.bin);
            ids(&particles_of(&all))
        },
    );
    let rows = bins.rows();
    for _ in 0..10 {
        let row = rows.start + random.below(rows.len());
        let column = random.below(bins.grid().columns());
        let bin = row * bins.grid().columns() + column;
        let question = format!(
            "{name}: indices at which the bin in row {row}, column {column} begins and ends"
        );
        let found = || {
            let span = bins.span(row, column..column + 1);
            integers([span.start, span.end])
        };
        ask.exact(&question, found, || {
            integers([bin, bin + 1].map(|end| all.iter().filter(|one| one.bin < end).count()))
        });
    }
}

/// Asks for the force on a particle by any number of candidates, finally without candidates. The
/// candidates are in several slices, in any order, with ids of any size. Many are within reach or
/// exactly at the cutoff.
pub(crate) fn sums(random: &mut Random, ask: &mut impl Ask) {
    let mut gather = Gather::default();
    let sizes: Vec<usize> = (0..12).flat_map(|_| random.sizes(1025)).chain([0]).collect();
    for (case, n) in sizes.into_iter().enumerate() {
        // The ids of the first cases are small, so that a message is easy to read.
        let most = if case < 20 { 1 } else { 4 };
        let apart = [1, 1 << 8, 1 << 16, u32::MAX as usize / (n + 1)][random.below(most)];
        let around = Around::drawn(random, n, apart as u32);
        around.ask(&mut gather, random, ask);
    }
}

/// A particle at (0, 0), and candidates in any order.
struct Around {
    particle: Particle,
    candidates: Vec<Particle>,
    at_the_cutoff: bool,
}

impl Around {
    /// Draws `n` candidates, whose ids are multiples of `apart`.
    fn drawn(random: &mut Random, n: usize, apart: u32) -> Self {
        let particle = Particle { id: random.below(n + 1) as u32 * apart, ..Particle::default() };
        let side = CUTOFF * random.magnitude(0.3, 10.0);
        let at_the_cutoff = random.below(3) == 0;
        let mut candidates = Vec::with_capacity(n);
        for id in (0..n as u32).map(|id| id * apart) {
            let at = match id == particle.id {
                true => Vec2::ZERO,
                false if at_the_cutoff => beside_the_cutoff(random),
                false => Vec2::new(random.between(-side, side), random.between(-side, side)),
            };
            candidates.push(Particle { x: at.x, y: at.y, id, ..particle });
        }
        random.shuffle(&mut candidates);
        Self { particle, candidates, at_the_cutoff }
    }

    fn ask(&self, gather: &mut Gather, random: &mut Random, ask: &mut impl Ask) {
        let n = self.candidates.len();
        let (some, rest) = self.candidates.split_at(random.below(n + 1));
        let (more, rest) = rest.split_at(random.below(rest.len() + 1));
        let mut count = Count::default();
        let a = gather.acceleration(&self.particle, [&[], some, &[], more, rest], &mut count);
        let place = if self.at_the_cutoff { "at the cutoff" } else { "near and far" };
        let name = format!("particle {} with {n} candidates {place}", self.particle.id);
        let question = format!(
            "{name}: acceleration of the particle, ax ay, summed in ascending order of ids"
        );
        ask.exact(&question, || vec![a.x, a.y], || self.sum());
        let question =
            format!("{name}: (1) number of candidates tested, (2) number of pairs summed");
        let found = || integers([count.tested as usize, count.seen as usize]);
        ask.exact(&question, found, || integers([n, self.in_reach()]));
    }

    fn sum(&self) -> Vec<f64> {
        let mut others: Vec<&Particle> = self.others().collect();
        others.sort_by_key(|other| other.id);
        let mut sum = Vec2::ZERO;
        for other in others {
            sum += acceleration_of_pair(other.x, other.y);
        }
        vec![sum.x, sum.y]
    }

    fn in_reach(&self) -> usize {
        let is_near = |other: &&Particle| self.particle.to(other).norm_squared() <= CUTOFF * CUTOFF;
        self.others().filter(is_near).count()
    }

    fn others(&self) -> impl Iterator<Item = &Particle> {
        self.candidates.iter().filter(|other| other.id != self.particle.id)
    }
}

/// Draws a vector whose length is the cutoff, or slightly less or more.
fn beside_the_cutoff(random: &mut Random) -> Vec2 {
    let (sin, cos) = random.between(0.0, TAU).sin_cos();
    let off = [0.0, 1e-15, random.signed(1e-16, 1e-3)][random.below(3)];
    CUTOFF * (1.0 + off) * Vec2::new(cos, sin)
}
