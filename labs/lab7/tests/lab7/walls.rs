//! Questions about the time at which a disc hits a wall, and about its position after a collision:
//! tasks 7.1 and 7.5.

use common::hard::Disc;
use hard_discs::{Candidate, Hit, Square};
use lab7::{stop_at_wall, wall_hit};
use oracle::hard::{What, possible, state, wait_at_wall};
use oracle::{Ask, Near, Random, beside};

use super::words::{EACH, exact, number, unit, values, words};

/// The position and velocity of a disc along one axis.
struct Along {
    x: f64,
    v: f64,
}

/// A square whose side is `room` plus two radii, so that centres can move over the length `room`.
struct Room {
    room: usize,
    square: Square,
    is_plain: bool,
}

impl Room {
    fn drawn(random: &mut Random, case: usize) -> Self {
        let is_plain = case < 100;
        let unit = if is_plain { 1.0 } else { unit(random, case.is_multiple_of(2)) };
        let room = 2 + random.below(21);
        Self { room, square: Square { side: (room + 2) as f64 * unit, radius: unit }, is_plain }
    }

    /// Draws a position near a wall or far from it. The disc is at rest, just reaches the wall,
    /// just misses it, or is slightly outside, also at rest.
    fn along(&self, random: &mut Random) -> Along {
        let Self { room, square, is_plain } = *self;
        let unit = square.radius;
        let x = (1 + random.below(room + 1)) as f64 * unit;
        let speed = [-8.0, -4.0, 0.0, 4.0, 8.0, 16.0][random.below(6)] * unit;
        let fast = random.signed(1e-9, 1e6) * unit;
        let slow = random.signed(1e-3, 1e3) * f64::EPSILON * unit;
        let way = [0.0, 1.0, room as f64 + 1.0, room as f64 + 2.0][random.below(4)] * unit - x;
        let outside = [square.least().next_down(), square.most().next_up()][random.below(2)];
        match random.below(6) {
            _ if is_plain => Along { x, v: speed },
            0 => Along { x, v: fast },
            1 => Along { x, v: beside(way)[random.below(3)] },
            2 => Along { x, v: random.between(-1.5, 1.5) * room as f64 * unit },
            3 => Along { x: outside, v: [slow, fast, 0.0, -0.0][random.below(4)] },
            _ => Along { x, v: speed },
        }
    }
}

/// Asks about far and near walls, and about corners.
pub(crate) fn walls(random: &mut Random, ask: &mut impl Ask) {
    for case in 0..2400 {
        let room = Room::drawn(random, case);
        let square = room.square;
        let [x, y] = [room.along(random), room.along(random)];
        let disc = Disc::new(x.x, y.x, x.v, y.v);
        let a = if room.is_plain { case as u32 } else { number(random) };
        let question = format!(
            "disc {a} of radius {:?} at {}, in a square of side {:?}: {EACH}, or no numbers if it hits no wall",
            square.radius,
            words(&disc),
            square.side
        );
        ask.near(
            &question,
            || values(wall_hit(a, &disc, square).as_slice()),
            || first_wall(a, &disc, square),
        );
    }
}

/// Returns the wall that a disc hits, with λ up to rounding.
fn first_wall(a: u32, disc: &Disc, square: Square) -> Vec<Near> {
    let events = possible(&[*disc], square.side, square.radius);
    let candidate = events.first().map(|event| {
        let hit = match event.what {
            What::Corner => Hit::Corner(a),
            What::WallX => Hit::WallX(a),
            _ => Hit::WallY(a),
        };
        Candidate { time: event.time, hit }
    });
    let numbers = values(candidate.as_slice()).into_iter().enumerate();
    numbers
        .map(|(place, right)| Near { right, scale: if place == 0 { right } else { 0.0 } })
        .collect()
}

/// A disc that may be beyond the walls of a square.
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

    /// Draws coordinate and velocity. The disc is inside, or beyond a wall by part of a step, by
    /// about two steps, or by rounding.
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

    /// Returns the position at which the disc waits. A coordinate that does not change stays exact
    /// to the last digit.
    fn waiting(&self) -> Vec<Near> {
        let mut after = self.disc;
        wait_at_wall(&mut after, self.square.least(), self.square.most());
        let most = 1e3 * self.square.side;
        let along = |x: f64, right: f64| Near { right, scale: (x - right).abs().min(most) };
        let [x, y] = [along(self.disc.x, after.x), along(self.disc.y, after.y)];
        [x, y].into_iter().chain(exact([self.disc.vx, self.disc.vy])).collect()
    }
}

/// Asks for the waiting position of a disc, which may be beyond walls.
pub(crate) fn stops(random: &mut Random, ask: &mut impl Ask) {
    for case in 0..2000 {
        let beyond = Beyond::drawn(random);
        let square = beyond.square;
        let question = format!(
            "case {case}: a disc at {}, whose centre can be from {:?} to {:?}: x y vx vy of the disc at the position \
             at which it waits",
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
