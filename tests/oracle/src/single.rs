//! The greatest error of one correct step in single precision.
//!
//! The check starts the model from the program's own state before every step, so errors of earlier
//! steps do not count. Only the roundings of one step remain. The bounds below are of first order
//! in u = 2⁻²⁴, the greatest relative error of a single rounding.
//!
//! *The vector of a pair* is (bins between + (offset − offset)) · side. The difference of two
//! offsets below 1 has the error u. With bins of side h, the sum adds u |d| / h. The rounded side
//! and the product add u |d| each. So the vector is off by |δ| ≤ u (√2 h + 3 r).
//!
//! *The force* is f(r) = (c/r − 1) r / (ρ² m) with ρ = max(r, min_r). It changes by at most 2c /
//! (ρ³ m) for each unit of length, so an error of the vector is multiplied by this factor. The
//! computation of f also rounds. WGSL allows a division an error of 2.5 units in the last place (5
//! u), and a root 4.5 units (9 u). Then the relative error of r is 10.5 u, and of c/r 17 u, with
//! the rounded c. The digits of 1 − c/r cancel, so its error is 17 u · c/r. The rest, two divisions
//! and a product, adds 16 u |f|:
//!
//! e = u (2c / (ρ³ m) · (√2 h + 3 r) + 17 c r / (ρ³ m) + 16 |f|)
//!
//! *The sum* of k forces adds k u Σ|f|. *The velocity* v + a dt is then off by
//! δv = dt (Σe + k u Σ|f|) + 3 u dt Σ|f| + u |v|.
//!
//! *The position* has several errors. The first is 8 u for v dt / h. The reflections, which remove
//! whole ways from wall to wall and back, add at most 7 u, and the addition to the offset adds u.
//! The offset itself, its floor and its mirror images add 4 u h. The sum is dt δv + 16 u dt |v| + 4
//! u h.
//!
//! Terms in u² are below a hundredth of these bounds, even at min_r. So the bounds are increased by
//! a hundredth.

use common::soft::{CUTOFF, DT, MASS, MIN_R, Particle};

use crate::allowed::Allowed;

/// Greatest relative error of a single rounding.
const U: f64 = f32::EPSILON as f64 / 2.0;

/// A program in single precision whose positions are offsets in bins of side `side`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Single {
    pub(crate) side: f64,
}

impl Single {
    /// Returns the allowed errors of a step to `end`, if all particles were at `before`. `forces`
    /// is Σ|f|.
    pub(crate) fn allowed(self, before: &[Particle], end: &Particle, forces: f64) -> Allowed {
        let own = before[end.id as usize];
        let (mut errors, mut count) = (0.0, 0.0);
        for other in before.iter().filter(|other| other.id != own.id) {
            let r = (other.x - own.x).hypot(other.y - own.y);
            // Rounding may make particles neighbours that are slightly further apart than the
            // cutoff.
            if r <= CUTOFF + U * (2.0 * self.side + 8.0 * CUTOFF) {
                errors += self.error_of_pair(r);
                count += 1.0;
            }
        }
        let speed = end.vx.hypot(end.vy);
        let velocity = DT * (errors + (count + 3.0) * U * forces) + U * speed;
        let position = DT * velocity + U * (16.0 * DT * speed + 4.0 * self.side);
        Allowed { position: 1.01 * position, velocity: 1.01 * velocity }
    }

    fn error_of_pair(self, r: f64) -> f64 {
        let least = r.max(MIN_R);
        let stiffness = CUTOFF / (least * least * least * MASS);
        let force = (CUTOFF / least - 1.0).abs() * r / (least * least * MASS);
        let vector = 2.0_f64.sqrt() * self.side + 3.0 * r;
        U * (2.0 * stiffness * vector + 17.0 * stiffness * r + 16.0 * force)
    }

    /// Returns whether `loaded` is `given`, rounded.
    pub(crate) fn is_rounded(self, loaded: &Particle, given: &Particle) -> bool {
        let near = |found: f64, given: f64, limit: f64| (found - given).abs() <= limit;
        loaded.id == given.id
            && near(loaded.x, given.x, U * self.side)
            && near(loaded.y, given.y, U * self.side)
            && near(loaded.vx, given.vx, U * given.vx.abs())
            && near(loaded.vy, given.vy, U * given.vy.abs())
    }
}
