//! Timed hard discs, in a gas so sparse that a disc meets about one other disc in 50 steps.
//! Rounding errors grow a hundredfold in each collision; here they stay small, so results can be
//! compared.

use common::Variant;
use common::hard::{Disc, RandomScene, Simulation};

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
    let side = 20.0 * (order.n as f64).sqrt();
    let scene = RandomScene::new(order.n, side, 1.0, order.seed).with_speeds(0.5, 1.5);
    let scene = scene.draw().expect("the scene is sound");
    begin();
    let config = variant.config().with_threads(order.threads);
    let mut engine = (variant.build)(&config).expect("it can be built here");
    engine.load(&scene);
    for _ in 0..order.steps {
        engine.step();
    }
    let mut discs = vec![Disc::default(); scene.len()];
    engine.read(0, &mut discs);
    Some(discs.iter().flat_map(|d| [d.x, d.y, d.vx, d.vy]).collect())
}
