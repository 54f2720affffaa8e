//! Questions about the time at which two discs touch: task 7.2.

use common::Vec2;
use common::hard::Disc;
use lab7::pair_time;
use oracle::hard::first_touch;
use oracle::{Ask, Near, Random, beside};

use super::words::{turned, unit, words};

/// The second of two discs, relative to the first: its position and its velocity.
#[derive(Clone, Copy)]
struct Seen {
    d: Vec2,
    v: Vec2,
}

/// The first of two discs, and the radius of both.
struct First {
    disc: Disc,
    radius: f64,
}

impl First {
    /// Asks when the disc touches the second disc. `digits` is the allowed error relative to λ.
    fn meets(&self, ask: &mut impl Ask, what: &str, Seen { d, v }: Seen, digits: f64) {
        let Self { disc: a, radius } = *self;
        let b = Disc::new(a.x + d.x, a.y + d.y, a.vx + v.x, a.vy + v.y);
        let question = format!(
            "{what}, discs of radius {radius:?} at {} and {}: λ at which they touch, or no number if they do not \
             touch",
            words(&a),
            words(&b)
        );
        let found = || pair_time(&a, &b, radius).map(|time| time + 0.0).into_iter().collect();
        ask.near(&question, found, || {
            let (apart, closing) = (b.position() - a.position(), b.velocity() - a.velocity());
            let right = first_touch([apart.x, apart.y], [closing.x, closing.y], radius);
            right.into_iter().map(|right| Near { right, scale: right * 1e12 * digits }).collect()
        });
    }
}

/// Returns whether the outcome for two discs of this radius is independent of rounding.
fn is_decided(Seen { d, v }: Seen, radius: f64) -> bool {
    let (s, cross, apart) = (d.dot(v), d.cross(v), d.norm_squared());
    let (reach, moved) = (4.0 * radius * radius, v.norm_squared());
    let delta = reach * moved - cross * cross;
    let time = (apart - reach) / (delta.max(0.0).sqrt() - s);
    let decided = |number: f64, scale: f64| number.abs() > 1e-4 * scale;
    decided(delta, reach * moved + cross * cross)
        && decided(s, (apart * moved).sqrt())
        && decided(apart - reach, apart + reach)
        && decided(time - 1.0, 1.0)
}

/// Asks about discs anywhere that meet or miss each other, if the outcome does not depend on
/// rounding.
pub(crate) fn meetings(random: &mut Random, ask: &mut impl Ask) {
    let mut asked = 0;
    while asked < 3000 {
        let radius = random.magnitude(1e-12, 1e12);
        let speed = random.magnitude(1e-3, 1e3) * radius;
        let wide = radius * random.magnitude(1.0, 1e3);
        let mut vector =
            |size: f64| Vec2::new(random.between(-size, size), random.between(-size, size));
        let (d, v, at) = (vector(wide), vector(speed), vector(wide));
        // Half of the pairs fly towards each other.
        let v = if asked % 2 == 0 { v } else { (-1.5 * speed / wide) * d + 0.3 * v };
        if is_decided(Seen { d, v }, radius) {
            asked += 1;
            let first = First { disc: Disc::new(at.x, at.y, 0.0, 0.0), radius };
            first.meets(ask, "anywhere", Seen { d, v }, 1e-9);
        }
    }
    for times in [1e3, 1e6, 1e9, 1e12] {
        let d = Vec2::new(times, 0.0);
        let first = First { disc: Disc::default(), radius: 1.0 };
        first.meets(ask, "head on from far", Seen { d, v: -2.0 * d }, 1e-9);
    }
}

/// A triangle of integers times a power of two, (p u)² + (q u)² = (r u)², rotated by quarter turns
/// and mirrored. Two discs of radius r / 2 touch where the second is at (p, q) relative to the
/// first.
struct Triangle {
    p: f64,
    q: f64,
    r: f64,
    unit: f64,
    how: usize,
}

impl Triangle {
    fn drawn(random: &mut Random, case: usize) -> Self {
        let unit = unit(random, true);
        let [p, q, r] =
            [[3.0, 4.0, 5.0], [12.0, 5.0, 13.0], [8.0, 15.0, 17.0]][case % 3].map(|s| s * unit);
        Self { p, q, r, unit, how: random.below(8) }
    }

    fn at(&self, x: f64, y: f64) -> Vec2 {
        turned(Vec2::new(x, y), self.how)
    }

    /// Returns a disc at rest at (0, 0).
    fn resting(&self) -> First {
        First { disc: Disc::default(), radius: self.r / 2.0 }
    }

