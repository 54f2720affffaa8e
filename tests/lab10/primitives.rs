//! Questions about the loops over particles and pairs, tasks 10.1, 10.2 and 10.4.

use std::ops::Range;

use common::soft::{DT, Particle};
use lab10::{collect, drift, filter};
use neighbour_list_core::kernels::{Pair, ROOM};
use neighbour_list_core::{AnyProcessor, Bodies, EIGHT, Positions};
use oracle::{Ask, Random, beside, truth};

use super::scenes::{bodies, flat, particles, squared};

/// Asks about moves of any number of particles, with any step and box. Sometimes one particle or
/// all particles leave the box.
pub(crate) fn moves(random: &mut Random, ask: &mut impl Ask) {
    for n in [random.sizes(4097), random.sizes(100)].concat() {
        let before = Move::drawn(random, n);
        let mut x = before.x.clone();
        let mut v = before.v.clone();
        let outside = drift(&mut x, &mut v, &before.a, before.dt, before.size);
        let name = before.name();
        let question = format!(
            "{name}: velocities, then the three numbers after the velocities, which must not change"
        );
        ask.exact(&question, || v, || before.after().v);
        ask.exact(&format!("{name}: positions"), || x, || before.after().x);
        let question = format!("{name}: 1 if any particle is outside, 0 if not");
        ask.exact(&question, || vec![truth(outside)], || vec![truth(before.after().is_outside())]);
    }
}

/// One coordinate of some particles. The velocities and accelerations have three extra numbers at
/// the end.
#[derive(Clone)]
struct Move {
    dt: f64,
    size: f64,
    x: Vec<f64>,
    v: Vec<f64>,
    a: Vec<f64>,
}

impl Move {
    fn drawn(random: &mut Random, n: usize) -> Self {
        let dt = random.magnitude(1e-6, 1e3);
        let size = random.magnitude(1e-9, 1e9);
        let speed = [0.1, 3.0][random.below(2)] * size / dt / (n as f64 + 1.0);
        let mut draw = |low: f64, high: f64, len: usize| -> Vec<f64> {
            (0..len).map(|_| random.between(low, high)).collect()
        };
        let x = draw(0.0, size, n);
        let v = draw(-speed, speed, n + 3);
        Self { dt, size, x, v, a: draw(-speed / dt, speed / dt, n + 3) }
    }

    fn name(&self) -> String {
        let n = self.x.len();
        let numbers = match n {
            1 | 2 => format!(", x = {:?}, v = {:?}, a = {:?}", self.x, &self.v[..n], &self.a[..n]),
            _ => String::new(),
        };
        let Self { dt, size, .. } = self;
        format!("{} in a box of side {size:?}{numbers}, a step of {dt:?}", particles(n))
    }

    fn after(&self) -> Self {
        let mut after = self.clone();
        for i in 0..self.x.len() {
            after.v[i] += self.a[i] * self.dt;
            after.x[i] += after.v[i] * self.dt;
        }
        after
    }

    fn is_outside(&self) -> bool {
        self.x.iter().any(|x| *x < 0.0 || *x > self.size)
    }
}

/// Asks about a particle on a wall, or as close to it as possible, among others well inside.
pub(crate) fn walls(random: &mut Random, ask: &mut impl Ask) {
    for n in random.sizes(64).into_iter().filter(|&n| n > 0) {
        let size = random.magnitude(1e-3, 1e3);
        let i = random.below(n);
        for at in [0.0, -0.0, -f64::MIN_POSITIVE, size, size.next_up(), size.next_down()] {
            let mut x = vec![0.5 * size; n];
            x[i] = at;
            let found = || vec![truth(drift(&mut x, &mut vec![0.0; n], &vec![0.0; n], DT, size))];
            let question = format!(
                "{} in a box of side {size:?}, at rest. The particle with index {i} is at {at:?}, and the others are \
                 in the middle: 1 if any particle is outside, 0 if not. A particle on a wall is inside",
                particles(n)
            );
            ask.exact(&question, found, || vec![truth(at < 0.0 || at > size)]);
        }
    }
}

