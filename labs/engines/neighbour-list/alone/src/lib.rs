//! Programs that time one primitive of a neighbour-list engine without the engine.
//!
//! A step of each program is one pass of a loop over all particles. The particles do not move, so
//! these programs simulate nothing. Compare the two programs of a pair: they take the same time if
//! the primitive is as fast as possible.

use std::hint::black_box;
use std::marker::PhantomData;

use common::soft::{DT, Particle, Scene, Simulation};
use common::{BuildError, Config, Parameter};
use neighbour_list_core::kernels::{
    EIGHT, Kernel, Pair, Positions, ROOM, Signs, dispatch, make_room,
};
use neighbour_list_core::{Bodies, Primitives};

/// Whether chance decides which pairs are near. Otherwise no pair is near.
pub const DRAWN: Parameter =
    Parameter::switch("drawn", "1: chance decides what is near; 0: nothing is", true);

type Built = Result<Box<dyn Simulation>, BuildError>;

/// Builds the program that moves particles at rest with [`Primitives::drift`].
pub fn drift<P: Primitives>(_: &Config) -> Built {
    of(|data| dispatch(Drift(data, PhantomData::<P>)), false)
}

/// Builds the program that makes the same move without testing for walls.
pub fn plain(_: &Config) -> Built {
    of(|data| dispatch(Plain(data)), false)
}

/// Builds the program that lists pairs with [`Primitives::collect`].
///
/// The parameter [`DRAWN`] determines which pairs are near.
pub fn collect<P: Primitives>(config: &Config) -> Built {
    of(|data| dispatch(Collect(data, PhantomData::<P>)), is_drawn(config))
}

/// Builds the program that filters pairs with [`Primitives::filter`].
///
/// The parameter [`DRAWN`] determines which pairs are near.
pub fn filter<P: Primitives>(config: &Config) -> Built {
    of(|data| dispatch(Filter(data, PhantomData::<P>)), is_drawn(config))
}

fn of(pass: fn(&mut Loop), drawn: bool) -> Built {
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
    config.parameter(DRAWN.name) > 0.0
}

/// Number of particles that one call moves, as in the engines.
const CHUNK: usize = 64;

/// Number of passes until the distances of all pairs repeat. With fewer passes, the processor would
/// learn to predict all branches.
const SHIFTS: usize = 512;

/// The data of a loop. Particles are at rest and there are no forces, so every step does the same
/// work.
struct Loop {
    bodies: Bodies,
    size: f64,
    /// Zero accelerations.
    zeros: Vec<f64>,
    pairs: Vec<Pair>,
    /// Whether chance decides which pairs are near, and how many following particles [`Collect`]
    /// compares with each particle.
    drawn: bool,
    passes: usize,
    /// Number of near pairs and of chunks with a particle outside. The compiler cannot omit work
    /// that is counted.
    found: u64,
    pass: fn(&mut Self),
}

/// Calls [`drift`](Primitives::drift) for all particles, along x and along y.
struct Drift<'a, P>(&'a mut Loop, PhantomData<P>);

/// Moves all particles without testing for walls.
struct Plain<'a>(&'a mut Loop);

/// Calls [`collect`](Primitives::collect) for nearly all particles, each with the next three
/// particles.
///
/// If `drawn` is true, each particle is compared with a random number of following particles
/// instead, from 0 to 6.
struct Collect<'a, P>(&'a mut Loop, PhantomData<P>);

/// Calls [`filter`](Primitives::filter) with nearly every pair of consecutive particles.
struct Filter<'a, P>(&'a mut Loop, PhantomData<P>);

impl Loop {
    /// Returns positions that differ from pass to pass: the x of a particle is combined with the y
    /// of a different particle.
    #[inline(always)]
    fn positions(&self) -> Positions<'_> {
        let Bodies { x, y, .. } = &self.bodies;
        let shifts = SHIFTS.min(x.len() / 2);
        let shift = self.passes % shifts.max(1);
        let n = x.len() - shifts;
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
        let positions = self.0.positions();
        let drawn = self.0.drawn;
        let n = positions.x.len();
        let reach = if drawn { 0.4 * self.0.size } else { 0.0 };
        let mut len = 0;
        for i in 0..n {
            // The low bits of a position serve as a random number.
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
        let mut near = [[0; 2]; ROOM];
        let mut found = 0;
        let positions = self.0.positions();
        let size = self.0.size;
        // One in ten pairs of random particles in the box is at most this far apart.
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
        self.bodies = Bodies::of(scene);
        self.bodies.vx.fill(0.0);
        self.bodies.vy.fill(0.0);
        self.zeros = vec![0.0; scene.len()];
        self.size = scene.size();
        self.passes = 0;
        self.found = 0;
        self.pairs = (1..scene.len() as u32).map(|j| [j - 1, j]).collect();
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
