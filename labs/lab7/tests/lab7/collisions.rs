//! Questions about the effect of a collision: task 7.6.

use common::Vec2;
use common::hard::Disc;
use hard_discs::{Candidate, Hit, Square};
use lab7::{bounce, collide};
use oracle::hard::state;
use oracle::{Ask, Near, Random};

use super::words::{event, exact, short, turned, words};

/// Returns a correct state: the collision count exactly, and x, y, vx, vy up to the rounding of
/// sums of magnitude `scale`.
fn near(disc: &Disc, scale: f64) -> Vec<Near> {
    let [x, y, vx, vy, met, walls] = state(disc);
    let moving = [x, y, vx, vy].map(|right| Near { right, scale });
    moving.into_iter().chain(exact([met, walls])).collect()
}

/// Draws the time until a collision. In plain cases it is half of the step.
fn wait(random: &mut Random, is_plain: bool) -> f64 {
    if is_plain { 0.5 } else { random.between(0.0, 1.0) }
}

/// Returns the same disc with counts of earlier collisions at the ends of bit ranges.
fn with_counts(disc: Disc, random: &mut Random) -> Disc {
    let mut count = || [0, 254, 255, 65_534, 65_535, 1 << 24][random.below(6)];
    Disc { pair_collisions: count(), wall_collisions: count(), ..disc }
}

/// A disc that hits walls.
struct Bounce {
    disc: Disc,
    time: f64,
    hit: Hit,
    square: Square,
}

impl Bounce {
    /// Draws a disc whose walls are far away, or a disc that flies back straight at a second wall
    /// and would end beyond it. Because it flies straight at that wall, every way to bring it back
    /// ends at the same point.
    fn drawn(random: &mut Random, case: usize) -> Self {
        let is_plain = case < 60;
        let unit = if is_plain { 1.0 } else { random.magnitude(1e-12, 1e12) };
        let time = [wait(random, is_plain), 0.0, 1.0][random.below(3)];
        let [vx, vy] = [(); 2].map(|()| short(is_plain, random.signed(1e-6, 1e3)) * unit);
        let middle = 5e3 * unit;
        let v = vx.abs();
        let start = unit + 0.5 * (1.0 - time) * v - time * v;
        let disc = match case % 6 {
            0 => Disc::new(start, middle, v, 0.0),
            1 => Disc::new(middle, start, 0.0, v),
            _ => Disc::new(middle, middle, vx, vy),
        };
        let disc = if is_plain { disc } else { with_counts(disc, random) };
        let hit = [Hit::WallX(0), Hit::WallY(0), Hit::Corner(0)][case % 3];
        Self { disc, time, hit, square: Square { side: 1e4 * unit, radius: unit } }
    }

    fn right(&self) -> Disc {
        let Self { disc, time, hit, square } = self;
        let mut after = *disc;
        if !matches!(hit, Hit::WallY(_)) {
            after.vx = -disc.vx;
        }
        if !matches!(hit, Hit::WallX(_)) {
            after.vy = -disc.vy;
        }
        let along = |x: f64, before: f64, after: f64| {
            (x + time * before + (1.0 - time) * after).clamp(square.least(), square.most())
        };
        after.x = along(disc.x, disc.vx, after.vx);
        after.y = along(disc.y, disc.vy, after.vy);
        after.wall_collisions += 1;
        after
    }
}

/// Asks for the state at the end of the step of a disc that hits a wall or a corner.
pub(crate) fn bounces(random: &mut Random, ask: &mut impl Ask) {
    for case in 0..1200 {
        let bounced = Bounce::drawn(random, case);
        let Bounce { disc, time, hit, square } = bounced;
        let question = format!(
            "{}, of radius {:?}, at {}, after {} collisions with discs and {} with walls, in a square of side {:?}: x \
             y vx vy after the step, then its number of collisions with discs and its number of collisions with walls",
            event(&Candidate { time, hit }),
            square.radius,
            words(&disc),
            disc.pair_collisions,
            disc.wall_collisions,
            square.side
        );
        let found = || {
            let mut after = disc;
            bounce(&mut after, time, hit, square);
            state(&after).to_vec()
        };
        ask.near(&question, found, || near(&bounced.right(), square.side));
    }
}

/// Two discs that touch, overlap or have the same position, far from walls.
struct Crash {
    a: Disc,
    b: Disc,
    time: f64,
    square: Square,
}

