//! Scenes for tests and probes.

use common::hard::{Disc, Scene};

/// A tower: each disc flies into the one above, across every cut; the lowest by 44 / `slow`.
pub(super) fn tower(slow: f64) -> Scene {
    let disc = |k: u32| Disc::new(50.0, 2.2 * f64::from(k) + 1.0, 0.0, f64::from(44 - k) / slow);
    Scene::new(100.0, 1.0, (0..45).map(disc).collect()).expect("all are inside")
}

/// A chain of discs along the middle of a square, to and fro across it; each flies into the one ahead of it, and nearly all
/// meet at the same time, the first two first. So what happens to a disc depends on the one behind it, and the middle cuts
/// the chain at every other disc.
pub(super) fn zigzag(slow: f64) -> Scene {
    let disc = |k: u32| {
        let (i, up) = (f64::from(k), [-1.5, 0.0, 1.5, 0.0][k as usize % 4]);
        Disc::new(5.0 + 1.61 * i + 5e-5 * i * i, 200.0 + up + 1e-4 * i, (240.0 - i) / slow, 0.0)
    };
    Scene::new(400.0, 1.0, (0..240).map(disc).collect()).expect("all are inside")
}
