//! Questions about pairs that are tested once, by the owner of some rows and across a cut.

use std::ops::Range;

use common::Vec2;
use common::soft::{CUTOFF, Observer, Particle};
use lab4::{pairs_across, pairs_within};
use oracle::{Ask, Near, Random, acceleration_of_pair, integers};
use solution1::Tally;
use solution2::{Grid, SortedBins};

/// Sums over all pairs.
pub(crate) struct Sums {
    right: Vec<Vec2>,
    /// Sums of the magnitudes of all terms, for each sum.
    scale: Vec<f64>,
    /// Number of times that a pair was seen, and number of pair tests.
    counts: [usize; 2],
}

impl Sums {
    /// Returns sums that begin with these accelerations.
    fn new(first: &[Vec2]) -> Self {
        let scale = first.iter().map(|a| a.norm_squared().sqrt()).collect();
        Self { right: first.to_vec(), scale, counts: [0; 2] }
    }

    /// Adds the acceleration of particle `i` by a neighbour at `d`.
    fn add(&mut self, i: usize, d: Vec2) {
        let a = acceleration_of_pair(d.x, d.y);
        self.right[i] += a;
        self.scale[i] += a.norm_squared().sqrt();
    }

    /// Counts a pair test.
    fn count(&mut self, d: Vec2) {
        self.counts[0] += 2 * usize::from(d.norm_squared() <= CUTOFF * CUTOFF);
        self.counts[1] += 1;
    }

    fn near(&self) -> Vec<Near> {
        let numbers = |(a, scale): (&Vec2, &f64)| [(a.x, *scale), (a.y, *scale)];
        let all = self.right.iter().zip(&self.scale).flat_map(numbers);
        all.map(|(right, scale)| Near { right, scale }).collect()
    }
}

/// Draws accelerations from earlier sums.
fn from_before(random: &mut Random, n: usize) -> Vec<Vec2> {
    (0..n).map(|_| Vec2::new(random.signed(1e-3, 1e3), random.signed(1e-3, 1e3))).collect()
}

/// Returns ax and ay of each acceleration.
fn numbers(accelerations: &[Vec2]) -> Vec<f64> {
    accelerations.iter().flat_map(|a| [a.x, a.y]).collect()
}

/// Draws particles in some rows of bins a little wider than a cutoff. Each particle has few or many
/// neighbours.
fn strip(random: &mut Random, grid: Grid, rows: Range<usize>, n: usize) -> SortedBins {
    let side = grid.bin_side();
    let extent = (n as f64 / random.magnitude(0.3, 10.0)).sqrt().max(1.0) * CUTOFF;
    let particle = |id| {
        let y = random.between(rows.start as f64 + 0.01, rows.end as f64 - 0.01) * side;
        let x = random.between(0.0, extent.min(grid.size()));
        Particle { x, y, id, ..Particle::default() }
    };
    let particles: Vec<Particle> = (0..n as u32).map(particle).collect();
    let mut bins = SortedBins::new(grid, rows);
    bins.refill(particles);
    bins
}

/// Asks how often pairs within the cutoff were seen, and how many pairs were tested.
fn ask_counts(ask: &mut impl Ask, name: &str, tally: &Tally, right: impl FnOnce() -> [usize; 2]) {
    let seen = tally.statistics().expect("a tally returns statistics");
    let question =
        format!("{name}: (1) number of pairs reported, each pair twice, (2) number of pair tests");
    ask.exact(
        &question,
        || integers([seen.navg as usize, seen.pair_tests as usize]),
        || integers(right()),
    );
}

/// Returns the sums over the pairs of some rows, each pair once, added to `first`.
fn pairs_of(bins: &SortedBins, first: &[Vec2]) -> Sums {
    let grid = bins.grid();
    let all = bins.particles();
    let mut sums = Sums::new(first);
    for (i, j) in (0..all.len()).flat_map(|i| (0..i).map(move |j| (i, j))) {
        let p = &all[i];
        let q = &all[j];
        let far = grid.row(p.y).abs_diff(grid.row(q.y));
        if far.max(grid.column(p.x).abs_diff(grid.column(q.x))) <= 1 {
            sums.add(i, p.to(q));
            sums.add(j, q.to(p));
            sums.count(p.to(q));
        }
    }
    sums
}