/// Asks for lists of any range of particles around one particle, at any distance.
pub(crate) fn lists(random: &mut Random, ask: &mut impl Ask) {
    for n in random.sizes(1025) {
        let unit = random.magnitude(1e-6, 1e6);
        let bodies = bodies(random, n + 1, unit);
        let reach = unit * random.between(0.2, 1.5);
        for _ in 0..8 {
            let ends = [random.below(n + 1), random.below(n + 1)];
            let range = ends[0].min(ends[1])..ends[0].max(ends[1]);
            let outside: Vec<usize> = (0..=n).filter(|i| !range.contains(i)).collect();
            let i = outside[random.below(outside.len())];
            let question = format!(
                "{}: the pairs of particle {i} with particles of {range:?} within {reach:.4e}. The pairs must be \
                 written from place 1 of the list on, which contained 77 everywhere",
                particles(n + 1)
            );
            let found = || {
                let mut list = vec![[77; 2]; 1 + range.len() + EIGHT];
                let positions = bodies.positions();
                let len = collect(&mut list, 1, positions, i, range.clone(), reach, AnyProcessor);
                flat(list.get(1..len).unwrap_or(&list))
            };
            ask.exact(&question, found, || pairs_within(&bodies, i, range.clone(), reach));
        }
    }
}

/// Asks about particles exactly at the reach, and as close to it as possible.
pub(crate) fn reaches(random: &mut Random, ask: &mut impl Ask) {
    for unit in [1.0, random.magnitude(1e-9, 1e9)] {
        let reach = unit * 5.0;
        let mut bodies = Bodies::default();
        for (x, y) in [(0.0, 0.0), (3.0, 4.0), (-4.0, 3.0), (5.0, 0.0), (0.0, -5.0)] {
            for share in [1.0, 1.0 + 1e-15, 1.0 - 1e-15, 1.0 + 1e-9, 1.0 - 1e-9] {
                let scale = unit * share;
                bodies.push(Particle { x: x * scale, y: y * scale, ..Particle::default() });
            }
        }
        let n = bodies.len();
        let question = format!(
            "particle 0 is at (0, 0). The other particles are at the distance {reach:e}, or a rounding error nearer \
             or farther: pairs of particle 0 within {reach:e}. A particle at exactly this distance is within it"
        );
        let found = || {
            let mut list = vec![[77; 2]; n + EIGHT];
            let len = collect(&mut list, 0, bodies.positions(), 0, 1..n, reach, AnyProcessor);
            flat(list.get(..len).unwrap_or(&list))
        };
        ask.exact(&question, found, || pairs_within(&bodies, 0, 1..n, reach));
    }
}

fn pairs_within(bodies: &Bodies, i: usize, range: Range<usize>, reach: f64) -> Vec<f64> {
    let near = range.filter(|&j| squared(bodies, i, j) <= reach * reach);
    near.flat_map(|j| [i as f64, j as f64]).collect()
}

/// Asks about arbitrary pairs, near or not, of particles that follow a first particle. Sometimes
/// the reach equals the distance of a pair.
pub(crate) fn near(random: &mut Random, ask: &mut impl Ask) {
    for len in random.sizes(ROOM) {
        let unit = random.magnitude(1e-6, 1e6);
        let first = random.below(70_000);
        let count = 2 + random.below(300);
        let bodies = bodies(random, count, unit);
        let pairs: Vec<Pair> =
            (0..len).map(|_| [0, 1].map(|_| (first + random.below(count)) as u32)).collect();
        let of_pair = |pair: &Pair| {
            let [i, j] = pair.map(|i| i as usize - first);
            squared(&bodies, i, j)
        };
        let within = match pairs.first() {
            Some(pair) if random.below(2) == 0 => beside(of_pair(pair))[random.below(2)],
            _ => (unit * random.between(0.1, 1.5)).powi(2),
        };
        let question = format!(
            "{len} pairs of {count} particles from index {first} on: both particles of each pair whose squared \
             distance is at most {within:?}"
        );
        ask.exact(
            &question,
            || {
                let mut near = [[77; 2]; ROOM];
                let positions = Positions { first, ..bodies.positions() };
                let len = filter(&pairs, positions, within, &mut near);
                flat(near.get(..len).unwrap_or(&near))
            },
            || {
                flat(
                    &pairs
                        .iter()
                        .copied()
                        .filter(|pair| of_pair(pair) <= within)
                        .collect::<Vec<_>>(),
                )
            },
        );
    }
}
