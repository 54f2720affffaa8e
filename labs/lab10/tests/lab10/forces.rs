//! Questions about the forces of the engine, task 10.6.

use common::soft::{NoStatistics, Scene, Simulation};
use lab10::Engine;
use neighbour_list_core::AnyProcessor;
use oracle::{Ask, Near, Random, acceleration_of_pair};

use super::scenes::Case;

/// Computes forces without particles, so that an unsolved starter stops at the `todo!` of task
/// 10.6.
pub(crate) fn no_forces() {
    Engine::<NoStatistics>::new(1.0, true).accelerate();
}

/// Asks for the accelerations of any scene, computed twice.
pub(crate) fn accelerations(random: &mut Random, ask: &mut impl Ask) {
    no_forces();
    for case in Case::drawn(random) {
        let mut engine = Engine::<NoStatistics>::new(case.skin, true);
        engine.load(&case.scene);
        engine.rebuild(AnyProcessor);
        engine.rebuild_inner();
        for round in ["once", "once more"] {
            engine.accelerate();
            let question = format!(
                "{}, computed {round}: the accelerations along x in the order of ids, then the accelerations along y",
                case.name()
            );
            ask.near(&question, || by_number(&engine), || sums(&case.scene));
        }
        engine.inner.pairs.clear();
        engine.accelerate();
        let question = format!("{}, no pair in the inner list: the accelerations", case.name());
        ask.exact(&question, || by_number(&engine), || vec![0.0; 2 * case.scene.len()]);
    }
}

/// Returns the accelerations along x by the particles' ids, followed by the accelerations along y.
fn by_number(engine: &Engine<NoStatistics>) -> Vec<f64> {
    let n = engine.bodies.len();
    if engine.ax.len() != n || engine.ay.len() != n {
        return [&engine.ax[..], &engine.ay].concat();
    }
    let mut numbers = vec![0.0; 2 * n];
    for (place, &id) in engine.bodies.id.iter().enumerate() {
        numbers[id as usize] = engine.ax[place];
        numbers[n + id as usize] = engine.ay[place];
    }
    numbers
}

fn sums(scene: &Scene) -> Vec<Near> {
    let n = scene.len();
    let mut sums = vec![Near { right: 0.0, scale: 0.0 }; 2 * n];
    for (i, p) in scene.particles().iter().enumerate() {
        for q in scene.particles().iter().filter(|q| q.id != p.id) {
            let d = p.to(q);
            let a = acceleration_of_pair(d.x, d.y);
            for (k, a) in [(i, a.x), (n + i, a.y)] {
                sums[k].right += a;
                sums[k].scale += a.abs();
            }
        }
    }
    sums
}
