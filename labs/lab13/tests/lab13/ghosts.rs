//! Questions about partners for ghosts, and about the particles that become ghosts.

use std::ops::Range;

use lab13::{choose, partners};
use oracle::{Ask, Random, beside};
use strips::Strips;

/// Draws a power of two, small or large. Integers times a power of two have exact sums, so that a
/// position exactly at a limit can be drawn.
pub(crate) fn unit(random: &mut Random) -> f64 {
    random.magnitude(1e-9, 1e9).log2().round().exp2()
}

/// Draws high, low and empty strips between edges that are integer multiples of the unit.
fn some_strips(random: &mut Random, ranks: usize, unit: f64) -> Strips {
    let mut edges: Vec<f64> =
        (1..ranks).map(|_| (1 + random.below(2 * ranks)) as f64 * unit).collect();
    edges.sort_by(f64::total_cmp);
    // Some ranks at the ends have no rows.
    let ends = random.below(3).min(ranks - 1);
    let low = vec![f64::NEG_INFINITY; if ends == 1 { 2 } else { 1 }];
    let high = vec![f64::INFINITY; if ends == 2 { 2 } else { 1 }];
    edges.truncate(ranks + 1 - low.len() - high.len());
    Strips { edges: [low, edges, high].concat() }
}

/// Asks for the partners of ranks. The distances of edges are exactly the width, or slightly more
/// or less.
pub(crate) fn partners_of_ranks(random: &mut Random, ask: &mut impl Ask) {
    let sizes = random.sizes(257).into_iter().filter(|&ranks| ranks > 0);
    for ranks in sizes.flat_map(|ranks| [ranks; 6]) {
        let unit = unit(random);
        let strips = some_strips(random, ranks, unit);
        let width = beside(random.below(8) as f64 * unit)[random.below(3)].max(0.0);
        for _ in 0..ranks.min(12) {
            let rank = random.below(ranks);
            let edges = if ranks < 9 {
                format!(" with edges at {:?}", strips.edges)
            } else {
                String::new()
            };
            let question = format!(
                "{ranks} strips{edges}, ghosts {width:?} wide: partners of rank {rank}, in ascending order"
            );
            let found = || partners(&strips, rank, width).into_iter().map(f64::from).collect();
            ask.exact(&question, found, || right_partners(&strips, rank, width));
        }
    }
}

fn right_partners(strips: &Strips, rank: usize, width: f64) -> Vec<f64> {
    let edges = &strips.edges;
    let is_empty = |rank: usize| edges[rank] >= edges[rank + 1];
    let near = |&other: &usize| {
        let between = edges[rank.max(other)] - edges[rank.min(other) + 1];
        other != rank && !is_empty(rank) && !is_empty(other) && between <= width
    };
    (0..edges.len() - 1).filter(near).map(|other| other as f64).collect()
}

/// Particles below or above a strip.
struct Beside {
    y: Vec<f64>,
    strip: Range<f64>,
    width: f64,
    /// Whether the particles are below the strip.
    is_below: bool,
    /// The position whose distance from the strip is the width of the ghosts.
    at: f64,
}

impl Beside {
    fn drawn(random: &mut Random, n: usize) -> Self {
        let unit = unit(random);
        let width = (1 + random.below(20)) as f64 * unit;
        let is_below = random.below(2) == 0;
        let start = (101 + random.below(50)) as f64 * unit;
        let end = start + (1 + random.below(5)) as f64 * unit;
        let at = if is_below { start - width } else { end + width };
        let strip = match (is_below, random.below(3)) {
            (true, 0) => start..f64::INFINITY,
            (false, 0) => f64::NEG_INFINITY..end,
            _ => start..end,
        };
        let mut all = Self { y: Vec::new(), strip: start..end, width, is_below, at };
        all.y = (0..n).map(|_| all.particle(random, unit)).collect();
        Self { strip, ..all }
    }

    /// Draws a position within the width, exactly at the width, slightly further, or far away.
    fn particle(&self, random: &mut Random, unit: f64) -> f64 {
        let far = random.magnitude(1e-12, 50.0) * unit;
        let inwards = if self.is_below { 1.0 } else { -1.0 };
        match random.below(4) {
            0 => beside(self.at)[random.below(3)],
            1 if self.is_below => (self.strip.start - far).next_down(),
            1 => self.strip.end + far,
            2 => self.at + far.min(0.9 * self.width) * inwards,
            _ => self.at - far * inwards,
        }
    }

    fn is_near(&self, y: f64) -> bool {
        if self.is_below { y >= self.at } else { y <= self.at }
    }
}

/// Asks which of few and many particles before and after a strip are ghosts.
pub(crate) fn chosen(random: &mut Random, ask: &mut impl Ask) {
    for n in random.sizes(65_537).into_iter().flat_map(|n| [n, n]).chain([70_000]) {
        let all = Beside::drawn(random, n);
        let Beside { y, strip, width, .. } = &all;
        let shown = if n < 9 { format!(" at y = {y:?}") } else { String::new() };
        let question = format!(
            "{n} particles{shown}: indices of the particles that are at most {width:?} away from the strip {strip:?}, \
             in ascending order"
        );
        let right = || (0..n).filter(|&index| all.is_near(y[index])).map(|index| index as f64);
        ask.exact(
            &question,
            || choose(y, strip, *width).into_iter().map(f64::from).collect(),
            || right().collect(),
        );
    }
}
