//! Timed soft discs: the official scene with a seed that was not known before.

use common::Variant;
use common::soft::{Particle, Scene, Simulation};

use crate::Order;

/// Executes an order with one of the programs. `None` if the order is for a different program.
pub fn run(order: &Order, programs: &[Variant<dyn Simulation>]) -> Option<Vec<f64>> {
    let variant = programs.iter().find(|variant| variant.name == order.variant)?;
    let config = variant.config().with_threads(order.threads);
    let mut engine = (variant.build)(&config).expect("it can be built here");
    let scene = Scene::official(order.n, order.seed).expect("the official scene is sound");
    engine.load(&scene);
    engine.run(order.steps);
    let mut particles = vec![Particle::default(); scene.len()];
    engine.read(0, &mut particles);
    Some(particles.iter().flat_map(|p| [p.x, p.y, p.vx, p.vy]).collect())
}
