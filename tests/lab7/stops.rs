//! Questions about a disc that waits at a wall: task 7.5.

use common::hard::Disc;
use hard_discs::Square;
use lab7::stop_at_wall;
use oracle::hard::{state, wait_at_wall};
use oracle::{Ask, Near, Random, beside};

use super::words::{exact, unit, words};

/// A disc, perhaps beyond walls of a square.
struct Beyond {
    disc: Disc,
    square: Square,
}

impl Beyond {
    fn drawn(random: &mut Random) -> Self {
        let radius = unit(random, true);
        let square = Square { side: (3 + random.below(30)) as f64 * radius, radius };
        let [(x, vx), (y, vy)] = [(); 2].map(|()| Self::along(random, square));
        Self { disc: Disc::new(x, y, vx, vy), square }
    }

    /// Coordinate and velocity: inside, or beyond a wall by some part of a step, by two steps or a little
    /// more or less, or by rounding.
    fn along(random: &mut Random, square: Square) -> (f64, f64) {
        let Square { radius, .. } = square;
        let speed = random.signed(0.25, 1e3);
        let v = speed.abs().log2().round().exp2().copysign(speed) * radius;
        let wall = if v > 0.0 { square.most() } else { square.least() };
        let hair = [square.most().next_up(), square.least().next_down()][random.below(2)];
        match random.below(5) {
            0 => (random.between(square.least(), square.most()), v),
            1 => (wall + beside(2.0 * v)[random.below(3)], v),
            2 => (hair, [0.0, -0.0, v * 1e-30][random.below(3)]),
            3 => (wall + random.between(0.0, 4.0) * v, v),
            _ => (wall + random.between(0.0, 1.0) * v, v),
        }
    }

    /// Where it waits. What stays where it is stays there to the last digit.
    fn waiting(&self) -> Vec<Near> {
        let mut after = self.disc;
        wait_at_wall(&mut after, self.square.least(), self.square.most());
        let most = 1e3 * self.square.side;
        let along = |x: f64, right: f64| Near { right, scale: (x - right).abs().min(most) };
        let [x, y] = [along(self.disc.x, after.x), along(self.disc.y, after.y)];
        [x, y].into_iter().chain(exact([self.disc.vx, self.disc.vy])).collect()
    }
}

/// A disc beyond walls or not: where it waits.
pub(crate) fn stops(random: &mut Random, ask: &mut impl Ask) {
    for case in 0..2000 {
        let beyond = Beyond::drawn(random);
        let square = beyond.square;
        let question = format!(
            "case {case}: a disc at {}, centres from {:?} to {:?}: where it waits, x y vx vy",
            words(&beyond.disc),
            square.least(),
            square.most()
        );
        let found = || {
            let mut disc = beyond.disc;
            stop_at_wall(&mut disc, square);
            state(&disc)[..4].to_vec()
        };
        ask.near(&question, found, || beyond.waiting());
    }
}
