//! Hard discs, timed: so thin a gas that a disc meets about one other in 50 steps. Rounding grows
//! a hundredfold in each collision; here it stays small, and results can be compared.

use common::hard::{Disc, RandomScene};

use crate::{Order, variants};

/// Carries out an order.
pub fn run(order: &Order) -> Vec<f64> {
    let all = if order.serial { variants::SERIAL } else { variants::LAB };
    let variant = all.iter().find(|variant| variant.name == order.variant);
    let variant = variant.unwrap_or_else(|| panic!("there is no variant {}", order.variant));
    let config = variant.config().with_threads(order.threads);
    let mut engine = (variant.build)(&config).expect("it can be built here");
    let side = 20.0 * (order.n as f64).sqrt();
    let scene = RandomScene::new(order.n, side, 1.0, order.seed).with_speeds(0.5, 1.5);
    let scene = scene.draw().expect("the scene is sound");
    engine.load(&scene);
    for _ in 0..order.steps {
        engine.step();
    }
    let mut discs = vec![Disc::default(); scene.len()];
    engine.read(0, &mut discs);
    discs.iter().flat_map(|d| [d.x, d.y, d.vx, d.vy]).collect()
}