    /// Draws a moving disc.
    fn moving(&self, random: &mut Random) -> First {
        let [x, y] = [(); 2].map(|()| (1 + random.below(99)) as f64 * self.unit);
        let disc = Disc::new(x, y, 7.0 * self.unit, -3.0 * self.unit);
        First { disc, radius: self.r / 2.0 }
    }

    /// Draws the initial distance of a disc.
    fn far(&self, random: &mut Random) -> f64 {
        (1 + random.below(40)) as f64 * self.unit
    }

    /// Asks about discs that touch at (p, q) at the end of the step.
    fn at_the_end(&self, random: &mut Random, ask: &mut impl Ask) {
        let far = self.far(random);
        let (d, v) = (self.at(self.p + far, self.q), self.at(-far, 0.0));
        self.moving(random).meets(ask, "just at the end of the step", Seen { d, v }, 1e-12);
        for by in [1.0 + 1e-12, 1.0 - 1e-12] {
            self.resting().meets(ask, "at the end, nearly", Seen { d, v: by * v }, 1e-10);
        }
    }

    /// Asks about discs that graze each other, discs in contact, and discs that miss either of
    /// these narrowly.
    fn nearly(&self, random: &mut Random, ask: &mut impl Ask) {
        let far = self.far(random);
        for x in beside(self.r) {
            // The second disc passes beside the first, from the left: the discs touch only if Δ >
            // 0.
            let v = self.at(-4.0 * (self.r + far).log2().ceil().exp2(), 0.0);
            let grazing = Seen { d: self.at(far, x), v };
            self.resting().meets(ask, "grazing, or nearly", grazing, 1e-6);
            let v = self.at(random.signed(1e-9, 1e9) * self.r, 0.0);
            let touching = Seen { d: self.at(x, 0.0), v };
            self.resting().meets(ask, "in contact, or nearly", touching, 1e-12);
        }
        // The square of the distance exceeds that of two radii by its last digit, but the distance
        // itself is rounded to two radii.
        let above = (self.r * self.r).next_up() - self.r * self.r;
        let v = self.at(-self.r * random.magnitude(1e-6, 1e6), 0.0);
        let last = Seen { d: self.at(self.r, above.sqrt()), v };
        self.resting().meets(ask, "a last digit before contact", last, 1e-12);
        let gap = self.r * 0.5_f64.powi(1 + random.below(40) as i32);
        let v = self.at(-gap * random.magnitude(1.001, 1e6), 0.0);
        let near = Seen { d: self.at(self.r + gap, 0.0), v };
        self.resting().meets(ask, "nearly in contact", near, 1e-12);
    }

    /// Asks about discs that are in contact and pass each other with a perpendicular velocity.
    fn side_by_side(&self, random: &mut Random, ask: &mut impl Ask) {
        let (d, v) = (self.at(self.p, self.q), self.at(-self.q, self.p));
        self.moving(random).meets(ask, "in contact, side by side", Seen { d, v }, 1e-12);
        // The velocity is so nearly perpendicular that Δ is only rounding. The discs are in
        // contact, so the root does not matter.
        let many = (1 << (8 + random.below(20))) as f64 + 1.0;
        let v = many * v - (self.unit / self.p) * self.at(self.p, 0.0);
        self.resting().meets(ask, "in contact, nearly side by side", Seen { d, v }, 1e-12);
    }

    /// Asks about discs that overlap or have the same position.
    fn overlapping(&self, random: &mut Random, ask: &mut impl Ask) {
        let d = self.at(self.p, self.q);
        let deep = random.magnitude(1e-12, 0.999) * d;
        let first = self.resting();
        first.meets(ask, "overlapping", Seen { d: deep, v: -d }, 1e-12);
        first.meets(ask, "overlapping and leaving", Seen { d: deep, v: d }, 1e-12);
        first.meets(ask, "overlapping, at rest", Seen { d: deep, v: Vec2::ZERO }, 1e-12);
        let side = Seen { d: self.at(self.p, 0.0), v: self.at(0.0, self.q) };
        first.meets(ask, "overlapping, side by side", side, 1e-12);
        self.moving(random).meets(ask, "at one position", Seen { d: Vec2::ZERO, v: d }, 1e-12);
        let apart = Seen { d: 4.0 * d, v: Vec2::ZERO };
        self.moving(random).meets(ask, "at rest, seen from each other", apart, 1e-12);
    }
}

/// Asks about discs whose outcome depends on the last digit.
pub(crate) fn contacts(random: &mut Random, ask: &mut impl Ask) {
    for case in 0..400 {
        let triangle = Triangle::drawn(random, case);
        triangle.at_the_end(random, ask);
        triangle.nearly(random, ask);
        triangle.side_by_side(random, ask);
        triangle.overlapping(random, ask);
    }
}
