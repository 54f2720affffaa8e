//! Soft discs, timed: the official scene of a seed that was not known before.

use common::soft::{Averages, Particle, Scene};

use crate::{Done, Order, variants};

/// Carries out an order.
pub fn run(order: &Order) -> Done {
    let all = if order.serial { variants::SERIAL } else { variants::LAB };
    let variant = all.iter().find(|variant| variant.name == order.variant);
    let variant = variant.unwrap_or_else(|| panic!("there is no variant {}", order.variant));
    let mut config = variant.config().with_threads(order.threads);
    config.statistics = order.count;
    let mut engine = (variant.build)(&config).expect("it can be built here");
    let scene = Scene::official(order.n, order.seed).expect("the official scene is sound");
    engine.load(&scene);
    let mut counted = Vec::new();
    if order.count {
        let mut seen = Vec::new();
        for _ in 0..order.steps {
            engine.step();
            seen.extend(engine.statistics());
        }
        let average = Averages::of(scene.len(), &seen);
        let average =
            average.map(|a| ("pair tests per particle and step".to_owned(), a.pair_tests));
        counted.extend(average);
        counted.extend(engine.counters().into_iter().map(|(name, value)| (name.to_owned(), value)));
    } else {
        engine.run(order.steps);
    }
    let mut particles = vec![Particle::default(); scene.len()];
    engine.read(0, &mut particles);
    Done { state: particles.iter().flat_map(|p| [p.x, p.y, p.vx, p.vy]).collect(), counted }
}
