//! Primitives alone, without an engine: loops that one can time.

use std::hint::black_box;
use std::marker::PhantomData;

use common::soft::{DT, Particle, Scene, Simulation};
use common::{BuildError, Config, Parameter, Variant, bitwise};

use crate::kernels::{
    EIGHT, Kernel, Pair, Positions, Primitives, ROOM, Signs, dispatch, make_room,
};
use crate::particles::Bodies;

/// Programs for a type that has the primitives: a step of each is one pass of a loop over all particles, which stay where
/// they are.
pub trait Alone: Primitives {
    /// All of them.
    const ALONE: &'static [Variant<dyn Simulation>] = &[
        single("drift", "task 10.1 alone: particles at rest, moved", &[], |_| {
            of(|data| dispatch(Drift(data, PhantomData::<Self>)), false)
        }),
        single("plain", "the same move without walls", &[], |_| {
            of(|data| dispatch(Plain(data)), false)
        }),
        single(
            "collect",
            "task 10.2 alone: the neighbours of each particle among a few",
            &[DRAWN],
            |config| of(|data| dispatch(Collect(data, PhantomData::<Self>)), is_drawn(config)),
        ),
        single(
            "filter",
            "task 10.4 alone: which pairs are near, of one for each particle",
            &[DRAWN],
            |config| of(|data| dispatch(Filter(data, PhantomData::<Self>)), is_drawn(config)),
        ),
    ];
}

impl<P: Primitives> Alone for P {}

/// A program that is no way to simulate: the comparison of all leaves it out.
const fn single(
    name: &'static str,
    about: &'static str,
    parameters: &'static [Parameter],
    build: fn(&Config) -> Result<Box<dyn Simulation>, BuildError>,
) -> Variant<dyn Simulation> {
    bitwise(name, about, parameters, build)
}

/// Particles that are moved by one call, as in the engines.
const CHUNK: usize = 64;

/// So often pairs are at other distances. A processor knows by heart what it has seen in the pass before.
const SHIFTS: usize = 512;

/// What a loop works on: particles at rest, which no force acts on, so that every step is alike.
struct Loop {
    bodies: Bodies,
    size: f64,
    /// No acceleration.
    zeros: Vec<f64>,
    pairs: Vec<Pair>,
    /// Whether chance decides what is near, and how many particles are compared.
    drawn: bool,
    passes: usize,
    /// Pairs that were near, and chunks with a particle outside, so that nobody can leave the work out.
    found: u64,
    pass: fn(&mut Self),
}

/// [`drift`](Primitives::drift) of all particles, along x and along y.
struct Drift<'a, P>(&'a mut Loop, PhantomData<P>);

/// The same move without walls.
struct Plain<'a>(&'a mut Loop);

/// [`collect`](Primitives::collect) for nearly each particle, of the three that follow it, or if drawn of up to six.
struct Collect<'a, P>(&'a mut Loop, PhantomData<P>);

/// [`filter`](Primitives::filter) of a pair for nearly each particle: it and the one that follows it.
struct Filter<'a, P>(&'a mut Loop, PhantomData<P>);

impl Loop {
    /// Positions that are others in each pass: x of one particle, y of another.
    #[inline(always)]
    fn positions(&self) -> Positions<'_> {
        let Bodies { x, y, .. } = &self.bodies;
        let shifts = SHIFTS.min(x.len() / 2);
        let (shift, n) = (self.passes % shifts.max(1), x.len() - shifts);
        Positions { x: &x[..n], y: &y[shift..shift + n], first: 0 }
    }
}

impl<P: Primitives> Kernel for Drift<'_, P> {
    type Output = ();

    #[inline(always)]
    fn run(self, _: impl Signs) {
        let Loop { bodies: Bodies { x, y, vx, vy, .. }, zeros, size, found, .. } = self.0;
        for (x, v) in [(x, vx), (y, vy)] {
            let a = zeros.chunks(CHUNK);
            for ((x, v), a) in x.chunks_mut(CHUNK).zip(v.chunks_mut(CHUNK)).zip(a) {
                *found += u64::from(P::drift(x, v, a, DT, *size));
            }
        }
    }
}

impl Kernel for Plain<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self, _: impl Signs) {
        let Loop { bodies: Bodies { x, y, vx, vy, .. }, zeros, .. } = self.0;
        for (x, v) in [(x, vx), (y, vy)] {
            let a = zeros.chunks(CHUNK);
            for ((x, v), a) in x.chunks_mut(CHUNK).zip(v.chunks_mut(CHUNK)).zip(a) {
                for ((x, v), a) in x.iter_mut().zip(v).zip(a) {
                    *v += a * DT;
                    *x += *v * DT;
                }
            }
        }
    }
}

impl<P: Primitives> Kernel for Collect<'_, P> {
    type Output = ();

    #[inline(always)]
    fn run(self, signs: impl Signs) {
        let mut pairs = std::mem::take(&mut self.0.pairs);
        let (positions, drawn) = (self.0.positions(), self.0.drawn);
        let n = positions.x.len();
        let reach = if drawn { 0.4 * self.0.size } else { 0.0 };
        let mut len = 0;
        for i in 0..n {
            // The last digits of a position are as good as a die.
            let count = if drawn { positions.x[i].to_bits() as usize % 7 } else { 3 };
            let range = i + 1..(i + 1 + count).min(n);
            make_room(&mut pairs, len + range.len() + EIGHT);
            len = P::collect(&mut pairs, len, positions, i, range, reach, signs);
        }
        self.0.pairs = pairs;
        self.0.found += len as u64;
    }
}

impl<P: Primitives> Kernel for Filter<'_, P> {
    type Output = ();

    #[inline(always)]
    fn run(self, _: impl Signs) {
        let (mut near, mut found) = ([[0; 2]; ROOM], 0);
        let (positions, size) = (self.0.positions(), self.0.size);
        // Of two particles anywhere in the box one pair in ten is as near as that.
        let squared = if self.0.drawn { 0.036 * size * size } else { -1.0 };
        let pairs = &self.0.pairs[..positions.x.len().saturating_sub(1)];
        for some in pairs.chunks(ROOM) {
            found += P::filter(some, positions, squared, &mut near);
            black_box(&near);
        }
        self.0.found += found as u64;
    }
}

impl Simulation for Loop {
    fn load(&mut self, scene: &Scene) {
        (self.bodies, self.size) = (Bodies::of(scene), scene.size());
        (self.passes, self.found) = (0, 0);
        let n = scene.len();
        (self.bodies.vx, self.bodies.vy, self.zeros) = (vec![0.0; n], vec![0.0; n], vec![0.0; n]);
        self.pairs = (1..n as u32).map(|j| [j - 1, j]).collect();
    }

    fn step(&mut self) {
        (self.pass)(self);
        self.passes += 1;
    }

    fn read(&self, first: usize, out: &mut [Particle]) {
        self.bodies.read(first, out);
    }

    fn counters(&self) -> Vec<(&'static str, f64)> {
        vec![("found", self.found as f64)]
    }
}

const DRAWN: Parameter =
    Parameter::switch("drawn", "1: chance decides what is near; 0: nothing is", true);

fn of(pass: fn(&mut Loop), drawn: bool) -> Result<Box<dyn Simulation>, BuildError> {
    Ok(Box::new(Loop {
        bodies: Bodies::default(),
        size: 0.0,
        zeros: Vec::new(),
        pairs: Vec::new(),
        drawn,
        passes: 0,
        found: 0,
        pass,
    }))
}

fn is_drawn(config: &Config) -> bool {
    config.parameter("drawn") > 0.0
}
