//! The worked example of ghosts and pairs: the dozen particles of chapters 5 and 6.

use common::soft::Particle;
use lab13::{choose, pairs_across};
use neighbour_list::kernels::Positions;
use oracle::{Ask, Columns, Random, scenes, spaced};
use strips::Strips;

/// The dozen particles on three ranks. Each rank has two rows of bins.
struct Dozen {
    particles: Vec<Particle>,
    strips: Strips,
}

/// Width of the ghost layers.
const WIDTH: f64 = 1.2;

impl Dozen {
    fn own(&self, rank: usize) -> Vec<Particle> {
        self.particles.iter().filter(|p| self.strips.owner(p.y) == rank).copied().collect()
    }

    /// Returns the particles that a rank sends to another rank.
    fn sent(&self, from: usize, to: usize) -> Vec<Particle> {
        let own = self.own(from);
        let y: Vec<f64> = own.iter().map(|p| p.y).collect();
        choose(&y, &self.strips.strip(to), WIDTH).iter().map(|index| own[*index as usize]).collect()
    }

    /// Lists the pairs of a rank's particles and its ghosts from another rank.
    fn pairs(&self, rank: usize, other: usize) -> String {
        let own = self.sent(rank, other);
        let ghosts = self.sent(other, rank);
        let [x, ghost_x] = [&own, &ghosts].map(|side| side.iter().map(|p| p.x).collect::<Vec<_>>());
        let [y, ghost_y] = [&own, &ghosts].map(|side| side.iter().map(|p| p.y).collect::<Vec<_>>());
        let mut pairs = pairs_across(
            Positions { x: &x, y: &y, first: 0 },
            Positions { x: &ghost_x, y: &ghost_y, first: 0 },
            WIDTH,
        );
        pairs.sort_unstable();
        let ids = pairs
            .iter()
            .map(|[i, j]| format!("{}-{}", own[*i as usize].id, ghosts[*j as usize].id));
        spaced(ids)
    }

    /// Lists a rank's own particles, followed by its ghosts in parentheses.
    fn with_ghosts(&self, rank: usize) -> String {
        let from = beside(rank).into_iter().flatten();
        let ghosts: Vec<Particle> = from.flat_map(|other| self.sent(other, rank)).collect();
        format!("{} ({})", ids(&self.own(rank)), ids(&ghosts))
    }
}

/// Returns the ranks before and after one of three ranks.
fn beside(rank: usize) -> [Option<usize>; 2] {
    [rank.checked_sub(1), Some(rank + 1).filter(|rank| *rank < 3)]
}

fn ids(particles: &[Particle]) -> String {
    spaced(particles.iter().map(|p| p.id))
}

pub(crate) fn ghosts_and_pairs(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let [particles, _] = scenes::dozen();
        let dozen = Dozen {
            particles,
            strips: Strips { edges: vec![f64::NEG_INFINITY, 2.0, 4.0, f64::INFINITY] },
        };
        let mut table = Columns::new((0..3).map(|rank| format!("rank {rank}")));
        table.row("own particles", (0..3).map(|rank| ids(&dozen.own(rank))));
        for (side, way) in ["before", "after"].into_iter().enumerate() {
            let sent = |rank: usize| beside(rank)[side].map(|to| ids(&dozen.sent(rank, to)));
            table.row(
                format!("to the rank {way}"),
                (0..3).map(|rank| sent(rank).unwrap_or_default()),
            );
        }
        table.row("with ghosts, in ()", (0..3).map(|rank| dozen.with_ghosts(rank)));
        for (side, way) in ["before", "after"].into_iter().enumerate() {
            let pairs = (0..3).map(|rank| beside(rank)[side].map(|other| dozen.pairs(rank, other)));
            table.row(
                format!("pairs across, to the rank {way}"),
                pairs.map(Option::unwrap_or_default),
            );
        }
        table.to_string()
    });
}
