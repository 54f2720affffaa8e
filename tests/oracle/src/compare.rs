//! Comparison of one step of a program with one step of the model.

use common::soft::Particle;

use crate::Model;
use crate::allowed::Allowed;
use crate::diagnosis::Mistake;
use crate::single::Single;

/// Compares `after`, a program's state one step after `before`, with the model's step from
/// `before`. `single` is `None` for a program in double precision. Returns an explanation of the
/// first wrong particle.
pub(crate) fn one_step(
    size: f64,
    before: &[Particle],
    after: &[Particle],
    single: Option<Single>,
) -> Result<(), Box<Mistake>> {
    let mut model = Model::from_state(size, before.to_vec());
    model.step();
    for (id, (found, expected)) in after.iter().zip(&model.particles).enumerate() {
        // The sum of magnitudes bounds |a|. In a crowd where forces cancel, the sum also bounds the
        // rounding errors of a different order of summation.
        let a = model.magnitudes[id];
        let allowed = match single {
            None => Allowed::in_double(a),
            Some(single) => single.allowed(before, expected, a),
        };
        let near = |found: f64, expected: f64, limit: f64| (found - expected).abs() <= limit;
        let along = |(x, v): (f64, f64), (expected_x, expected_v): (f64, f64)| {
            // Next to a wall, rounding may have decided whether the particle bounced.
            let at_wall = single.is_some()
                && (expected_x <= allowed.position || expected_x >= size - allowed.position);
            near(x, expected_x, allowed.position)
                && (near(v, expected_v, allowed.velocity)
                    || at_wall && near(-v, expected_v, allowed.velocity))
        };
        let sound = found.id as usize == id
            && along((found.x, found.vx), (expected.x, expected.vx))
            && along((found.y, found.vy), (expected.y, expected.vy));
        if !sound {
            return Err(Box::new(Mistake::explain(&model, before, *found, id)));
        }
    }
    Ok(())
}
