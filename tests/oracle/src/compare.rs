//! One step of a program against one step of the model.

use common::soft::{DT, Particle};

use crate::Model;
use crate::diagnosis::Mistake;

/// How far a correct program may be off after one step, per unit of what the step did.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    /// |Δx| ≤ place · (1 + 100 dt² |a|).
    pub place: f64,
    /// |Δv| ≤ velocity · (1 + dt |a|).
    pub velocity: f64,
}

impl Default for Limits {
    /// Double precision: correct programs stay below 1e-16.
    fn default() -> Self {
        Self { place: 1e-13, velocity: 1e-12 }
    }
}

/// Compares `after`, where a program went in one step from `before`, with the model's step from
/// there. Returns the first particle that is off, explained.
pub(crate) fn one_step(
    size: f64,
    before: &[Particle],
    after: &[Particle],
    limits: Limits,
) -> Result<(), Box<Mistake>> {
    let mut model = Model::from_state(size, before.to_vec());
    model.step();
    for (id, (found, expected)) in after.iter().zip(&model.particles).enumerate() {
        // The sum of magnitudes bounds |a| and, in a crowd where forces cancel, what rounding
        // in another order of summation can do.
        let a = model.magnitudes[id];
        let place = limits.place * (1.0 + 100.0 * DT * DT * a);
        let velocity = limits.velocity * (1.0 + DT * a);
        let near = |found: f64, expected: f64, limit: f64| (found - expected).abs() <= limit;
        let sound = found.id as usize == id
            && near(found.x, expected.x, place)
            && near(found.y, expected.y, place)
            && near(found.vx, expected.vx, velocity)
            && near(found.vy, expected.vy, velocity);
        if !sound {
            return Err(Box::new(Mistake::explain(&model, before, *found, id)));
        }
    }
    Ok(())
}
