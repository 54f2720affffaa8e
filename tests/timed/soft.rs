//! Timed soft discs: a scene of the contest, such as the official scene, with a seed that was not
//! known before.

use common::Variant;
use common::soft::{Particle, Simulation};
use oracle::contest::Kind;

use crate::Order;

/// Executes an order with one of the programs. The program may `begin` as soon as the scene is made.
///
/// Returns `None` if the order is for a different program.
pub fn run(
    order: &Order,
    programs: &[Variant<dyn Simulation>],
    begin: &dyn Fn(),
) -> Option<Vec<f64>> {
    let variant = programs.iter().find(|variant| variant.name == order.variant)?;
    let kind = Kind::ALL.into_iter().find(|kind| kind.name() == order.kind)?;
    let scene = kind.scene(order.n as usize, order.seed);
    begin();
    let config = variant.config().with_threads(order.threads);
    let mut engine = (variant.build)(&config).expect("it can be built here");
    engine.load(&scene);
    engine.run(order.steps);
    let mut particles = vec![Particle::default(); scene.len()];
    engine.read(0, &mut particles);
    Some(particles.iter().flat_map(|p| [p.x, p.y, p.vx, p.vy]).collect())
}
