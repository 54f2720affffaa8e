//! Questions about the geometry of the bins, tasks 2.1 and 2.2.

use lab2::Grid;
use oracle::{Ask, Random, beside, integers};

/// Asks for grids of few and many particles, boxes of any size, few bins and too many bins.
pub(crate) fn grids(random: &mut Random, ask: &mut impl Ask) {
    for case in 0..1200 {
        let n = match case % 3 {
            0 => random.size(70_000),
            1 => 1 << random.below(40),
            _ => 1 + random.below(1 << 40),
        };
        let least = random.magnitude(1e-9, 1e9);
        // Rounding matters if a whole number of the smallest bins fills a wall.
        let fit = match case / 3 % 3 {
            0 => random.magnitude(1e-3, 1e7),
            1 => (1 + random.below(3000)) as f64,
            _ => 1e290,
        };
        let size = fit * least;
        let question = format!(
            "{n} particles in a box of side {size:?}. A bin's side is at least {least:?} plus a margin of 1e-9 of \
             that side, and the box has at most 8 × {n} bins: number of bins along a wall"
        );
        let found = || integers([Grid::new(size, least, n).rows()]);
        ask.judge(&question, found, |found| fits(size, least, n, found));
    }
}

/// Checks that `n` bins fit along a wall.
fn fits(size: f64, least: f64, n: usize, found: &[f64]) -> Result<(), String> {
    let most = (8 * n as u128).isqrt().max(1);
    let fit = size / (least * (1.0 + 1e-9));
    one_of(found, either_side(fit).map(|fit| (fit as u128).clamp(1, most) as usize))
}

/// Asks for the columns of coordinates anywhere, on both walls, next to the far wall, and on edges.
pub(crate) fn columns(random: &mut Random, ask: &mut impl Ask) {
    for case in 0..900 {
        let most = match case % 3 {
            0 => random.size(300),
            1 => random.size(70_000),
            _ => random.below(1 << 40),
        };
        let along = 1 + most;
        let size = random.magnitude(1e-9, 1e9);
        let grid = Grid::with_bins_along(size, along);
        let edge = random.below(along) as f64 / along as f64 * size;
        let below = size.next_down();
        let anywhere = random.between(0.0, size);
        let walls = [0.0, -0.0, size, below, below.next_down(), anywhere];
        for x in walls.into_iter().chain(beside(edge)).map(|x| x.clamp(-0.0, size)) {
            let question = format!(
                "a box of side {size:?} with {along} bins along a wall, x = {x:?}: column of x"
            );
            let found = || integers([grid.column(x)]);
            ask.judge(&question, found, |found| is_column(size, along, x, found));
        }
    }
}

/// Checks that a coordinate is in a column. Rounding may put an edge on either side.
fn is_column(size: f64, along: usize, x: f64, found: &[f64]) -> Result<(), String> {
    one_of(found, either_side(x / size * along as f64).map(|bins| (bins as usize).min(along - 1)))
}

/// Returns a number rounded down and rounded up.
fn either_side(number: f64) -> [f64; 2] {
    [number * (1.0 - 1e-15), number * (1.0 + 1e-15)]
}

fn one_of(found: &[f64], right: [usize; 2]) -> Result<(), String> {
    if right.iter().any(|&right| found == [right as f64]) {
        return Ok(());
    }
    Err(format!("     found: {found:?}\n  expected: [{}]", right[0]))
}

/// Asks for the rows next to the first row, the last row and any row.
pub(crate) fn near(random: &mut Random, ask: &mut impl Ask) {
    for along in random.sizes(70_000).into_iter().chain([1 << 40]).map(|size| size + 1) {
        let grid = Grid::with_bins_along(1.0, along);
        let any = [random.size(along), random.size(along), random.below(along)];
        let all = [0, 1, along / 2, along - 1].into_iter().chain(any);
        for index in all.filter(|index| *index < along) {
            let found = || {
                let near = grid.near(index);
                integers([near.start, near.end])
            };
            let question = format!(
                "row {index} of {along}. The rows next to it, including the row itself, are a range: the first row of \
                 the range, and its last row plus 1"
            );
            ask.exact(&question, found, || {
                integers([if index == 0 { 0 } else { index - 1 }, along.min(index + 2)])
            });
        }
    }
}
