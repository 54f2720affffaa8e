//! Questions about single free flights with random inputs. They concern the ends of flights, the
//! least distance of two particles, and the effect of a deviation or a wall.

use common::soft::DT;
use lab11::{closest_squared, fly, meets_wall, too_far_off};
use oracle::{Ask, Near, Random, beside, flags};
use windows::Span;

/// Asks for the flights of few and many particles, slow and fast, for no step and for many. Numbers
/// of particles and of steps exceed 16 bits.
pub(crate) fn flights(random: &mut Random, ask: &mut impl Ask) {
    for n in random.sizes(4097) {
        for steps in [0, 1, 2, 7, 48, 65, 257, random.below(300) as u32] {
            flight(random, ask, n, steps);
        }
    }
    flight(random, ask, 70_000, 3);
    flight(random, ask, 3, 70_000);
}

fn flight(random: &mut Random, ask: &mut impl Ask, n: usize, steps: u32) {
    let dt = random.magnitude(1e-9, 1e3);
    let [x, v] = [0; 2].map(|_| (0..n).map(|_| random.signed(1e-12, 1e12)).collect::<Vec<f64>>());
    let question =
        format!("{n} particles after {steps} steps of {dt:?}: x of each particle, bit for bit");
    let found = || {
        let mut found = x.clone();
        fly(&mut found, &v, steps, dt);
        found
    };
    ask.exact(&question, found, || {
        x.iter().zip(&v).map(|(x, v)| (0..steps).fold(*x, |x, _| x + v * dt)).collect()
    });
}

/// Two free flights.
struct Approach {
    /// Initial vector (dx, dy) from the first particle to the second.
    dx: f64,
    dy: f64,
    /// Velocity (wx, wy) of the second particle relative to the first.
    wx: f64,
    wy: f64,
    span: f64,
}

impl Approach {
    /// Draws a relative velocity: zero, perpendicular, head-on or random. The closest approach
    /// falls within the span or after it.
    fn drawn(random: &mut Random, case: usize) -> Self {
        let unit = random.magnitude(1e-12, 1e12);
        let span = random.magnitude(1e-9, 1e9);
        let [dx, dy] = vector(random, unit);
        let [wx, wy] = vector(random, unit / span);
        let fast = random.magnitude(1e-3, 1e6);
        let [wx, wy] = match case % 5 {
            0 => [0.0, -0.0],
            1 => [-dy / span * fast, dx / span * fast],
            2 => [-dx / span * fast, -dy / span * fast],
            _ => [wx * fast, wy * fast],
        };
        Self { dx, dy, wx, wy, span: if case.is_multiple_of(11) { 0.0 } else { span } }
    }

    fn right(&self) -> Near {
        let Self { dx, dy, wx, wy, span } = *self;
        let moved = wx * wx + wy * wy;
        let along = if moved > 0.0 { -(dx * wx + dy * wy) / moved } else { 0.0 };
        let t = along.clamp(0.0, span);
        let [x, y] = [dx + t * wx, dy + t * wy];
        let right = x * x + y * y;
        // Rounding moves each point a little. Rounding the time of closest approach has no
        // first-order effect on the distance.
        let gone = (dx * dx + dy * dy + t * t * moved).sqrt();
        Near { right, scale: 1e-2 * gone * right.sqrt() + 1e-17 * gone * gone }
    }
}

/// Draws a vector of about this size, sometimes along an axis.
fn vector(random: &mut Random, size: f64) -> [f64; 2] {
    [0; 2].map(|_| if random.below(6) == 0 { 0.0 } else { size * random.signed(1e-2, 1.0) })
}

/// Asks about pairs of particles that are near or far, and slow or fast relative to the time span.
pub(crate) fn approaches(random: &mut Random, ask: &mut impl Ask) {
    for case in 0..4000 {
        let approach = Approach::drawn(random, case);
        let Approach { dx, dy, wx, wy, span } = approach;
        let question = format!(
            "two particles. As seen from the first, the second is at ({dx:?}, {dy:?}) and has the velocity ({wx:?}, \
             {wy:?}), for a time of {span:?}: square of the least distance"
        );
        let found = || vec![closest_squared(dx, dy, wx, wy, span)];
        ask.near(&question, found, || vec![approach.right()]);
    }
}

