//! The worked examples of pairs that are tested once.

use common::Vec2;
use common::soft::{CUTOFF, Observer, Particle};
use lab4::{pairs_across, pairs_within};
use oracle::{Ask, Random, Table};
use solution1::Tally;
use solution2::{Grid, SortedBins};

/// Returns three rows of bins that are a cutoff wide and high, with five particles. Particles 0 and
/// 1 are in row 0, 2 and 3 in row 1, 4 in row 2.
fn bins(rows: std::ops::Range<usize>) -> SortedBins {
    let places = [(1.5, 0.7), (2.1, 0.7), (0.9, 1.2), (2.5, 1.7), (2.5, 2.2)];
    let particle = |(id, (x, y)): (u32, (f64, f64))| Particle {
        x: x * CUTOFF,
        y: y * CUTOFF,
        id,
        ..Particle::default()
    };
    let grid = Grid::with_bins_along(3.0 * CUTOFF, 3);
    let mut bins = SortedBins::new(grid, rows.clone());
    let all = (0..).zip(places).map(particle);
    bins.refill(all.filter(|p| rows.contains(&grid.row(p.y))));
    bins
}

/// Formats an acceleration. Negative zero becomes zero.
fn number(a: f64) -> String {
    format!("{:.1}", a + 0.0)
}

/// Shows particles and their accelerations.
fn of_particles<'a>(
    accelerations: impl IntoIterator<Item = (&'a Particle, &'a Vec2)>,
    what: [&str; 2],
) -> Table {
    let mut table = Table::new(["particle", "x / cutoff", "y / cutoff", what[0], what[1]]);
    for (p, a) in accelerations {
        let [x, y] = [p.x, p.y].map(|along| number(along / CUTOFF));
        table.row([&p.id, &x, &y, &number(a.x), &number(a.y)]);
    }
    table
}

/// Shows the counts of an observer.
fn counts(tally: &Tally) -> Table {
    let seen = tally.statistics().expect("a tally returns statistics");
    let mut table = Table::new(["pairs within the cutoff, each twice", "pair tests"]);
    table.row([&seen.navg, &seen.pair_tests]);
    table
}

pub(crate) fn within(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let bins = bins(0..2);
        let mut accelerations = vec![Vec2::ZERO; 4];
        // Particle 3 has an acceleration already.
        accelerations[3] = Vec2::new(500.0, 0.0);
        let mut tally = Tally::default();
        pairs_within(&bins, &mut accelerations, &mut tally);
        let all = bins.particles().iter().zip(&accelerations);
        format!("{}\n{}", of_particles(all, ["ax", "ay"]), counts(&tally))
    });
}

pub(crate) fn across(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let lower = bins(0..1);
        let upper = bins(1..3);
        let mut below = [Vec2::new(500.0, 0.0), Vec2::ZERO];
        // Particles 2 and 3 are in the first row above.
        let mut above = [Vec2::ZERO; 2];
        let mut tally = Tally::default();
        pairs_across(&lower, &upper, &mut below, &mut above, &mut tally);
        let lower = of_particles(lower.particles().iter().zip(&below), ["ax", "ay"]);
        let upper = of_particles(upper.particles().iter().zip(&above), ["ax across", "ay across"]);
        format!("{lower}\n{upper}\n{}", counts(&tally))
    });
}
