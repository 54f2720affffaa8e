//! Particles that a thread may move.

use std::ops::Range;

use solution1::bounce;

use crate::kernels::Primitives;

/// Consecutive particles that can be moved: a slice of each array of [`Bodies`](super::Bodies).
#[derive(Default)]
pub struct Moving<'a> {
    /// Positions along x.
    pub x: &'a mut [f64],
    /// Positions along y.
    pub y: &'a mut [f64],
    /// Velocities along x.
    pub vx: &'a mut [f64],
    /// Velocities along y.
    pub vy: &'a mut [f64],
    /// The particles' numbers in the scene.
    pub id: &'a mut [u32],
}

impl<'a> Moving<'a> {
    /// Returns the particles in `range`.
    #[inline(always)]
    pub fn part(&mut self, range: Range<usize>) -> Moving<'_> {
        Moving {
            x: &mut self.x[range.clone()],
            y: &mut self.y[range.clone()],
            vx: &mut self.vx[range.clone()],
            vy: &mut self.vy[range.clone()],
            id: &mut self.id[range],
        }
    }

    /// Removes the first `len` particles and returns them.
    pub fn split_off(&mut self, len: usize) -> Moving<'a> {
        Moving {
            x: split_off(&mut self.x, len),
            y: split_off(&mut self.y, len),
            vx: split_off(&mut self.vx, len),
            vy: split_off(&mut self.vy, len),
            id: split_off(&mut self.id, len),
        }
    }

    /// Moves the particles for a time `dt` under the accelerations (`ax`, `ay`), in a box of side
    /// `size`.
    #[inline(always)]
    pub fn advance<P: Primitives>(&mut self, ax: &[f64], ay: &[f64], dt: f64, size: f64) {
        advance_along::<P>(self.x, self.vx, ax, dt, size);
        advance_along::<P>(self.y, self.vy, ay, dt, size);
    }
}

fn split_off<'a, T>(slice: &mut &'a mut [T], len: usize) -> &'a mut [T] {
    slice.split_off_mut(..len).expect("there are as many")
}

/// Number of particles for which one test shows whether any has left the box.
const CHUNK: usize = 64;

/// Moves one coordinate, and reflects the particles that have left the box.
#[inline(always)]
fn advance_along<P: Primitives>(x: &mut [f64], v: &mut [f64], a: &[f64], dt: f64, size: f64) {
    for ((x, v), a) in x.chunks_mut(CHUNK).zip(v.chunks_mut(CHUNK)).zip(a.chunks(CHUNK)) {
        if P::drift(x, v, a, dt, size) {
            for (x, v) in x.iter_mut().zip(v) {
                (*x, *v) = bounce(*x, *v, size);
            }
        }
    }
}
