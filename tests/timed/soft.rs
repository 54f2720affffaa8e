//! Soft discs, timed: the official scene of a seed that was not known before.

use common::soft::{Particle, Scene};

use crate::{Order, variants};

/// Carries out an order.
pub fn run(order: &Order) -> Vec<f64> {
    let all = if order.serial { variants::SERIAL } else { variants::LAB };
    let variant = all.iter().find(|variant| variant.name == order.variant);
    let variant = variant.unwrap_or_else(|| panic!("there is no variant {}", order.variant));
    let config = variant.config().with_threads(order.threads);
    let mut engine = (variant.build)(&config).expect("it can be built here");
    let scene = Scene::official(order.n, order.seed).expect("the official scene is sound");
    engine.load(&scene);
    engine.run(order.steps);
    let mut particles = vec![Particle::default(); scene.len()];
    engine.read(0, &mut particles);
    particles.iter().flat_map(|p| [p.x, p.y, p.vx, p.vy]).collect()
}
