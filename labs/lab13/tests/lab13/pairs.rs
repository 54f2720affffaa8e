//! Questions about pairs of a rank's own particle and a ghost.

use lab13::pairs_across;
use neighbour_list::kernels::{Pair, Positions};
use oracle::{Ask, Random, beside, truth, within};

use super::ghosts::unit;

/// Particles on one side of a border.
struct Side {
    x: Vec<f64>,
    y: Vec<f64>,
}

impl Side {
    /// Draws `n` particles at integer multiples of the unit: some exactly at the reach, anywhere,
    /// or all at one position.
    fn drawn(random: &mut Random, n: usize, case: usize, unit: f64) -> Self {
        let mut axis = || (0..n).map(|_| coordinate(random, case, unit)).collect();
        Self { x: axis(), y: axis() }
    }

    fn positions(&self) -> Positions<'_> {
        Positions { x: &self.x, y: &self.y, first: 0 }
    }
}

/// Returns the side of the box in a case, in units.
fn side(case: usize) -> usize {
    [3, 12, 60][case % 3]
}

fn coordinate(random: &mut Random, case: usize, unit: f64) -> f64 {
    match case % 4 {
        0 | 1 => random.below(side(case)) as f64 * unit,
        2 => random.between(0.0, side(case) as f64) * unit,
        _ => 0.1 * unit,
    }
}

/// Asks for the pairs of few and many particles on both sides.
pub(crate) fn pairs(random: &mut Random, ask: &mut impl Ask) {
    let few = random.sizes(257).into_iter().flat_map(|n| [(n, 7), (7, n), (n, n)]);
    for (case, (own, ghosts)) in few.chain([(1, 70_000), (70_000, 1)]).enumerate() {
        // If there are very many particles, all are at one position, so that all are within reach.
        let case = if own.max(ghosts) > 1000 { 3 } else { case };
        let unit = unit(random);
        let own = Side::drawn(random, own, case, unit);
        let ghosts = Side::drawn(random, ghosts, case, unit);
        let reach = beside([1.0, 2.0, 5.0, 0.01][random.below(4)] * unit)[random.below(3)];
        let name = format!(
            "{} particles and {} ghosts in a square of side {}, reach {:?}",
            own.x.len(),
            ghosts.x.len(),
            side(case),
            reach / unit
        );
        let found = pairs_across(own.positions(), ghosts.positions(), reach);
        ask.exact(
            &format!("{name}: 1 if the pairs are in ascending order of their own particles (not ghosts), 0 if not"),
            || vec![truth(found.is_sorted_by_key(|pair| pair[0]))],
            || vec![1.0],
        );
        ask.exact(
            &format!(
                "{name}: for each pair, the index of the own particle and the index of the ghost"
            ),
            || ascending(found.clone()),
            || right_pairs(&own, &ghosts, reach),
        );
    }
}

fn ascending(mut pairs: Vec<Pair>) -> Vec<f64> {
    pairs.sort_unstable();
    pairs.as_flattened().iter().map(|index| f64::from(*index)).collect()
}

fn right_pairs(own: &Side, ghosts: &Side, reach: f64) -> Vec<f64> {
    let mut right = Vec::new();
    for i in 0..own.x.len() {
        for j in 0..ghosts.x.len() {
            let dx = ghosts.x[j] - own.x[i];
            let dy = ghosts.y[j] - own.y[i];
            if dx * dx + dy * dy <= reach * reach {
                right.extend([i as f64, j as f64]);
            }
        }
    }
    right
}

/// Asks about half a million particles. A program that tests every pair does not finish.
pub(crate) fn half_a_million(_: &mut Random, ask: &mut impl Ask) {
    ask.exact(
        "500,000 particles in a row, and a ghost at the position of each particle: (1) number of pairs, (2) number of \
         pairs whose particle and ghost are at one position",
        || within("13.3", 60, pairs_in_a_row),
        || vec![5e5; 2],
    );
}

fn pairs_in_a_row() -> Vec<f64> {
    let x: Vec<f64> = (0..500_000).map(f64::from).collect();
    let row = Side { y: vec![0.0; x.len()], x };
    let pairs = pairs_across(row.positions(), row.positions(), 0.5);
    let at_one = pairs.iter().filter(|[own, ghost]| own == ghost).count();
    vec![pairs.len() as f64, at_one as f64]
}