impl Crash {
    fn drawn(random: &mut Random, case: usize) -> Self {
        let is_plain = case < 60;
        let unit = if is_plain { 1.0 } else { random.magnitude(1e-12, 1e12) };
        let time = [wait(random, is_plain), 0.0][random.below(2)];
        let mut vector =
            |size: f64| Vec2::new(random.signed(1e-3, size), random.signed(1e-3, size));
        let velocities = [(); 2].map(|()| vector(1e3));
        let [v, w] =
            velocities.map(|v| unit * Vec2::new(short(is_plain, v.x), short(is_plain, v.y)));
        let apart = vector(1.0);
        let near = [random.magnitude(1e-6, 1.0), 1.0, 0.0][random.below(3)];
        let apart = if is_plain { turned(Vec2::new(2.0, 0.0), case) } else { unit * near * apart };
        let square = Square { side: 1e6 * unit, radius: unit };
        // The discs touch in the middle and move apart from there.
        let middle = Vec2::new(0.5 * square.side, 0.5 * square.side);
        let mut discs = [(middle, v), (middle + apart, w)]
            .map(|(at, v)| Disc::new(at.x - time * v.x, at.y - time * v.y, v.x, v.y));
        if !is_plain {
            discs = discs.map(|disc| with_counts(disc, random));
        }
        let [a, b] = discs;
        Self { a, b, time, square }
    }

    /// Returns the vector from a to b at the time of contact.
    fn normal(&self) -> Vec2 {
        let at = |x: f64, v: f64| x + self.time * v;
        Vec2::new(
            at(self.b.x, self.b.vx) - at(self.a.x, self.a.vx),
            at(self.b.y, self.b.vy) - at(self.a.y, self.a.vy),
        )
    }

    /// Returns the disc at the end of the step, if the collision changes its velocity by `gain`.
    fn after(&self, disc: Disc, gain: Vec2) -> Disc {
        let (vx, vy) = (disc.vx + gain.x, disc.vy + gain.y);
        let x = disc.x + self.time * disc.vx + (1.0 - self.time) * vx;
        let y = disc.y + self.time * disc.vy + (1.0 - self.time) * vy;
        Disc { x, y, vx, vy, pair_collisions: disc.pair_collisions + 1, ..disc }
    }

    /// Returns both discs at the end of the step.
    fn right(&self) -> Vec<Near> {
        let Self { a, b, square, .. } = *self;
        let n = self.normal();
        let length = n.norm_squared();
        let along = (b.vx - a.vx) * n.x + (b.vy - a.vy) * n.y;
        let gain = if length > 0.0 { (along / length) * n } else { Vec2::ZERO };
        // A result is only as exact as the direction, because the discs may be very close.
        let exact = 1e-4 * square.side / length.sqrt().max(1e-9 * square.side);
        let speed = (a.velocity().norm_squared() + b.velocity().norm_squared()).sqrt();
        let scale = speed * exact.max(10.0);
        let all = [self.after(a, gain), self.after(b, -gain)].map(|disc| {
            let mut numbers = near(&disc, scale);
            numbers[..2].iter_mut().for_each(|near| near.scale += square.side);
            numbers
        });
        all.concat()
    }
}

/// Asks for the states at the end of the step of two discs that touch.
pub(crate) fn collisions(random: &mut Random, ask: &mut impl Ask) {
    for case in 0..1200 {
        let crash = Crash::drawn(random, case);
        let Crash { mut a, mut b, time, square } = crash;
        let question = format!(
            "case {case}, {} and {} of radius {:?} touch at λ = {time:?}, in a square of side {:?}, after {} and {} \
             collisions with discs: for each disc x y vx vy, its number of collisions with discs and its number of \
             collisions with walls",
            words(&a),
            words(&b),
            square.radius,
            square.side,
            a.pair_collisions,
            b.pair_collisions
        );
        let found = || {
            collide(&mut a, &mut b, time, square);
            [state(&a), state(&b)].concat()
        };
        ask.near(&question, found, || crash.right());
    }
}

/// Asks about a disc at rest beside the wall at 0 that another disc pushes against the wall.
pub(crate) fn pushes(random: &mut Random, ask: &mut impl Ask) {
    for _ in 0..100 {
        let unit = random.magnitude(1e-12, 1e12);
        let time = random.between(0.0, 0.99);
        let speed = unit * random.magnitude(10.0, 1e3);
        let square = Square { side: 1e4 * unit, radius: unit };
        let mut a = Disc::new(4.0 * unit + time * speed, 50.0 * unit, -speed, 0.0);
        let mut b = Disc::new(2.0 * unit, 50.0 * unit, 0.0, 0.0);
        let question = format!(
            "{} pushes {} of radius {unit:?} against the wall behind it at λ = {time:?}: x y vx vy of the second \
             disc, its number of collisions with discs and its number of collisions with walls",
            words(&a),
            words(&b)
        );
        let found = || {
            collide(&mut a, &mut b, time, square);
            state(&b).to_vec()
        };
        ask.near(&question, found, || {
            let x = (2.0 * unit - (1.0 - time) * speed).max(unit);
            let right = Disc { pair_collisions: 1, ..Disc::new(x, 50.0 * unit, -speed, 0.0) };
            near(&right, 1e3 * speed)
        });
    }
}
