//! The tasks, in the form that the engine calls.

use windows::{Rules, Span};

use crate::{flight, union_find};

/// Your functions, as the rules by which this lab's programs skip work.
pub struct Tasks;

impl Rules for Tasks {
    #[inline(always)]
    fn fly(x: &mut [f64], v: &[f64], steps: u32, dt: f64) {
        flight::fly(x, v, steps, dt);
    }

    #[inline(always)]
    fn closest_squared(dx: f64, dy: f64, wx: f64, wy: f64, span: f64) -> f64 {
        flight::closest_squared(dx, dy, wx, wy, span)
    }

    #[inline]
    fn root(parent: &mut [u32], k: u32) -> u32 {
        union_find::root(parent, k)
    }

    #[inline]
    fn join(parent: &mut [u32], a: u32, b: u32) {
        union_find::join(parent, a, b);
    }

    #[inline(always)]
    fn too_far_off(deviation: f64, margin: f64) -> bool {
        flight::too_far_off(deviation, margin)
    }

    #[inline(always)]
    fn meets_wall(span: &Span, x: f64, y: f64, vx: f64, vy: f64) -> bool {
        flight::meets_wall(span, x, y, vx, vy)
    }

    fn window_length(density: f64, speed: f64) -> u32 {
        crate::window_length(density, speed)
    }
}
