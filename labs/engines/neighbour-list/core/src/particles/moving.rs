//! Particles that are moved.

use std::ops::Range;

use solution1::bounce;

use crate::kernels::Primitives;

/// Positions and velocities of consecutive particles.
pub struct Moving<'a> {
    /// Positions along x.
    pub x: &'a mut [f64],
    /// Positions along y.
    pub y: &'a mut [f64],
    /// Velocities along x.
    pub vx: &'a mut [f64],
    /// Velocities along y.
    pub vy: &'a mut [f64],
}

impl Moving<'_> {
    /// Those in `range`.
    #[inline(always)]
    pub fn part(&mut self, range: Range<usize>) -> Moving<'_> {
        Moving {
            x: &mut self.x[range.clone()],
            y: &mut self.y[range.clone()],
            vx: &mut self.vx[range.clone()],
            vy: &mut self.vy[range],
        }
    }

    /// Moves all by `dt`, under the accelerations (`ax`, `ay`), in a box of side `size`.
    #[inline(always)]
    pub fn advance<P: Primitives>(&mut self, ax: &[f64], ay: &[f64], dt: f64, size: f64) {
        advance_along::<P>(self.x, self.vx, ax, dt, size);
        advance_along::<P>(self.y, self.vy, ay, dt, size);
    }
}

/// Particles whose walls are tested together.
const CHUNK: usize = 64;

/// Moves one coordinate, and reflects what left the box.
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
