//! What one step of a program must do, by the oracle: its model takes the official step, and its exact
//! motion is near to what every better method finds where a step is short for what happens in it.

use common::soft::{CUTOFF, DT, Particle, Scene};
use oracle::Model;
use oracle::reference::{Fineness, exact};

/// How a variant goes through time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Method {
    /// The official step.
    Official,
    /// The official step with distances in single precision.
    SinglePrecision,
    /// Nearer to the exact motion than the official step.
    Better,
}

/// Where a particle should be after a step, and the sum of |a_ij| that acted on it.
pub(super) type Expected = (Particle, f64);

/// How far a program may be off after a step: |Δx| ≤ position · (1 + 100 dt² |a|), and the velocity
/// alike; and by how much of what the force does in a step.
#[derive(Clone, Copy, Debug)]
pub(super) struct Allowed {
    pub(super) position: f64,
    pub(super) velocity: f64,
    pub(super) of_force: f64,
}

impl Method {
    /// That of a variant; a lab that does not choose takes the official step.
    pub(super) fn of(variant: &str) -> Self {
        match variant {
            "mixed" => Self::SinglePrecision,
            "substep" | "velocity-verlet" | "pefrl" | "rk4" | "rk4-located" => Self::Better,
            _ => Self::Official,
        }
    }

    /// What rounding may do, and the method.
    pub(super) fn allowed(self) -> Allowed {
        match self {
            Self::Official => Allowed { position: 1e-13, velocity: 1e-12, of_force: 0.0 },
            // Seven digits of a cutoff, and a force whose slope is a million.
            Self::SinglePrecision => Allowed { position: 3e-7, velocity: 3e-4, of_force: 0.0 },
            // A contact that ends just after the start of a step may act for half of it.
            Self::Better => Allowed { position: 1e-9, velocity: 1e-6, of_force: 0.55 },
        }
    }

    /// Where one step goes, in id order; none for particles of which it cannot be said.
    pub(super) fn step(self, size: f64, before: &[Particle]) -> Vec<Option<Expected>> {
        let (official, magnitudes) = modelled(size, before);
        let expected = match self {
            // Seven digits of a position are few where the force is steep.
            Self::SinglePrecision if magnitudes.iter().any(|a| steep(*a)) => None,
            Self::Better => better(size, before, &magnitudes),
            _ => Some(official.into_iter().zip(magnitudes).map(Some).collect()),
        };
        expected.unwrap_or_else(|| vec![None; before.len()])
    }
}

/// The model's step, and for each particle the sum of |a_ij|.
fn modelled(size: f64, before: &[Particle]) -> (Vec<Particle>, Vec<f64>) {
    let mut model = Model::from_state(size, before.to_vec());
    model.step();
    (model.particles, model.magnitudes)
}

fn steep(a: f64) -> bool {
    DT * DT * a > 0.1 * CUTOFF
}

/// The exact motion for a step, where there is one that a step of this length can be near to.
fn better(size: f64, before: &[Particle], at_start: &[f64]) -> Option<Vec<Option<Expected>>> {
    let way = |p: &Particle| p.vx.hypot(p.vy) * DT;
    // No events are followed of particles that cross the box in a step.
    if before.iter().any(|p| way(p) > 2.0 * CUTOFF) || at_start.iter().any(|a| steep(*a)) {
        return None;
    }
    let scene = Scene::new(size, before.to_vec()).ok()?;
    let after = exact(&scene, DT, Fineness { window: DT, tolerance: 1e-12 }).ok()?;
    let (_, at_end) = modelled(size, &after);
    let all = before.iter().zip(after).zip(at_start.iter().zip(at_end));
    let expected = all.map(|((before, after), (a, b))| {
        let fast = way(before).max(way(&after)) > 0.1 * CUTOFF;
        (!fast && !steep(b)).then_some((after, a.max(b)))
    });
    Some(expected.collect())
}
