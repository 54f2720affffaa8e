//! Free flight: where a particle goes in a window if no other pushes it, how close two come, and how
//! far they may be off.

use common::soft::{CUTOFF, Particle};
use neighbour_list::kernels::larger;

/// The reference path of a particle during a window.
///
/// Far from walls it is the free flight: a straight line. A particle that could reach a wall has
/// no straight line; for it we only say that it stays within `spread` of where it stands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Path {
    /// Place at the start of the window.
    pub x: f64,
    /// Place at the start of the window.
    pub y: f64,
    /// Velocity of the reference.
    pub wx: f64,
    /// Velocity of the reference.
    pub wy: f64,
    /// How far free flight may be from the reference.
    pub spread: f64,
}

/// What all paths of a window share.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Span {
    /// Steps in the window.
    pub steps: u32,
    /// Length of a step.
    pub dt: f64,
    /// Side of the box.
    pub size: f64,
}

/// Advances one coordinate `x` of particles in free flight by `steps` steps of length `dt`; `v` are as
/// many velocities.
///
/// The result has the bits of step by step: each step adds `v * dt`, rounded once, to the place, and
/// that sum is rounded. But each particle is fetched from memory only once. No wall is near.
///
/// Book: chapter 11, *Free flight*.
#[inline(always)]
pub fn fly(x: &mut [f64], v: &[f64], steps: u32, dt: f64) {
    // task 11.1: free flight
    // Many side by side, in registers: of one alone each addition waits for the one before.
    const MANY: usize = 32;
    let (mut places, mut speeds) = (x.chunks_exact_mut(MANY), v.chunks_exact(MANY));
    for (x, v) in places.by_ref().zip(speeds.by_ref()) {
        let (mut now, mut displacements) = ([0.0; MANY], [0.0; MANY]);
        now.copy_from_slice(x);
        displacements.iter_mut().zip(v).for_each(|(displacement, v)| *displacement = v * dt);
        for _ in 0..steps {
            for l in 0..MANY {
                now[l] += displacements[l];
            }
        }
        x.copy_from_slice(&now);
    }
    for (x, v) in places.into_remainder().iter_mut().zip(speeds.remainder()) {
        for _ in 0..steps {
            *x += v * dt;
        }
    }
    // end 11.1
}

/// The square of the least distance between two points within time `span`: they are (`dx`, `dy`)
/// apart at its beginning, and the second moves with velocity (`wx`, `wy`) as seen by the first.
///
/// - The distance vector at time t is d + t w. Its length is least at t = −(d·w) / (w·w).
/// - That may be before the beginning or after the end: t is clamped to 0 ..= `span`.
/// - Two points that move alike have w = 0 and t = 0/0 = NaN; their distance is |d| at any time.
///   `larger(t, 0.0)` is 0 if t is NaN: there needs to be no branch.
///
/// Book: chapter 11, *Which particles could meet*.
#[inline(always)]
pub fn closest_squared(dx: f64, dy: f64, wx: f64, wy: f64, span: f64) -> f64 {
    // task 11.2: the closest approach of two paths
    let t = -(dx * wx + dy * wy) / (wx * wx + wy * wy);
    let t = larger(t, 0.0);
    let t = if t < span { t } else { span };
    let (x, y) = (dx + t * wx, dy + t * wy);
    x * x + y * y
    // end 11.2
}

/// Whether a particle with this `deviation` from its free flight, in units of length, may have come
/// within the cutoff of a particle that the search did not list for it.
///
/// The search listed all pairs whose free flights come within cutoff + `margin`. The other particle of
/// an unlisted pair may be off its path, too, by as much at most: this is asked of the one that is off
/// by more.
///
/// Book: chapter 11, *A margin that is checked*.
#[inline(always)]
pub fn too_far_off(deviation: f64, margin: f64) -> bool {
    // task 11.4: whether the margin held
    2.0 * deviation > margin
    // end 11.4
}

impl Span {
    /// Time from the first forces of the window to the last.
    pub fn forces(&self) -> f64 {
        f64::from(self.steps - 1) * self.dt
    }

    /// Time from the start of the window to its end.
    pub fn whole(&self) -> f64 {
        f64::from(self.steps) * self.dt
    }

    /// More than the sum of roundings of a place in the window.
    pub fn rounding(&self) -> f64 {
        1e-9 * CUTOFF + 2.0 * f64::from(self.steps + 4) * f64::EPSILON * self.size
    }

    /// Whether the free flight from (`x`, `y`) with velocity (`vx`, `vy`) may touch a wall, at 0 or at
    /// `size`, before the window ends: then the particle is computed step by step.
    ///
    /// What counts is where it would be at the end of the window, not where it is now; a particle
    /// that ends within [`Span::rounding`] of a wall counts too, and so does a place that is no number.
    ///
    /// Book: chapter 11, *Walls out of reach*.
    #[inline(always)]
    pub fn meets_wall(&self, x: f64, y: f64, vx: f64, vy: f64) -> bool {
        // task 11.5: walls within the window
        let (end_x, end_y) = (x + vx * self.whole(), y + vy * self.whole());
        let (least, most) = (self.rounding(), self.size - self.rounding());
        // Not the other way round: a number that is NaN meets the wall.
        !((end_x >= least) & (end_x <= most) & (end_y >= least) & (end_y <= most))
        // end 11.5
    }

    /// The reference path of a particle.
    pub fn path(&self, p: &Particle) -> Path {
        if self.meets_wall(p.x, p.y, p.vx, p.vy) {
            // A reflection brings two points closer or leaves them as far apart as they were, so
            // no particle ends further from its start than it flies.
            let spread = p.vx.hypot(p.vy) * self.whole() * (1.0 + 1e-9) + self.rounding();
            Path { x: p.x, y: p.y, wx: 0.0, wy: 0.0, spread }
        } else {
            Path { x: p.x, y: p.y, wx: p.vx, wy: p.vy, spread: 0.0 }
        }
    }
}

impl Path {
    /// Whether two particles could touch within time `span`, if each of them leaves its reference
    /// by no more than its spread and both together by `slack` beyond.
    pub fn may_touch(&self, other: &Self, span: f64, slack: f64) -> bool {
        let (dx, dy) = (other.x - self.x, other.y - self.y);
        let reach = CUTOFF + self.spread + other.spread + slack;
        closest_squared(dx, dy, other.wx - self.wx, other.wy - self.wy, span) <= reach * reach
    }
}
