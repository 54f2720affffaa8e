//! The expected step of a program, according to the oracle.
//!
//! The oracle's model takes the official step. The oracle's exact motion is close to the step of
//! every better method if the step is short compared with the events during it.

use common::soft::{CUTOFF, DT, Particle, Scene};
use oracle::Model;
use oracle::reference::{Fineness, exact};

/// The integration method of a variant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Method {
    /// The official step.
    Official,
    /// The official step with distances in single precision.
    SinglePrecision,
    /// A step that is closer to the exact motion than the official step.
    Better,
}

/// A particle at the end of a step, and the sum of |a_ij| that acted on it.
pub(super) type Expected = (Particle, f64);

/// Greatest error of a step: |Δx| ≤ position · (1 + 100 dt² |a|), and likewise for the velocity.
///
/// A share of the effect of the force is added to both bounds.
#[derive(Clone, Copy, Debug)]
pub(super) struct Allowed {
    position: f64,
    velocity: f64,
    of_force: f64,
}

impl Method {
    /// Returns the method of a variant. An unknown variant takes the official step.
    pub(super) fn of(variant: &str) -> Self {
        match variant {
            "mixed" => Self::SinglePrecision,
            "substep" | "velocity-verlet" | "pefrl" | "rk4" | "rk4-located" => Self::Better,
            _ => Self::Official,
        }
    }

    /// Returns the error that rounding and the method may cause.
    pub(super) fn allowed(self) -> Allowed {
        match self {
            Self::Official => Allowed { position: 1e-13, velocity: 1e-12, of_force: 0.0 },
            // A position has seven correct digits, and the slope of the force is up to a million.
            Self::SinglePrecision => Allowed { position: 3e-7, velocity: 3e-4, of_force: 0.0 },
            // A contact that ends just after the start of a step may act for half of the step.
            Self::Better => Allowed { position: 1e-9, velocity: 1e-6, of_force: 0.55 },
        }
    }

    /// Returns the expected state of each particle after one step, in id order; `None` for
    /// particles whose state cannot be predicted.
    pub(super) fn step(self, size: f64, before: &[Particle]) -> Vec<Option<Expected>> {
        let (official, magnitudes) = modelled(size, before);
        let expected = match self {
            // A position in single precision has seven digits: too few to determine a steep force.
            Self::SinglePrecision if magnitudes.iter().any(|a| steep(*a)) => None,
            Self::Better => better(size, before, &magnitudes),
            _ => Some(official.into_iter().zip(magnitudes).map(Some).collect()),
        };
        expected.unwrap_or_else(|| vec![None; before.len()])
    }
}

impl Allowed {
    /// Returns the greater error of the two coordinates; `None` if the error is not allowed.
    ///
    /// `a` is the sum of |a_ij|.
    pub(super) fn distance(
        self,
        size: f64,
        found: &Particle,
        expected: &Particle,
        a: f64,
    ) -> Option<f64> {
        let speed = expected.vx.abs().max(expected.vy.abs()) + DT * a;
        // Allows for the rounding errors of a long path and of a coordinate far from the corner.
        let digits = 1e-15 * (size + DT * speed);
        let [shift, change] = [DT * DT * a, DT * a];
        let position = self.position * (1.0 + 100.0 * shift) + digits + self.of_force * shift;
        let velocity = self.velocity * (1.0 + change) + 1e-15 * speed + digits / CUTOFF;
        let velocity = velocity + self.of_force * change;
        let mut worst: f64 = 0.0;
        for (x, v, x_there, v_there) in [
            (found.x, found.vx, expected.x, expected.vx),
            (found.y, found.vy, expected.y, expected.vy),
        ] {
            let off = (x - x_there).abs();
            // A particle that ends on a wall may have been reflected already or not.
            let at_wall = x_there <= position || size - x_there <= position;
            let turned = at_wall && (v + v_there).abs() <= velocity;
            if off > position || ((v - v_there).abs() > velocity && !turned) {
                return None;
            }
            worst = worst.max(off);
        }
        Some(worst)
    }
}

/// Returns the model's step, and for each particle the sum of |a_ij|.
fn modelled(size: f64, before: &[Particle]) -> (Vec<Particle>, Vec<f64>) {
    let mut model = Model::from_state(size, before.to_vec());
    model.step();
    (model.particles, model.magnitudes)
}

fn steep(a: f64) -> bool {
    DT * DT * a > 0.1 * CUTOFF
}

/// Returns the distance that a particle flies in a step.
fn way(p: &Particle) -> f64 {
    p.vx.hypot(p.vy) * DT
}

/// Returns the exact motion for a step; `None` if no method with steps of this length can be close
/// to it.
fn better(size: f64, before: &[Particle], at_start: &[f64]) -> Option<Vec<Option<Expected>>> {
    // The exact motion does not follow the events of particles that cross the box in a step.
    if before.iter().any(|p| way(p) > 2.0 * CUTOFF) || at_start.iter().any(|a| steep(*a)) {
        return None;
    }
    let scene = Scene::new(size, before.to_vec()).ok()?;
    let after = exact(&scene, DT, Fineness { window: DT, tolerance: 1e-12 }).ok()?;
    let (_, at_end) = modelled(size, &after);
    let mut expected = Vec::new();
    for (id, after) in after.into_iter().enumerate() {
        let fast = way(&before[id]).max(way(&after)) > 0.1 * CUTOFF;
        let known = !fast && !steep(at_end[id]);
        expected.push(known.then_some((after, at_start[id].max(at_end[id]))));
    }
    Some(expected)
}