/// Asks about deviations of exactly half the margin, slightly more, slightly less, and arbitrary
/// ones.
pub(crate) fn margins(random: &mut Random, ask: &mut impl Ask) {
    for _ in 0..1000 {
        let margin = random.magnitude(1e-15, 1e12);
        let some = margin * random.magnitude(1e-6, 1e6);
        for off in beside(margin / 2.0).into_iter().chain([0.0, some]) {
            let question = format!(
                "a particle that is {off:?} away from its free flight, and a margin of {margin:?}: 1 if it may have \
                 met a particle that is not on its list, 0 if not"
            );
            let found = || flags(&[too_far_off(off, margin)]);
            ask.exact(&question, found, || flags(&[off > margin / 2.0]));
        }
    }
}

/// A free flight in a box.
struct Flight {
    span: Span,
    x: f64,
    y: f64,
    vx: f64,
    vy: f64,
}

/// Whether a flight stays away from walls.
#[derive(PartialEq)]
enum Stays {
    Yes,
    No,
    /// The answer depends on rounding.
    Open,
}

impl Flight {
    fn drawn(random: &mut Random, case: usize) -> Self {
        let steps = 1 + random.below(64) as u32;
        let dt = [DT, random.magnitude(1e-9, 1.0)][case % 2];
        let span = Span { steps, dt, size: random.magnitude(1e-2, 1e6) };
        let [x, vx] = along(random, &span);
        let [y, vy] = along(random, &span);
        Self { span, x, y, vx, vy }
    }

    /// Returns whether a coordinate stays away from both walls.
    fn stays(&self, x: f64, v: f64) -> Stays {
        let size = self.span.size;
        let end = x + v * f64::from(self.span.steps) * self.span.dt;
        let limits = [self.span.rounding(), size - self.span.rounding()];
        if v != 0.0 && limits.iter().any(|limit| (end - limit).abs() < 1e-13 * size) {
            return Stays::Open;
        }
        if end >= limits[0] && end <= limits[1] { Stays::Yes } else { Stays::No }
    }

    fn verdict(&self, found: &[f64]) -> Result<(), String> {
        let both = [self.stays(self.x, self.vx), self.stays(self.y, self.vy)];
        let right = if both == [Stays::Yes, Stays::Yes] { 0.0 } else { 1.0 };
        if found == [right] || both.contains(&Stays::Open) {
            return Ok(());
        }
        Err(format!("     found: {found:?}\n  expected: {right}"))
    }
}

/// Draws a coordinate and a velocity along it. The particle is exactly at rest, flies towards a
/// position near a wall, from near or far, or flies away from a wall. Either number may be NaN.
fn along(random: &mut Random, span: &Span) -> [f64; 2] {
    let size = span.size;
    let near = span.rounding();
    let flown = f64::from(span.steps) * span.dt;
    let to = random.below(2) as f64 * size + near * random.signed(0.01, 100.0);
    let towards = (to - 0.5 * size).signum();
    let x = random.between(0.0, size);
    let edges = [beside(near), beside(size - near)].concat();
    let v = random.signed(1e-9, 10.0) * size / flown;
    match random.below(7) {
        0 => [edges[random.below(6)], 0.0],
        1 => [x, (to - x) / flown],
        2 => [to - 1e-3 * size * towards, towards * 1e-3 * size / flown],
        3 => [[f64::NAN, 0.0], [x, f64::NAN]][random.below(2)],
        4 => [x, v],
        5 => [[0.0, size, near, size - near][random.below(4)], v],
        _ => [x, 0.0],
    }
}

/// Asks about windows of any length that end far from walls, beside them, or at a limit that
/// rounding decides.
pub(crate) fn walls(random: &mut Random, ask: &mut impl Ask) {
    for case in 0..6000 {
        let flight = Flight::drawn(random, case);
        let Flight { span, x, y, vx, vy } = flight;
        let question = format!(
            "a particle at ({x:?}, {y:?}) with velocity ({vx:?}, {vy:?}), in a box of side {:?} and a window of {} \
             steps of {:?}: 1 if it may end beyond a wall or within {:?} of a wall, 0 if not",
            span.size,
            span.steps,
            span.dt,
            span.rounding()
        );
        let found = || flags(&[meets_wall(&span, x, y, vx, vy)]);
        ask.judge(&question, found, |found| flight.verdict(found));
    }
}