/// Asks for the pairs of some rows, added to earlier accelerations.
pub(crate) fn within(random: &mut Random, ask: &mut impl Ask) {
    for n in [random.sizes(1025), random.sizes(257)].concat() {
        let along = [1, 2, 5, 300][random.below(4)];
        let grid = Grid::with_bins_along(1.02 * along as f64 * CUTOFF, along);
        let start = random.below(along);
        let rows = start..start + 1 + random.below((along - start).min(4));
        let bins = strip(random, grid, rows.clone(), n);
        let first = from_before(random, n);
        let mut found = first.clone();
        let mut tally = Tally::default();
        pairs_within(&bins, &mut found, &mut tally);
        let name = format!("{n} particles in rows {rows:?} of {along}");
        let question = format!(
            "{name}: ax, ay of each particle. The pairs must be added to the acceleration that the particle had before"
        );
        ask.near(&question, || numbers(&found), || pairs_of(&bins, &first).near());
        ask_counts(ask, &name, &tally, || pairs_of(&bins, &first).counts);
    }
}

/// Two strips on both sides of a cut.
struct Cut {
    lower: SortedBins,
    upper: SortedBins,
    /// Earlier accelerations of the lower particles.
    first: Vec<Vec2>,
}

impl Cut {
    /// Returns the particles in the first row above the cut.
    fn first_row(&self) -> &[Particle] {
        let row = self.upper.rows().start;
        self.upper.bins(row, 0..self.upper.grid().columns())
    }

    /// Returns the sums of the pairs across the cut: for the lower particles, and for the first row
    /// above.
    fn pairs(&self) -> [Sums; 2] {
        let grid = self.lower.grid();
        let above = self.first_row();
        let mut sums = [Sums::new(&self.first), Sums::new(&vec![Vec2::ZERO; above.len()])];
        for (i, p) in self.lower.particles().iter().enumerate() {
            let is_last = grid.row(p.y) + 1 == self.lower.rows().end;
            for (k, q) in above.iter().enumerate().filter(|_| is_last) {
                if grid.column(p.x).abs_diff(grid.column(q.x)) <= 1 {
                    sums[0].add(i, p.to(q));
                    sums[1].add(k, q.to(p));
                    sums[0].count(p.to(q));
                }
            }
        }
        sums
    }
}

/// Asks for the pairs across a cut.
pub(crate) fn across(random: &mut Random, ask: &mut impl Ask) {
    for n in [random.sizes(1025), random.sizes(257)].concat() {
        let along = [2, 5, 300][random.below(3)];
        let grid = Grid::with_bins_along(1.02 * along as f64 * CUTOFF, along);
        let row = 1 + random.below(along - 1);
        let cut = Cut {
            lower: strip(random, grid, row.saturating_sub(2)..row, n),
            upper: strip(random, grid, row..along.min(row + 2), n),
            first: from_before(random, n),
        };
        let mut below = cut.first.clone();
        let mut tally = Tally::default();
        let mut above = vec![Vec2::ZERO; cut.first_row().len()];
        pairs_across(&cut.lower, &cut.upper, &mut below, &mut above, &mut tally);
        let name = format!("{n} particles on each side of row {row} of {along}");
        let question = format!(
            "{name}: ax, ay of each particle below the cut. The pairs must be added to the acceleration that the \
             particle had before"
        );
        ask.near(&question, || numbers(&below), || cut.pairs()[0].near());
        let question = format!(
            "{name}: for each particle in the first row above the cut, ax, ay of its separately stored acceleration"
        );
        ask.near(&question, || numbers(&above), || cut.pairs()[1].near());
        ask_counts(ask, &name, &tally, || cut.pairs()[0].counts);
    }
}
